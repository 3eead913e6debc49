// hgp/gzip: decompresses gzip files as this package does, all members with their checksums, for programs that
// look at a file before it is loaded. Takes the streaming decoder of fflate.

export { readMembers, type Gunzip, type HowToUnpack } from './lib/gzip_members.js';

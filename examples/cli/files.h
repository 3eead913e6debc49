// File input and output that never leaves incomplete files.  Role: the only access of the command line to
// the file system.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hgp/io/document.h"

namespace hgp::cli {

/// Reads a whole file, "-" for standard input; gzip (with any number of members) is decompressed while it is
/// read. Fails with kMalformed (cannot be read) or kLimit. `notes` receives notes for users.
Result<io::Bytes> readFile(const std::string& path, std::uint64_t maxBytes, Notes* notes = nullptr);

/// A document's files: the main one, and a resolver restricted to files inside `root` ("" = the
/// folder of `path`) after symbolic links have been followed.
Result<io::FileSet> openFiles(const std::string& path, const std::string& format,
                              const std::string& root, std::uint64_t maxBytes);

/// Writes all files under temporary names in the same folder, then renames them, side files first. "-" as the main
/// name means standard output. An interruption leaves no incomplete file. Devices and pipes are written to
/// directly; symbolic links are kept, and their targets replaced.
Status writeFiles(const std::string& path, const std::vector<io::OutputFile>& files);
/// Fails if writeFiles cannot take so many files.
Status checkFileCount(std::size_t count);
/// Fails as writeFiles would where the place cannot be written to: finds it out before the work is done.
Status checkWritable(const std::string& path);
/// The canonical path of a file's folder; the current folder for "-".
std::string folderOf(const std::string& path);
Status writeText(const std::string& path, std::string_view text);

/// True if both names denote the same regular file, which need not exist. "" and "-" denote none.
bool isSameFile(const std::string& a, const std::string& b);

}  // namespace hgp::cli

// Files for a program that must never leave half of one behind.  Role: the command line's only door to
// the file system.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hgp/io/document.h"

namespace hgp::cli {

/// The whole file, "-" for standard input; gzip (of any number of members) is unpacked while it is
/// read. Fails with kMalformed (cannot be read) or kLimit. `notes` takes what a person should know.
Result<io::Bytes> readFile(const std::string& path, std::uint64_t maxBytes,
                           std::vector<std::string>* notes = nullptr);

/// A document's files: the main one, and a resolver that sees nothing outside `root` ("" = the
/// folder of `path`), symbolic links followed.
Result<io::FileSet> openFiles(const std::string& path, const std::string& format,
                              const std::string& root, std::uint64_t maxBytes);

/// Writes all files beside their final names, then renames them, side files first. "-" as the main
/// name means standard output. An interruption leaves no half file. Devices and pipes are written to
/// and stay what they are; symbolic links stay links.
Status writeFiles(const std::string& path, const std::vector<io::OutputFile>& files);
/// The folder of a file, as one name whatever led to it; the current one for "-".
std::string folderOf(const std::string& path);
Status writeText(const std::string& path, std::string_view text);

/// True when both names mean one regular file, there already or not. "" and "-" mean none.
bool isSameFile(const std::string& a, const std::string& b);

}  // namespace hgp::cli

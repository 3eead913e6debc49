// Files that are written completely or not at all.  Role: leaves nothing incomplete after an interruption or on a
// full disk, in ISO C++ only.
#pragma once

#include <csignal>
#include <cstdio>
#include <string>

#include "hgp/io/document.h"

namespace hgp::cli {

/// Makes SIGINT, SIGTERM and SIGHUP end the program with exit code 130 and without incomplete files; a closed
/// pipe and a file size limit become write errors.
void handleInterrupts();

/// Delays interruptions during its lifetime, because the renames of one result belong together.
class SignalBlock {
 public:
  SignalBlock();
  ~SignalBlock();
  SignalBlock(const SignalBlock&) = delete;
  SignalBlock& operator=(const SignalBlock&) = delete;
};

/// Writes all bytes to an open file. If standard output is closed, the program ends silently, as by SIGPIPE.
Status writeAll(std::FILE* file, const std::string& path, io::ByteView bytes);

/// A failure with the text of errno.
Failure cannot(ErrorCode code, const char* what, const std::string& path);

/// Maximum number of half files at a time.
inline constexpr std::size_t kMaxHalfFiles = 256;

/// A file with a temporary name in the folder of its final one; removed unless `keep` renames it.
class HalfFile {
 public:
  HalfFile() = default;
  ~HalfFile();
  HalfFile(const HalfFile&) = delete;
  HalfFile& operator=(const HalfFile&) = delete;

  Status create(const std::string& path, io::ByteView bytes);
  Status keep();
  /// Call when all files of a result have been kept.
  static void forgetAll();

 private:
  std::string path_, temporary_;
};

}  // namespace hgp::cli

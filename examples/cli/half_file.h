// Files that are whole or not there.  Role: what interruptions and full disks must not leave behind, with
// nothing but ISO C++.
#pragma once

#include <csignal>
#include <cstdio>
#include <string>

#include "hgp/io/document.h"

namespace hgp::cli {

/// From now on SIGINT, SIGTERM and SIGHUP end the program with 130, without half-written files; a closed
/// pipe and a file that may not grow are errors of writing.
void handleInterrupts();

/// Interruptions wait while one lives: the renames of one result belong together.
class SignalBlock {
 public:
  SignalBlock();
  ~SignalBlock();
  SignalBlock(const SignalBlock&) = delete;
  SignalBlock& operator=(const SignalBlock&) = delete;
};

/// All bytes to an open file. At a closed standard output the program ends as by SIGPIPE, silently.
Status writeAll(std::FILE* file, const std::string& path, const io::Bytes& bytes);

/// A failure that says what errno says.
Failure cannot(ErrorCode code, const char* what, const std::string& path);

/// How many can be there at once.
inline constexpr std::size_t kMaxHalfFiles = 256;

/// A file under a temporary name beside its own; removed unless `keep` moves it to its place.
class HalfFile {
 public:
  HalfFile() = default;
  ~HalfFile();
  HalfFile(const HalfFile&) = delete;
  HalfFile& operator=(const HalfFile&) = delete;

  Status create(const std::string& path, const io::Bytes& bytes);
  Status keep();
  /// Call when all of a result are kept.
  static void forgetAll();

 private:
  std::string path_, temporary_;
};

}  // namespace hgp::cli

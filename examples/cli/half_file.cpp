#include "half_file.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <random>

#include "hgp/base/check.h"
#include "terminal.h"

namespace hgp::cli {
namespace {

constexpr int kInterrupted = 130;
constexpr int kPipeClosed = 141;  // the exit code that shells report for SIGPIPE
constexpr int kNameTries = 100;

/// Names of files being written, readable from a signal handler.
std::array<char[4096], kMaxHalfFiles> halfWritten;
volatile std::sig_atomic_t halfWrittenCount = 0;
volatile std::sig_atomic_t blockCount = 0, isInterrupted = 0;

[[noreturn]] void endInterrupted() {
  for (int i = 0; i < halfWrittenCount; ++i) std::remove(halfWritten[static_cast<std::size_t>(i)]);
  sayInSignalHandler("\nhgp: interrupted\n");
  std::_Exit(kInterrupted);
}

extern "C" void onInterrupt(int) {
  if (blockCount == 0) endInterrupted();
  isInterrupted = 1;
}

/// Ends the program silently, as is usual if the reader has closed our output.
[[noreturn]] void endOfPipe() {
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
#endif
  std::_Exit(kPipeClosed);
}

/// Six random letters and digits.
std::string anySuffix() {
  constexpr char kLetters[] = "abcdefghijklmnopqrstuvwxyz0123456789";
  static std::random_device random;
  std::string out = ".";
  for (int i = 0; i < 6; ++i) out += kLetters[random() % (sizeof kLetters - 1)];
  return out;
}

/// Creates a new file next to `path` and returns its name in `name`.
std::FILE* createBeside(const std::string& path, std::string& name) {
  for (int n = 0; n < kNameTries; ++n) {
    name = path + anySuffix();
    errno = 0;
    std::FILE* file = std::fopen(name.c_str(), "wbx");
    if (file != nullptr || errno != EEXIST) return file;
  }
  return nullptr;
}

}  // namespace

void handleInterrupts() {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
#ifdef SIGHUP
  std::signal(SIGHUP, onInterrupt);
#endif
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);
#endif
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);
#endif
}

SignalBlock::SignalBlock() { blockCount = blockCount + 1; }
SignalBlock::~SignalBlock() {
  blockCount = blockCount - 1;
  if (blockCount == 0 && isInterrupted) endInterrupted();
}

Failure cannot(ErrorCode code, const char* what, const std::string& path) {
  return {code,
          code == ErrorCode::kWriteFailed ? "write" : "read",
          formatText("cannot %s %s: %s", what, path.c_str(), std::strerror(errno)),
          {}};
}

Status writeAll(std::FILE* file, const std::string& path, io::ByteView bytes) {
  const std::size_t done = std::fwrite(bytes.data(), 1, bytes.size(), file);
  if (done == bytes.size() && std::fflush(file) == 0) return Done{};
#ifdef EPIPE
  if (errno == EPIPE && file == stdout) endOfPipe();
#endif
  return cannot(ErrorCode::kWriteFailed, "write", path);
}

Status HalfFile::create(const std::string& path, io::ByteView bytes) {
  path_ = path;
  if (path.size() + 8 > sizeof halfWritten[0] ||
      static_cast<std::size_t>(halfWrittenCount) >= halfWritten.size()) {
    errno = ENAMETOOLONG;
    return cannot(ErrorCode::kWriteFailed, "write", path);
  }
  std::FILE* file = nullptr;
  {
    SignalBlock block;
    std::string name;
    file = createBeside(path, name);
    if (file == nullptr) return cannot(ErrorCode::kWriteFailed, "write", path);
    temporary_ = name;
    std::memcpy(halfWritten[static_cast<std::size_t>(halfWrittenCount)], name.c_str(),
                name.size() + 1);
    halfWrittenCount = halfWrittenCount + 1;
  }
  std::setvbuf(file, nullptr, _IONBF, 0);
  Status done = writeAll(file, path, bytes);
  if (std::fclose(file) != 0 && done) done = cannot(ErrorCode::kWriteFailed, "write", path);
  return done;
}

Status HalfFile::keep() {
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) {
    return Failure{ErrorCode::kWriteFailed,
                   "write",
                   formatText("cannot write %s: %s", path_.c_str(), error.message().c_str()),
                   {}};
  }
  temporary_.clear();
  return Done{};
}

void HalfFile::forgetAll() { halfWrittenCount = 0; }

HalfFile::~HalfFile() {
  if (temporary_.empty()) return;
  SignalBlock block;
  std::remove(temporary_.c_str());
  const int last = halfWrittenCount - 1;
  if (last >= 0 && temporary_ == halfWritten[static_cast<std::size_t>(last)])
    halfWrittenCount = last;
}

}  // namespace hgp::cli

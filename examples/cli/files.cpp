#include "files.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "gzip.h"
#include "hgp/base/check.h"

namespace hgp::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kInterrupted = 130;
constexpr int kPipeClosed = 141;  // what a shell gives for SIGPIPE
constexpr std::size_t kChunk = std::size_t{1} << 20;
constexpr std::size_t kPackedChunk = std::size_t{1} << 16;

/// Names of half-written files, readable from a signal handler.
std::array<char[4096], 256> halfWritten;
volatile sig_atomic_t halfWrittenCount = 0;

void onInterrupt(int) {
  for (int i = 0; i < halfWrittenCount; ++i) unlink(halfWritten[static_cast<std::size_t>(i)]);
  constexpr char kText[] = "\nhgp: interrupted\n";
  const auto ignored = write(STDERR_FILENO, kText, sizeof kText - 1);
  (void)ignored;
  _exit(kInterrupted);
}

/// Signals wait while this lives: the renames of one result belong together.
class SignalBlock {
 public:
  SignalBlock() {
    sigset_t blocked;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGINT);
    sigaddset(&blocked, SIGTERM);
    sigaddset(&blocked, SIGHUP);
    sigprocmask(SIG_BLOCK, &blocked, &before_);
  }
  ~SignalBlock() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  SignalBlock(const SignalBlock&) = delete;
  SignalBlock& operator=(const SignalBlock&) = delete;

 private:
  sigset_t before_;
};

Failure cannot(ErrorCode code, const char* what, const std::string& path) {
  return {code,
          code == ErrorCode::kWriteFailed ? "write" : "read",
          formatText("cannot %s %s: %s", what, path.c_str(), std::strerror(errno)),
          {}};
}

/// What read() gives, again when a signal came between; −1 and errno otherwise.
ssize_t readSome(int file, std::uint8_t* to, std::size_t size) {
  for (;;) {
    const ssize_t got = read(file, to, size);
    if (got >= 0 || errno != EINTR) return got;
  }
}

/// The bytes of an open file as they are stored; `bytes` may hold its beginning already.
Status readPlain(int file, const std::string& path, std::uint64_t maxBytes, io::Bytes& bytes) {
  for (;;) {
    const std::size_t size = bytes.size();
    bytes.resize(std::max(std::min(bytes.capacity(), size + kChunk), size + 1));
    const ssize_t got = readSome(file, bytes.data() + size, bytes.size() - size);
    if (got < 0) return cannot(ErrorCode::kMalformed, "read", path);
    bytes.resize(size + static_cast<std::size_t>(got));
    if (got == 0) return Done{};
    if (bytes.size() > maxBytes) return tooLarge(maxBytes);
    if (bytes.capacity() == bytes.size()) bytes.reserve(2 * bytes.size());
  }
}

/// Unpacks while it reads: the packed bytes are never held, and what is too large ends early.
Status readPacked(int file, const std::string& path, std::uint64_t maxBytes, io::Bytes& bytes,
                  std::vector<std::string>* notes) {
  Gunzip gunzip(maxBytes);
  io::Bytes packed = std::move(bytes);
  bytes.clear();
  while (!packed.empty()) {
    if (Status done = gunzip.take(packed, bytes); !done) return done;
    packed.resize(kPackedChunk);
    const ssize_t got = readSome(file, packed.data(), packed.size());
    if (got < 0) return cannot(ErrorCode::kMalformed, "read", path);
    packed.resize(static_cast<std::size_t>(got));
  }
  Status done = gunzip.finish();
  if (notes != nullptr && !gunzip.note().empty()) notes->push_back(gunzip.note());
  return done;
}

Result<io::Bytes> readAll(int file, const std::string& path, std::uint64_t maxBytes,
                          std::vector<std::string>* notes) {
  io::Bytes bytes;
  struct stat status {};
  if (fstat(file, &status) == 0 && S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    return cannot(ErrorCode::kMalformed, "read", path);
  }
  while (bytes.size() < 2) {  // a pipe may hand over one byte at a time
    std::uint8_t next = 0;
    const ssize_t got = readSome(file, &next, 1);
    if (got < 0) return cannot(ErrorCode::kMalformed, "read", path);
    if (got == 0) return bytes;
    bytes.push_back(next);
  }
  const bool isPacked = bytes[0] == 0x1f && bytes[1] == 0x8b;
  if (S_ISREG(status.st_mode)) {
    if (static_cast<std::uint64_t>(status.st_size) > maxBytes) return tooLarge(maxBytes);
    if (!isPacked) bytes.reserve(static_cast<std::size_t>(status.st_size) + 1);
  }
  Status done = isPacked ? readPacked(file, path, maxBytes, bytes, notes)
                         : readPlain(file, path, maxBytes, bytes);
  if (!done) return done.error();
  return bytes;
}

/// Whoever reads our output has had enough: ends as programs do then, without a message.
[[noreturn]] void endOfPipe() {
  signal(SIGPIPE, SIG_DFL);
  raise(SIGPIPE);
  _exit(kPipeClosed);
}

Status writeAll(int file, const std::string& path, const std::uint8_t* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t done = write(file, bytes, std::min(size, std::size_t{1} << 30));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0 && errno == EPIPE && file == STDOUT_FILENO) endOfPipe();
    if (done < 0) return cannot(ErrorCode::kWriteFailed, "write", path);
    bytes += done;
    size -= static_cast<std::size_t>(done);
  }
  return Done{};
}

/// A file under a temporary name; removed unless `keep` moves it to its place.
class HalfFile {
 public:
  Status create(const std::string& path, const io::Bytes& bytes) {
    path_ = path;
    std::string name = path + ".XXXXXX";
    if (name.size() >= sizeof halfWritten[0] ||
        static_cast<std::size_t>(halfWrittenCount) >= halfWritten.size()) {
      errno = ENAMETOOLONG;
      return cannot(ErrorCode::kWriteFailed, "write", path);
    }
    int file = -1;
    {
      SignalBlock block;
      file = mkstemp(name.data());
      if (file < 0) return cannot(ErrorCode::kWriteFailed, "write", path);
      temporary_ = name;
      std::memcpy(halfWritten[static_cast<std::size_t>(halfWrittenCount)], name.c_str(),
                  name.size() + 1);
      halfWrittenCount = halfWrittenCount + 1;
    }
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(file, 0666 & ~mask);
    Status done = writeAll(file, path, bytes.data(), bytes.size());
    if (close(file) != 0 && done) done = cannot(ErrorCode::kWriteFailed, "write", path);
    return done;
  }
  Status keep() {
    if (rename(temporary_.c_str(), path_.c_str()) != 0) {
      return cannot(ErrorCode::kWriteFailed, "write", path_);
    }
    temporary_.clear();
    return Done{};
  }
  ~HalfFile() {
    if (!temporary_.empty()) unlink(temporary_.c_str());
  }
  HalfFile() = default;
  HalfFile(const HalfFile&) = delete;
  HalfFile& operator=(const HalfFile&) = delete;

 private:
  std::string path_, temporary_;
};

/// Devices, pipes and sockets are written to, never replaced by a file; so is nothing else.
bool isSpecial(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

Status writeInto(const std::string& path, const io::Bytes& bytes) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return cannot(ErrorCode::kWriteFailed, "write", path);
  Status done = writeAll(file, path, bytes.data(), bytes.size());
  if (close(file) != 0 && done) done = cannot(ErrorCode::kWriteFailed, "write", path);
  return done;
}

/// Where a symbolic link leads: the link stays, what it names is replaced.
std::string linkTarget(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}

/// A name that a file may use for its companion: relative, and not upwards.
bool isInside(const fs::path& root, const fs::path& file) {
  const fs::path relative = file.lexically_relative(root);
  return !relative.empty() && *relative.begin() != ".." && relative.is_relative();
}

}  // namespace

Result<io::Bytes> readFile(const std::string& path, std::uint64_t maxBytes,
                           std::vector<std::string>* notes) {
  const bool isStandardInput = path == "-";
  const int file = isStandardInput ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return cannot(ErrorCode::kMalformed, "open", path);
  Result<io::Bytes> bytes = readAll(file, path, maxBytes, notes);
  if (!isStandardInput) close(file);
  return bytes;
}

Result<io::FileSet> openFiles(const std::string& path, const std::string& format,
                              const std::string& root, std::uint64_t maxBytes) {
  io::FileSet files;
  Result<io::Bytes> bytes = readFile(path, maxBytes, &files.notes);
  if (!bytes) return bytes.error();
  files.name = path != "-"      ? fs::path(path).filename().string()
               : format.empty() ? "stdin"
                                : "stdin." + format;
  if (files.name.size() > 3 && files.name.substr(files.name.size() - 3) == ".gz") {
    files.name.resize(files.name.size() - 3);
  }
  files.main = std::move(*bytes);
  const fs::path folder = path == "-" ? fs::path(".") : fs::path(path).parent_path();
  const fs::path base = folder.empty() ? fs::path(".") : folder;
  const fs::path allowed = root.empty() ? base : fs::path(root);
  files.resolve = [base, allowed, maxBytes](const std::string& name) -> Result<io::Bytes> {
    std::error_code error;
    const fs::path file = fs::canonical(base / fs::path(name), error);
    if (error) {
      return Failure{ErrorCode::kMalformed, "read", name + " is missing", {}};
    }
    const fs::path top = fs::canonical(allowed, error);
    if (error || fs::path(name).is_absolute() || !isInside(top, file)) {
      return Failure{ErrorCode::kMalformed,
                     "read",
                     "this file asks for " + name + ", which is outside its folder; not loaded",
                     {}};
    }
    if (!fs::is_regular_file(file, error)) {  // a pipe would be waited for
      return Failure{ErrorCode::kMalformed, "read", name + " is not a regular file", {}};
    }
    return readFile(file.string(), maxBytes);
  };
  return files;
}

Status writeFiles(const std::string& path, const std::vector<io::OutputFile>& files) {
  if (path == "-") {
    if (files.size() != 1) {
      return Failure{ErrorCode::kUsage, "write", "several files cannot go to standard output", {}};
    }
    return writeAll(STDOUT_FILENO, "standard output", files[0].bytes.data(), files[0].bytes.size());
  }
  if (isSpecial(path)) {
    if (files.size() == 1) return writeInto(path, files[0].bytes);
    return Failure{ErrorCode::kUsage, "write", "several files cannot go to " + path, {}};
  }
  if (files.size() > halfWritten.size() / 2) {
    return Failure{ErrorCode::kLimit,
                   "write",
                   formatText("%zu side files; write a .glb, which needs none", files.size() - 1),
                   {}};
  }
  const fs::path folder = fs::path(path).parent_path();
  std::vector<HalfFile> half(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const fs::path side = folder / fs::path(files[i].name);
    const std::string name = i == 0 ? path : side.string();
    if (i > 0 && !isInside(folder.empty() ? "." : folder, folder.empty() ? "." / side : side)) {
      return Failure{ErrorCode::kWriteFailed, "write", name + " leaves the folder", {}};
    }
    std::error_code ignored;  // opening the file says what is wrong
    if (i > 0 && side.has_parent_path()) fs::create_directories(side.parent_path(), ignored);
    if (isSpecial(name)) {
      errno = EEXIST;
      return cannot(ErrorCode::kWriteFailed, "write", name);
    }
    if (Status done = half[i].create(linkTarget(name), files[i].bytes); !done) return done;
  }
  SignalBlock block;
  for (std::size_t i = files.size(); i-- > 0;) {
    if (Status done = half[i].keep(); !done) return done;
  }
  halfWrittenCount = 0;
  return Done{};
}

std::string folderOf(const std::string& path) {
  const fs::path folder = path == "-" ? fs::path() : fs::path(path).parent_path();
  std::error_code error;
  const fs::path real = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  return error ? folder.string() : real.string();
}

Status writeText(const std::string& path, std::string_view text) {
  return writeFiles(path, {{path, io::Bytes(text.begin(), text.end())}});
}

bool isSameFile(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty() || a == "-" || b == "-") return false;
  if (isSpecial(a) || isSpecial(b)) return false;  // may well be used twice
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  const auto place = [](const std::string& name) {  // of a file that need not exist
    std::error_code unknown;
    const fs::path whole = fs::absolute(name, unknown);
    return fs::weakly_canonical(whole.parent_path(), unknown) / whole.filename();
  };
  return place(a) == place(b);
}

void handleInterrupts() {
  struct sigaction action {};
  action.sa_handler = onInterrupt;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGHUP, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of write()
}

}  // namespace hgp::cli

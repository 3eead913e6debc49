#include "files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "gzip.h"
#include "half_file.h"
#include "hgp/base/check.h"
#include "outside_decoders.h"

namespace hgp::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChunk = std::size_t{1} << 20;
constexpr std::size_t kPackedChunk = std::size_t{1} << 16;

/// Reads the bytes of an open file as stored; `bytes` may already contain the beginning.
Status readPlain(std::FILE* file, const std::string& path, std::uint64_t maxBytes,
                 io::Bytes& bytes) {
  for (;;) {
    const std::size_t size = bytes.size();
    bytes.resize(std::max(std::min(bytes.capacity(), size + kChunk), size + 1));
    const std::size_t got = std::fread(bytes.data() + size, 1, bytes.size() - size, file);
    if (std::ferror(file)) return cannot(ErrorCode::kMalformed, "read", path);
    bytes.resize(size + got);
    if (got == 0) return Done{};
    if (bytes.size() > maxBytes) return tooLarge(maxBytes);
    if (bytes.capacity() == bytes.size()) bytes.reserve(2 * bytes.size());
  }
}

/// Decompresses while reading: the compressed bytes are not kept, and files that are too large fail early.
Status readPacked(std::FILE* file, const std::string& path, std::uint64_t maxBytes,
                  io::Bytes& bytes, Notes* notes) {
  Gunzip gunzip(maxBytes);
  io::Bytes packed = std::move(bytes);
  bytes.clear();
  while (!packed.empty()) {
    if (Status done = gunzip.take(packed, bytes); !done) return done;
    packed.resize(kPackedChunk);
    const std::size_t got = std::fread(packed.data(), 1, packed.size(), file);
    if (std::ferror(file)) return cannot(ErrorCode::kMalformed, "read", path);
    packed.resize(got);
  }
  Status done = gunzip.finish();
  if (const std::uint64_t ignored = gunzip.ignoredBytes(); notes != nullptr && ignored > 0)
    notes->push_back(Note("read-gzip-longer", {{"bytes", ignored}}));
  return done;
}

Result<io::Bytes> readAll(std::FILE* file, const std::string& path, std::uint64_t maxBytes,
                          Notes* notes) {
  io::Bytes bytes;
  std::error_code error;
  const bool isRegular = path != "-" && fs::is_regular_file(path, error);
  const std::uintmax_t size = isRegular ? fs::file_size(path, error) : 0;
  bytes.resize(2);
  bytes.resize(std::fread(bytes.data(), 1, 2, file));
  if (std::ferror(file)) return cannot(ErrorCode::kMalformed, "read", path);
  if (bytes.size() < 2) return bytes;
  const bool isPacked = bytes[0] == 0x1f && bytes[1] == 0x8b;
  if (isRegular && !error) {
    if (size > maxBytes) return tooLarge(maxBytes);
    if (!isPacked) bytes.reserve(static_cast<std::size_t>(size) + 1);
  }
  Status done = isPacked ? readPacked(file, path, maxBytes, bytes, notes)
                         : readPlain(file, path, maxBytes, bytes);
  if (!done) return done.error();
  return bytes;
}

/// Whether the path is a device, pipe or socket, which is written to instead of being replaced by a file.
bool isSpecial(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status);
}

Status writeInto(const std::string& path, io::ByteView bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return cannot(ErrorCode::kWriteFailed, "write", path);
  std::setvbuf(file, nullptr, _IONBF, 0);
  Status done = writeAll(file, path, bytes);
  if (std::fclose(file) != 0 && done) done = cannot(ErrorCode::kWriteFailed, "write", path);
  return done;
}

/// The target of a symbolic link, which is replaced while the link stays.
std::string linkTarget(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}

/// Whether a side file lies inside the root folder.
bool isInside(const fs::path& root, const fs::path& file) {
  const fs::path relative = file.lexically_relative(root);
  return !relative.empty() && *relative.begin() != ".." && relative.is_relative();
}

}  // namespace

Result<io::Bytes> readFile(const std::string& path, std::uint64_t maxBytes, Notes* notes) {
  const bool isStandardInput = path == "-";
  std::FILE* file = isStandardInput ? stdin : std::fopen(path.c_str(), "rb");
  if (file == nullptr) return cannot(ErrorCode::kMalformed, "open", path);
  std::setvbuf(file, nullptr, _IONBF, 0);
  Result<io::Bytes> bytes = readAll(file, path, maxBytes, notes);
  if (!isStandardInput) std::fclose(file);
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
  files.decoders = outsideDecoders();
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
                     "this file refers to " + name + ", which is outside its folder; not loaded",
                     {}};
    }
    if (!fs::is_regular_file(file, error)) {  // reading a pipe would block
      return Failure{ErrorCode::kMalformed, "read", name + " is not a regular file", {}};
    }
    return readFile(file.string(), maxBytes);
  };
  return files;
}

Status checkFileCount(std::size_t count) {
  if (count <= kMaxHalfFiles / 2) return Done{};
  return Failure{
      ErrorCode::kLimit,
      "write",
      formatText("%zu side files; --embed needs none, and neither does a .glb", count - 1),
      {}};
}

/// The name and the bytes of an output, which belong to somebody else.
struct OutputView {
  std::string name;
  io::ByteView bytes;
};

static Status writeViews(const std::string& path, const std::vector<OutputView>& files) {
  if (path == "-") {
    if (files.size() != 1) {
      return Failure{ErrorCode::kUsage, "write", "several files cannot go to standard output", {}};
    }
    return writeAll(stdout, "standard output", files[0].bytes);
  }
  if (isSpecial(path)) {
    if (files.size() == 1) return writeInto(path, files[0].bytes);
    return Failure{ErrorCode::kUsage, "write", "several files cannot go to " + path, {}};
  }
  if (Status few = checkFileCount(files.size()); !few) return few;
  const fs::path folder = fs::path(path).parent_path();
  std::vector<HalfFile> half(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const fs::path side = folder / fs::path(files[i].name);
    const std::string name = i == 0 ? path : side.string();
    if (i > 0 && !isInside(folder.empty() ? "." : folder, folder.empty() ? "." / side : side)) {
      return Failure{ErrorCode::kWriteFailed, "write", name + " leaves the folder", {}};
    }
    std::error_code ignored;  // opening the file reports errors
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
  HalfFile::forgetAll();
  return Done{};
}

Status writeFiles(const std::string& path, const std::vector<io::OutputFile>& files) {
  std::vector<OutputView> views;
  views.reserve(files.size());
  for (const io::OutputFile& file : files) views.push_back({file.name, file.bytes});
  return writeViews(path, views);
}

Status checkWritable(const std::string& path) {
  if (path.empty() || path == "-") return Done{};
  std::error_code error;
  if (fs::is_directory(path, error)) {
    errno = EISDIR;
    return cannot(ErrorCode::kWriteFailed, "write", path);
  }
  if (isSpecial(path)) return Done{};
  HalfFile probe;
  return probe.create(linkTarget(path), {});
}

std::string folderOf(const std::string& path) {
  const fs::path folder = path == "-" ? fs::path() : fs::path(path).parent_path();
  std::error_code error;
  const fs::path real = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  return error ? folder.string() : real.string();
}

Status writeText(const std::string& path, std::string_view text) {
  return writeViews(path,
                    {{path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}}});
}

bool isSameFile(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty() || a == "-" || b == "-") return false;
  if (isSpecial(a) || isSpecial(b)) return false;  // may be used twice
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  const auto place = [](const std::string& name) {  // of a file that need not exist
    std::error_code unknown;
    const fs::path whole = fs::absolute(name, unknown);
    return fs::weakly_canonical(whole.parent_path(), unknown) / whole.filename();
  };
  return place(a) == place(b);
}

}  // namespace hgp::cli

// Optional real meshes: a folder named by HGP_SHARED_MESHES, or beside the checkout.
#pragma once

#include <sys/stat.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "hgp/base/check.h"
#include "hgp/io/cone_files.h"
#include "hgp/io/document.h"
#include "hgp/parametrize/parametrize.h"

namespace hgp::test {

inline std::string corpusFolder() {
  const char* given = std::getenv("HGP_SHARED_MESHES");
  return given ? given : HGP_SHARED_MESHES_DEFAULT;
}
inline bool hasFile(const std::string& name) {
  struct stat info {};
  return stat((corpusFolder() + "/" + name).c_str(), &info) == 0;
}
/// Long runs (scripts/test --full) take everything.
inline bool isFullRun() { return std::getenv("HGP_FULL") != nullptr; }

inline io::Bytes bytesOf(const std::string& name) {
  const std::string path = corpusFolder() + "/" + name;
  const bool isPacked = path.size() > 3 && path.substr(path.size() - 3) == ".gz";
#ifdef __EMSCRIPTEN__
  HGP_CHECK(!isPacked, "packed files are read natively only");
  std::FILE* file = std::fopen(path.c_str(), "rb");
#else
  std::FILE* file =
      isPacked ? popen(("gzip -dc '" + path + "'").c_str(), "r") : std::fopen(path.c_str(), "rb");
#endif
  HGP_CHECK(file, "cannot open %s", path.c_str());
  io::Bytes bytes;
  unsigned char chunk[1 << 16];
  for (std::size_t n = 0; (n = std::fread(chunk, 1, sizeof chunk, file)) > 0;)
    bytes.insert(bytes.end(), chunk, chunk + n);
#ifndef __EMSCRIPTEN__
  isPacked ? pclose(file) : std::fclose(file);
#else
  std::fclose(file);
#endif
  return bytes;
}
inline std::string textOf(const std::string& name) {
  const io::Bytes bytes = bytesOf(name);
  return {bytes.begin(), bytes.end()};
}

inline TriMesh meshOfFile(const std::string& name) {
  io::FileSet files;
  files.name = name.size() > 3 && name.substr(name.size() - 3) == ".gz"
                   ? name.substr(0, name.size() - 3)
                   : name;
  files.main = bytesOf(name);
  Result<io::DocumentPtr> document = io::openDocument(std::move(files), {});
  HGP_CHECK(document, "%s: %s", name.c_str(), document.error().message.c_str());
  Result<TriMesh> mesh = buildTriMesh((*document)->surfaces()[0].mesh);
  HGP_CHECK(mesh, "%s: %s", name.c_str(), mesh.error().message.c_str());
  return std::move(*mesh);
}

}  // namespace hgp::test

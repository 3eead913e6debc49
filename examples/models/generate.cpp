// generate DIR [NAME …]: writes the models as OBJ files; `million` only if it is named.

#include <cstdio>
#include <filesystem>

#include "hgp/io/document.h"
#include "hgp/mesh/topology.h"
#include "models.h"

namespace {

bool generate(const std::string& folder, const std::string& name) {
  const hgp::MeshData data = hgp::models::byName(name);
  const auto mesh = hgp::buildTriMesh(data);
  if (data.triangles.empty() || !mesh) {
    std::fprintf(stderr, "generate: %s: %s\n", name.c_str(),
                 data.triangles.empty() ? "no such model" : mesh.error().message.c_str());
    return false;
  }
  const hgp::Topology topology = computeTopology(*mesh);
  std::printf("%s: %d vertices, %d triangles, genus %d, %zu boundary loops\n", name.c_str(),
              mesh->vertexCount(), mesh->faceCount(), topology.genus, topology.loops.size());
  const hgp::io::Bytes bytes = hgp::io::writePlainObj(data, {}, "hgp examples/models/generate");
  const std::string path = folder + "/" + name + ".obj";
  std::FILE* file = std::fopen(path.c_str(), "wb");
  const bool isWritten = file && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  if (!file || std::fclose(file) != 0 || !isWritten) {
    std::fprintf(stderr, "generate: cannot write %s\n", path.c_str());
    return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') {
    std::fprintf(stderr, "usage: generate DIR [NAME …]\n");
    return 2;
  }
  std::error_code ignored;  // errors are reported for each file
  std::filesystem::create_directories(argv[1], ignored);
  bool isGood = true;
  for (int i = 2; i < argc; ++i) isGood = generate(argv[1], argv[i]) && isGood;
  for (const std::string& name : hgp::models::names()) {
    if (argc == 2 && name != "million") isGood = generate(argv[1], name) && isGood;
  }
  return isGood ? 0 : 1;
}

// What the Node tests of glTF call: reads files with the library, writes a made-up map into them,
// and says what happened, one line of JSON per file.
//   gltf_probe [--max-bytes N] [--max-triangles N] FILE…
//   gltf_probe --write OUT [--map corners|vertices|patches] [--set N] [--cones TEXT] [--surface N] FILE
// Writing also reads the result back and compares; the stored uv of every corner (float32 pairs, v
// from the top) go to OUT.uv.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "hgp/base/check.h"
#include "hgp/io/document.h"
#include "hgp/io/gltf/json/json.h"

namespace {

using namespace hgp;
using namespace hgp::io;

struct Arguments {
  Limits limits;
  std::string out, map = "corners";
  int surface = 0;
  WriteOptions options;
  std::vector<std::string> files;
};

bool readFile(const std::string& name, Bytes& out) {
  std::ifstream in(name, std::ios::binary);
  if (!in) return false;
  out.assign(std::istreambuf_iterator<char>(in), {});
  return true;
}

FileSet fileSet(const std::string& name) {
  FileSet files;
  files.name = name;
  readFile(name, files.main);
  const std::string folder = name.substr(0, name.find_last_of('/') + 1);
  files.resolve = [folder](const std::string& relative) -> Result<Bytes> {
    Bytes bytes;
    if (readFile(folder + relative, bytes)) return bytes;
    return Failure{ErrorCode::kMalformed, "read", relative + " is missing", {}};
  };
  return files;
}

std::string codes(const Notes& list) {
  std::string out = "[";
  for (const Note& note : list) out += (out.size() > 1 ? "," : "") + quoteJson(note.code);
  return out + "]";
}

std::string failureText(const Failure& failure) {
  return formatText("\"ok\":false,\"exit\":%d,\"code\":\"%s\",\"message\":%s",
                    exitCode(failure.code), errorName(failure.code),
                    quoteJson(told(failure)).c_str());
}

/// A map with a known shape: every corner its own uv, one uv per vertex, or a few patches.
UvMap madeUpMap(const MeshData& mesh, const std::string& kind) {
  UvMap map;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    auto& corners = map.cornerUv.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][k])];
      const double part =
          kind == "patches" ? static_cast<double>(4 * t / mesh.triangles.size()) : 0;
      const double angle = static_cast<double>(k) * 2.0943951;
      corners[k] = static_cast<int>(map.uv.size());
      if (kind == "corners") {
        const double step = static_cast<double>(t % 1024);
        map.uv.push_back(
            {step + 0.3 * std::cos(angle), 0.001 * static_cast<double>(t) + 0.3 * std::sin(angle)});
      } else {
        map.uv.push_back({p[0] + 0.37 * p[2] + part, p[1] - 0.21 * p[2] + part});
      }
    }
  }
  return map;
}

bool isSameMap(const UvMap& a, const UvMap& b) {
  if (a.cornerUv.size() != b.cornerUv.size()) return false;
  for (std::size_t t = 0; t < a.cornerUv.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (a.uv[static_cast<std::size_t>(a.cornerUv[t][k])] !=
          b.uv[static_cast<std::size_t>(b.cornerUv[t][k])]) {
        return false;
      }
    }
  }
  return true;
}

void writeFile(const std::string& name, const void* data, std::size_t size) {
  std::ofstream(name, std::ios::binary)
      .write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
}

std::string writeAndCompare(const Document& document, const Arguments& arguments) {
  const Surface& surface = document.surfaces()[static_cast<std::size_t>(arguments.surface)];
  const UvMap map = document.asStored(arguments.surface, madeUpMap(surface.mesh, arguments.map));
  const bool isStable = isSameMap(map, document.asStored(arguments.surface, map));
  WriteOptions options = arguments.options;
  options.name = arguments.out.substr(arguments.out.find_last_of('/') + 1);
  const auto written = document.write(arguments.surface, map, options);
  if (!written) return failureText(written.error());
  const std::string folder = arguments.out.substr(0, arguments.out.find_last_of('/') + 1);
  for (const OutputFile& file : written->files) {
    writeFile(folder + file.name, file.bytes.data(), file.bytes.size());
  }
  std::vector<float> stored;
  for (const auto& corners : map.cornerUv) {
    for (int c : corners) {
      const Vec2& uv = map.uv[static_cast<std::size_t>(c)];
      stored.push_back(static_cast<float>(uv[0]));
      stored.push_back(static_cast<float>(1.0 - uv[1]));
    }
  }
  writeFile(arguments.out + ".uv", stored.data(), stored.size() * sizeof(float));

  const auto again = readGltf(fileSet(arguments.out), arguments.limits);
  if (!again) return "\"again\":1," + failureText(again.error());
  const Surface& reread = (*again)->surfaces()[static_cast<std::size_t>(arguments.surface)];
  // The set that was free is the one that now holds the map.
  int set = options.uvSet;
  bool isSameUv = false;
  for (int candidate : reread.uvSets) {
    if (isSameUv || (options.uvSet >= 0 && candidate != options.uvSet)) continue;
    const auto uv = (*again)->existingUv(arguments.surface, candidate);
    isSameUv = uv && isSameMap(*uv, map);
    if (isSameUv) set = candidate;
  }
  const auto cones = (*again)->embeddedCones(arguments.surface);
  return formatText(
      "\"ok\":true,\"set\":%d,\"stable\":%s,\"sameSurface\":%s,\"sameUv\":%s,"
      "\"xref\":%zu,\"stored\":%d,\"cones\":%s,\"notes\":%s,\"files\":%zu",
      set, isStable ? "true" : "false",
      surface.mesh.positions == reread.mesh.positions &&
              surface.mesh.triangles == reread.mesh.triangles
          ? "true"
          : "false",
      isSameUv ? "true" : "false", written->xref.size(), reread.storedVertexCount,
      cones && cones->has_value() ? "true" : "false", codes(written->notes).c_str(),
      written->files.size());
}

std::string report(const std::string& name, const Arguments& arguments) {
  const auto document = readGltf(fileSet(name), arguments.limits);
  if (!document) return failureText(document.error());
  if (!arguments.out.empty()) return writeAndCompare(**document, arguments);
  std::string surfaces;
  for (const Surface& s : (*document)->surfaces()) {
    surfaces += formatText(
        "%s{\"name\":%s,\"vertices\":%zu,\"triangles\":%zu,\"stored\":%d,"
        "\"uvSets\":%zu,\"notes\":%s}",
        surfaces.empty() ? "" : ",", quoteJson(s.name).c_str(), s.mesh.positions.size(),
        s.mesh.triangles.size(), s.storedVertexCount, s.uvSets.size(), codes(s.notes).c_str());
  }
  return "\"ok\":true,\"exit\":0,\"surfaces\":[" + surfaces + "]";
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return std::string(i + 1 < argc ? argv[++i] : ""); };
    if (word == "--max-bytes")
      arguments.limits.maxBytes = std::stoull(value());
    else if (word == "--max-triangles")
      arguments.limits.maxTriangles = std::stoull(value());
    else if (word == "--write")
      arguments.out = value();
    else if (word == "--map")
      arguments.map = value();
    else if (word == "--set")
      arguments.options.uvSet = std::stoi(value());
    else if (word == "--surface")
      arguments.surface = std::stoi(value());
    else if (word == "--cones")
      arguments.options.cones = value();
    else
      arguments.files.push_back(word);
  }
  for (const std::string& file : arguments.files) {
    std::printf("{\"file\":%s,%s}\n", quoteJson(file).c_str(), report(file, arguments).c_str());
    std::fflush(stdout);
  }
  return 0;
}

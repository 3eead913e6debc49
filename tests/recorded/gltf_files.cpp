// glTF files: every way to store a mesh that is read, several meshes, and what of the rest is kept.
#include <cstring>
#include <nlohmann/json.hpp>

#include "hgp/api/file_maps.h"
#include "hgp/base/check.h"
#include "recorded/recorder.h"

namespace hgp::recorded {
namespace {

using Json = nlohmann::json;
using test::Shape;

constexpr int kByte = 5121, kShort = 5122, kUnsignedShort = 5123, kUnsigned = 5125, kFloat = 5126;

struct Storage {
  int indices = kUnsigned;
  bool isInterleaved = false, isQuantized = false, hasNormals = false, hasUv = false,
       hasColours = false;
  bool isStrip = false, isSparse = false, hasTexture = false, isMirrored = false;
};

/// Builds a GLB from parts.
class Glb {
 public:
  Glb() {
    json_ = Json{{"asset", {{"version", "2.0"}, {"generator", "a test"}}},
                 {"scene", 0},
                 {"scenes", {{{"nodes", Json::array()}}}},
                 {"extras", {{"keep", "this"}}}};
  }

  template <class T>
  int view(const std::vector<T>& values, int stride = 0) {
    bin_.resize((bin_.size() + 3) / 4 * 4);
    Json view{
        {"buffer", 0}, {"byteOffset", bin_.size()}, {"byteLength", values.size() * sizeof(T)}};
    if (stride > 0) view["byteStride"] = stride;
    json_["bufferViews"].push_back(view);
    const char* data = reinterpret_cast<const char*>(values.data());
    bin_.append(data, values.size() * sizeof(T));
    return static_cast<int>(json_["bufferViews"].size()) - 1;
  }

  int accessor(int view, const char* type, int component, std::size_t count,
               Json more = Json::object()) {
    Json accessor{{"type", type}, {"componentType", component}, {"count", count}};
    if (view >= 0) accessor["bufferView"] = view;
    accessor.update(more);
    json_["accessors"].push_back(accessor);
    return static_cast<int>(json_["accessors"].size()) - 1;
  }

  void add(const Shape& shape, const Storage& storage) {
    Json attributes = Json::object();
    const std::size_t count = shape.data.positions.size();
    attributes["POSITION"] = positions(shape, storage, attributes);
    if (storage.hasUv) {
      std::vector<std::uint16_t> uv;
      for (const Vec3& p : shape.data.positions)
        for (double x : {p[0], p[1]})
          uv.push_back(static_cast<std::uint16_t>(20000.0 + 9000.0 * x));
      attributes["TEXCOORD_0"] =
          accessor(view(uv), "VEC2", kUnsignedShort, count, {{"normalized", true}});
    }
    if (storage.hasColours) {
      std::vector<std::uint8_t> colours;
      for (std::size_t i = 0; i < 4 * count; ++i)
        colours.push_back(static_cast<std::uint8_t>(7 * i));
      attributes["COLOR_0"] = accessor(view(colours), "VEC4", kByte, count, {{"normalized", true}});
    }
    Json primitive{{"attributes", attributes}, {"indices", indices(shape, storage)}};
    if (storage.isStrip) primitive["mode"] = 5;
    if (storage.hasTexture) primitive["material"] = material();
    json_["meshes"].push_back({{"name", shape.name}, {"primitives", {primitive}}});
    Json node{{"mesh", json_["meshes"].size() - 1}, {"name", "node"}};
    if (storage.isMirrored) node["scale"] = {-1, 2, 1};
    json_["nodes"].push_back(node);
    json_["scenes"][0]["nodes"].push_back(json_["nodes"].size() - 1);
  }

  std::string text() {
    bin_.resize((bin_.size() + 3) / 4 * 4);
    json_["buffers"] = {{{"byteLength", bin_.size()}}};
    std::string json = json_.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string out = "glTF";
    const auto number = [&](std::size_t n) {
      const auto word = static_cast<std::uint32_t>(n);
      out.append(reinterpret_cast<const char*>(&word), 4);
    };
    number(2), number(28 + json.size() + bin_.size()), number(json.size()), number(0x4e4f534a);
    out += json;
    number(bin_.size()), number(0x004e4942);
    return out + bin_;
  }

 private:
  int positions(const Shape& shape, const Storage& storage, Json& attributes) {
    const std::size_t count = shape.data.positions.size();
    if (storage.isQuantized) {
      std::vector<std::int16_t> all;
      for (const Vec3& p : shape.data.positions) {
        for (double x : p) all.push_back(static_cast<std::int16_t>(9000.0 * x));
        all.push_back(0);
      }
      json_["extensionsUsed"] = json_["extensionsRequired"] = {"KHR_mesh_quantization"};
      return accessor(
          view(all, 8), "VEC3", kShort, count,
          {{"normalized", true}, {"min", {-9000, -9000, -9000}}, {"max", {9000, 9000, 9000}}});
    }
    std::vector<float> all;
    for (const Vec3& p : shape.data.positions) {
      for (double x : p) all.push_back(static_cast<float>(x));
      if (storage.isInterleaved)
        for (double x : {0.0, 0.0, 1.0}) all.push_back(static_cast<float>(x));
    }
    const Json bounds{{"min", {-3, -3, -3}}, {"max", {9, 9, 9}}};
    if (storage.isInterleaved) {
      const int at = view(all, 24);
      attributes["NORMAL"] = accessor(at, "VEC3", kFloat, count, {{"byteOffset", 12}});
      return accessor(at, "VEC3", kFloat, count, bounds);
    }
    Json more = bounds;
    if (storage.isSparse) {
      const int moved = view(std::vector<std::uint16_t>{0, 3});
      const int values =
          view(std::vector<float>{all[0], all[1], 1.1F * all[2], all[9], all[10], all[11]});
      more["sparse"] = {{"count", 2},
                        {"indices", {{"bufferView", moved}, {"componentType", kUnsignedShort}}},
                        {"values", {{"bufferView", values}}}};
    }
    if (storage.hasNormals) attributes["NORMAL"] = accessor(view(all), "VEC3", kFloat, count);
    return accessor(view(all), "VEC3", kFloat, count, more);
  }

  int indices(const Shape& shape, const Storage& storage) {
    std::vector<std::uint32_t> all;
    for (const auto& t : shape.data.triangles) {
      const std::uint32_t first = static_cast<std::uint32_t>(t[0]);
      const bool isOdd = all.size() % 2 != 0;
      if (storage.isStrip && !all.empty()) all.insert(all.end(), {all.back(), first});
      if (storage.isStrip && isOdd) all.push_back(first);  // each triangle begins at an even place
      for (int v : t) all.push_back(static_cast<std::uint32_t>(v));
    }
    const std::size_t count = all.size();
    if (storage.indices == kByte)
      return accessor(view(std::vector<std::uint8_t>(all.begin(), all.end())), "SCALAR", kByte,
                      count);
    if (storage.indices == kUnsignedShort)
      return accessor(view(std::vector<std::uint16_t>(all.begin(), all.end())), "SCALAR",
                      kUnsignedShort, count);
    return accessor(view(all), "SCALAR", kUnsigned, count);
  }

  int material() {
    json_["images"] = {{{"uri", "wood.png"}}};
    json_["textures"] = {{{"source", 0}}};
    json_["materials"].push_back(
        {{"name", "wood"},
         {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 0}}}}}});
    return static_cast<int>(json_["materials"].size()) - 1;
  }

  Json json_;
  std::string bin_;
};

std::string glbOf(const std::vector<Shape>& shapes, const Storage& storage) {
  Glb glb;
  for (const Shape& shape : shapes) glb.add(shape, storage);
  return glb.text();
}

/// Every mesh of a file, and the file with all maps.
void all(Recorder& r, const std::string& text) {
  api::Session session = loadedFile("scene.glb", text);
  r.fact("meshes", session.surfaceCount());
  for (const io::Placements& placed : session.placements())
    r.fact("placed", static_cast<long long>(placed.matrices.size()));
  api::FileMaps maps{api::WriteOptions{}};
  for (int mesh = 0; mesh < session.surfaceCount(); ++mesh) {
    if (const Status done = session.choose(mesh); !done) return r.failure("choose", done.error());
    solve(r, session, std::nullopt, "{}");
    if (const Status done = maps.add(session); !done) return r.failure("add", done.error());
  }
  const Result<api::WrittenFile> written = maps.write();
  if (!written) return r.failure("write", written.error());
  r.notes("notes", written->notes);
  for (const io::OutputFile& file : written->files)
    r.bytes("file", file.bytes.data(), file.bytes.size());
}

}  // namespace

std::string smallGlb() {
  Glb glb;
  const Shape small = shapes::octahedron();
  glb.add(small, {.indices = kByte,
                  .hasNormals = true,
                  .hasUv = true,
                  .hasColours = true,
                  .hasTexture = true});
  glb.add(small, {.indices = kUnsignedShort, .isInterleaved = true, .isMirrored = true});
  glb.add(small, {.isSparse = true});
  return glb.text();
}

std::vector<Scenario> gltfFiles() {
  const Shape sphere = shapes::jittered(shapes::icosphere(3), 0.03);
  const Shape disk = shapes::jittered(shapes::disk(4), 0.03);
  const Shape torus = shapes::jittered(shapes::torus(12, 7), 0.02);
  const std::vector<std::pair<const char*, Storage>> ways = {
      {"32-bit indices", {}},
      {"16-bit indices", {.indices = kUnsignedShort}},
      {"8-bit indices", {.indices = kByte}},
      {"interleaved", {.isInterleaved = true}},
      {"quantized", {.indices = kUnsignedShort, .isQuantized = true}},
      {"normals, uv and colours", {.hasNormals = true, .hasUv = true, .hasColours = true}},
      {"a texture with uv", {.hasUv = true, .hasTexture = true}},
      {"a texture without uv", {.hasTexture = true}},
      {"a strip", {.indices = kUnsignedShort, .isStrip = true}},
      {"sparse", {.isSparse = true}},
      {"mirrored", {.hasNormals = true, .isMirrored = true}}};
  std::vector<Scenario> out;
  for (const auto& [name, storage] : ways) {
    const Storage kept = storage;
    out.push_back({std::string("glb: ") + name, [=](Recorder& r) {
                     through(r, "a.glb", glbOf({sphere}, kept), "{}",
                             {"{}", R"({"embedCones": true})", R"({"uvSet": 1, "use": true})",
                              R"({"use": false})", R"({"format": "obj", "name": "a.obj"})",
                              R"({"gridMaterial": true})"});
                     through(r, "a.glb", glbOf({disk}, kept), R"({"target": "obj"})");
                   }});
    out.push_back({std::string("several meshes: ") + name, [=](Recorder& r) {
                     all(r, glbOf({sphere, disk, torus}, kept));
                   }});
  }
  out.push_back({"glb cut short",
                 [=](Recorder& r) { through(r, "a.glb", glbOf({sphere}, {}).substr(0, 3000)); }});
  out.push_back({"glb without meshes", [=](Recorder& r) { through(r, "a.glb", glbOf({}, {})); }});
  out.push_back({"the second mesh", [=](Recorder& r) {
                   through(r, "a.glb", glbOf({sphere, disk}, {}), R"({"surface": 1})");
                 }});
  return out;
}

}  // namespace hgp::recorded

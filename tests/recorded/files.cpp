// Files: what is read of them, what is repaired, and the bytes that are written in every format.
#include <algorithm>

#include "hgp/api/options_from_json.h"
#include "hgp/base/check.h"
#include "recorded/recorder.h"

namespace hgp::recorded {
namespace {

using test::Shape;

/// The positions and faces of a shape as lines of a format.
std::string vertices(const Shape& shape, const char* row) {
  std::string out;
  for (const Vec3& p : shape.data.positions) out += formatText(row, p[0], p[1], p[2]);
  return out;
}

std::string faces(const Shape& shape, const char* row, int base) {
  std::string out;
  for (const auto& t : shape.data.triangles)
    out += formatText(row, t[0] + base, t[1] + base, t[2] + base);
  return out;
}

std::string objOf(const Shape& shape) {
  return vertices(shape, "v %.17g %.17g %.17g\n") + faces(shape, "f %d %d %d\n", 1);
}

std::string counts(const char* format, const Shape& shape) {
  return formatText(format, static_cast<int>(shape.data.positions.size()),
                    static_cast<int>(shape.data.triangles.size()));
}

void wrote(Recorder& r, const api::Session& session, const char* options) {
  const Result<api::WriteOptions> read = api::optionsFromJson<api::WriteOptions>(options);
  if (!read) return r.failure("options", read.error());
  const Result<api::WrittenMap> written = session.write(*read);
  if (!written) return r.failure("write", written.error());
  r.fact("stored", written->isCertified ? "certified" : "not-certified");
  r.notes("notes", written->notes);
  for (const io::OutputFile& file : written->files)
    r.bytes("file", file.bytes.data(), file.bytes.size());
  // Read again, and judged by what it contains.
  io::FileSet files;
  files.name = written->files[0].name;
  files.main = written->files[0].bytes;
  files.resolve = [&](const std::string& name) -> Result<io::Bytes> {
    for (const io::OutputFile& file : written->files)
      if (file.name == name) return file.bytes;
    return Failure{ErrorCode::kMalformed, "read", name, {}};
  };
  api::Session again;
  if (const Status done = again.load(std::move(files), {}); !done)
    return r.failure("again", done.error());
  const auto cones = readCones(session.conesJson());
  const Result<api::Verdict> verdict = again.verify(cones, {});
  if (!verdict) return r.failure("verify", verdict.error());
  r.json(verdict->isGood ? "good" : "bad", verdict->json);
}

const char* const kQuads =
    "# a box of quads\nmtllib box.mtl\no box\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 1\n"
    "v 2 0 1\nv 2 1 1\nv 0 1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nusemtl red\ns 1\n"
    "f 4/4 3/3 2/2 1/1\nusemtl blue\ns off\nf 5//1 6//1 7//1 8//1\ng side\nf 1/1/1 2/2/1 6/3/1 "
    "5/4/1\n"
    "f -7 -6 \\\n -2 -3\nl 1 2 3\nf 3 4 8 7\nf 4 1 5 8\n";

std::string flipped(Shape shape, int every) {
  for (std::size_t t = 0; t < shape.data.triangles.size(); t += static_cast<std::size_t>(every))
    std::swap(shape.data.triangles[t][0], shape.data.triangles[t][1]);
  return objOf(shape);
}

/// A triangle twice, one without area, three on one edge, and two fans at one vertex.
std::string messy() {
  const Shape sphere = shapes::icosphere(3);
  std::string text = objOf(sphere);
  const int n = static_cast<int>(sphere.data.positions.size());
  const auto& t = sphere.data.triangles[0];
  text += formatText("f %d %d %d\n", t[0] + 1, t[1] + 1, t[2] + 1);
  text += formatText("f %d %d %d\n", t[0] + 1, t[0] + 1, t[1] + 1);
  text += formatText("v 3 3 3\nf %d %d %d\n", t[0] + 1, t[1] + 1, n + 1);
  return text;
}

/// Every corner has a vertex of its own.
std::string stlOf(const Shape& shape) {
  std::string out = "solid s\n";
  for (const auto& t : shape.data.triangles) {
    out += "facet normal 0 0 0\nouter loop\n";
    for (int v : t) {
      const Vec3& p = shape.data.positions[static_cast<std::size_t>(v)];
      out += formatText("vertex %.9g %.9g %.9g\n", p[0], p[1], p[2]);
    }
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid s\n";
}

std::string plyOf(const Shape& shape) {
  return counts(
             "ply\nformat ascii 1.0\ncomment made by a test\nelement vertex %d\nproperty double x\n"
             "property double y\nproperty double z\nelement face %d\nproperty list uchar int "
             "vertex_indices\nend_header\n",
             shape) +
         vertices(shape, "%.17g %.17g %.17g\n") + faces(shape, "3 %d %d %d\n", 0);
}

std::string offOf(const Shape& shape) {
  return counts("OFF\n# comment\n%d %d 0\n", shape) + vertices(shape, "%.17g %.17g %.17g\n") +
         faces(shape, "3 %d %d %d\n", 0);
}

std::string withLineEnds(const std::string& text, const char* end) {
  std::string out;
  for (char c : text) out += c == '\n' ? std::string(end) : std::string(1, c);
  return out;
}

template <class T>
void append(std::string& out, T value, bool isSwapped) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof(T));
  if (isSwapped) std::reverse(bytes.begin(), bytes.end());
  out += bytes;
}

/// With uv at the corners, a colour per face, and a property that is kept as it is.
std::string binaryPly(const Shape& shape, bool isBig) {
  std::string out =
      "ply\nformat binary_" + std::string(isBig ? "big" : "little") + "_endian 1.0\n" +
      counts(
          "obj_info a line\nelement vertex %d\nproperty float x\nproperty float y\n"
          "property float z\nproperty uchar red\nproperty ushort weight\nelement face %d\n"
          "property list uchar uint vertex_indices\nproperty list uchar float texcoord\n"
          "property int part\nend_header\n",
          shape);
  for (const Vec3& p : shape.data.positions) {
    for (double x : p) append(out, static_cast<float>(x), isBig);
    append(out, std::uint8_t{200}, isBig), append(out, std::uint16_t{777}, isBig);
  }
  for (const auto& t : shape.data.triangles) {
    append(out, std::uint8_t{3}, isBig);
    for (int v : t) append(out, static_cast<std::uint32_t>(v), isBig);
    append(out, std::uint8_t{6}, isBig);
    for (int v : t)
      for (std::size_t k = 0; k < 2; ++k)
        append(out, static_cast<float>(shape.data.positions[static_cast<std::size_t>(v)][k]),
               isBig);
    append(out, t[0], isBig);
  }
  return out;
}

std::string binaryStl(const Shape& shape) {
  std::string out(80, ' ');
  append(out, static_cast<std::uint32_t>(shape.data.triangles.size()), false);
  for (const auto& t : shape.data.triangles) {
    for (int k = 0; k < 3; ++k) append(out, 0.0F, false);
    for (int v : t)
      for (double x : shape.data.positions[static_cast<std::size_t>(v)])
        append(out, static_cast<float>(x), false);
    append(out, std::uint16_t{5}, false);
  }
  return out;
}

/// Colours, weights, polygons that are not convex, uv at some faces, groups, lines, smoothing.
const char* const kRich =
    "# rich\nv 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 2 2 0 0 0 1\nv 1 0.5 0 1 1 1\nv 0 2 0 0 0 0\nv 1 1 2 "
    "1 1 0\n"
    "v 3 1 0.5 0.5 0.5 0.5\nvt 0 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.25\nvt 0 1\ng a b\ns 2\nf 1/1 4/4 "
    "2/2\n"
    "f 5/5 3/3 4/4 1/1\ns off\nusemtl m\nf -7 -6 -2\nf 2 3 6\nf 3 5 6\nf 5 1 6\nf 2 7 3\nl 1 2 "
    "3\np 1\n";

/// The marks of a file as features.
void marked(Recorder& r, const std::string& text) {
  const api::Session session = loadedFile("a.obj", text);
  for (const char* mark : {"lines", "smoothing", "materials", "normals"}) {
    const std::string asked = formatText(
        R"({"format":"hgp-cones","version":1,"q":4,"features":{"marked":["%s"]}})", mark);
    const auto list = session.features(readCones(asked), "f.txt");
    if (list)
      r.text(mark, list->text);
    else
      r.failure(mark, list.error());
  }
}

}  // namespace

void through(Recorder& r, const std::string& name, const std::string& text, const char* load,
             const std::vector<const char*>& ways) {
  const Result<api::LoadOptions> options = api::optionsFromJson<api::LoadOptions>(load);
  if (!options) return r.failure("options", options.error());
  io::FileSet files;
  files.name = name;
  files.main.assign(text.begin(), text.end());
  api::Session session;
  if (const Status done = session.load(std::move(files), *options); !done)
    return r.failure("load", done.error());
  const Result<api::Verdict> inspected = session.inspect();
  if (inspected) r.json(inspected->isGood ? "usable" : "unusable", inspected->json);
  if (const auto verdict = session.verify(std::nullopt, {}); verdict)
    r.json(verdict->isGood ? "good" : "bad", verdict->json);
  else
    r.failure("verify", verdict.error());
  const auto embedded = session.embeddedCones();
  r.fact("embedded",
         embedded && *embedded ? static_cast<long long>((*embedded)->cones.size()) : -1);
  solve(r, session, std::nullopt, R"({"maxRounds": 8})");
  if (session.hasResult())
    for (const char* way : ways) wrote(r, session, way);
}

std::vector<std::pair<std::string, std::string>> smallFiles() {
  const Shape small = shapes::octahedron();
  return {{"a.obj", kRich},
          {"b.obj", kQuads},
          {"a.ply", plyOf(small)},
          {"b.ply", binaryPly(small, false)},
          {"c.ply", binaryPly(small, true)},
          {"a.off", offOf(small)},
          {"a.stl", stlOf(small)},
          {"b.stl", binaryStl(small)}};
}

std::vector<Scenario> files() {
  const Shape sphere = shapes::jittered(shapes::icosphere(3), 0.03);
  const Shape disk = shapes::jittered(shapes::disk(4), 0.03);
  const Shape torus = shapes::jittered(shapes::torus(12, 7), 0.02);
  const std::vector<const char*> all = {
      "{}",
      R"({"format": "glb", "name": "a.glb"})",
      R"({"format": "gltf", "name": "a.gltf", "embedCones": true})",
      R"({"format": "obj", "name": "a.obj", "gridMaterial": true})",
      R"({"format": "flat-obj", "name": "a.obj"})",
      R"({"format": "svg", "name": "a.svg"})",
      R"({"format": "glb", "name": "a.glb", "gridMaterial": 12, "embedCones": true})",
      R"({"format": "glb", "name": "a.glb", "uvSet": 2})"};
  return {
      {"obj", [=](Recorder& r) { through(r, "a.obj", objOf(sphere), "{}", all); }},
      {"obj of a torus", [=](Recorder& r) { through(r, "a.obj", objOf(torus), "{}", all); }},
      {"obj with quads", [=](Recorder& r) { through(r, "box.obj", kQuads); }},
      {"obj with quads as glb",
       [=](Recorder& r) { through(r, "box.obj", kQuads, R"({"target": "glb"})"); }},
      {"obj with flipped faces", [=](Recorder& r) { through(r, "a.obj", flipped(sphere, 7)); }},
      {"obj with flipped faces, repaired",
       [=](Recorder& r) { through(r, "a.obj", flipped(disk, 5), R"({"writeRepairs": true})"); }},
      {"obj with flipped faces, strict",
       [=](Recorder& r) { through(r, "a.obj", flipped(sphere, 9), R"({"strict": true})"); }},
      {"small obj with flipped faces",
       [=](Recorder& r) {
         Shape small = sphere;
         for (Vec3& p : small.data.positions) p = {0.1 * p[0], 0.1 * p[1], 0.1 * p[2]};
         through(r, "a.obj", flipped(small, 2));
       }},
      {"messy obj", [=](Recorder& r) { through(r, "a.obj", messy()); }},
      {"messy obj, repaired",
       [=](Recorder& r) { through(r, "a.obj", messy(), R"({"writeRepairs": true})"); }},
      {"messy obj, strict",
       [=](Recorder& r) { through(r, "a.obj", messy(), R"({"strict": true})"); }},
      {"ply", [=](Recorder& r) { through(r, "a.ply", plyOf(torus)); }},
      {"ply as floats",
       [=](Recorder& r) { through(r, "a.ply", plyOf(disk), R"({"target": "ply"})"); }},
      {"ply as gltf",
       [=](Recorder& r) { through(r, "a.ply", plyOf(disk), R"({"target": "gltf"})"); }},
      {"off", [=](Recorder& r) { through(r, "a.off", offOf(disk)); }},
      {"off as obj",
       [=](Recorder& r) { through(r, "a.off", offOf(sphere), R"({"target": "obj"})"); }},
      {"stl", [=](Recorder& r) { through(r, "a.stl", stlOf(sphere)); }},
      {"stl as glb",
       [=](Recorder& r) { through(r, "a.stl", stlOf(disk), R"({"target": "glb"})"); }},
      {"welded", [=](Recorder& r) { through(r, "a.obj", objOf(sphere), R"({"weld": 0.2})"); }},
      {"too many triangles",
       [=](Recorder& r) {
         through(r, "a.obj", objOf(sphere), R"({"limits": {"triangles": 10}})");
       }},
      {"no file", [=](Recorder& r) { through(r, "a.obj", ""); }},
      {"a face without a vertex",
       [=](Recorder& r) { through(r, "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n"); }},
      {"a number that is none",
       [=](Recorder& r) { through(r, "a.obj", "v 0 0 0\nv 1 x 0\nf 1 2 3\n"); }},
      {"ply that ends early",
       [=](Recorder& r) { through(r, "a.ply", plyOf(disk).substr(0, 900)); }},
      {"off with a wrong count",
       [=](Recorder& r) { through(r, "a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"); }},
      {"obj with CR LF",
       [=](Recorder& r) { through(r, "a.obj", withLineEnds(objOf(disk), "\r\n")); }},
      {"obj with CR", [=](Recorder& r) { through(r, "a.obj", withLineEnds(objOf(disk), "\r")); }},
      {"off with CR LF",
       [=](Recorder& r) {
         through(r, "a.off", withLineEnds(offOf(disk), "\r\n"), R"({"target": "obj"})");
       }},
      {"ply with CR LF",
       [=](Recorder& r) { through(r, "a.ply", withLineEnds(plyOf(disk), "\r\n")); }},
      {"rich obj",
       [=](Recorder& r) {
         through(r, "a.obj", kRich, "{}", {"{}", R"({"uvSet": 0, "gridMaterial": true})"});
       }},
      {"rich obj as glb", [=](Recorder& r) { through(r, "a.obj", kRich, R"({"target": "glb"})"); }},
      {"rich obj, repaired",
       [=](Recorder& r) { through(r, "a.obj", kRich, R"({"writeRepairs": true})"); }},
      {"obj with quads, convex",
       [=](Recorder& r) {
         api::Session session = loadedFile("box.obj", kQuads);
         solve(r, session, std::nullopt, R"({"convexPolygons": true})");
         wrote(r, session, "{}");
       }},
      {"marks",
       [=](Recorder& r) {
         marked(r, kQuads);
         marked(r, kRich);
       }},
      {"binary ply", [=](Recorder& r) { through(r, "a.ply", binaryPly(torus, false)); }},
      {"binary ply, big end first",
       [=](Recorder& r) { through(r, "a.ply", binaryPly(disk, true)); }},
      {"binary ply as obj",
       [=](Recorder& r) { through(r, "a.ply", binaryPly(disk, false), R"({"target": "obj"})"); }},
      {"binary ply as glb",
       [=](Recorder& r) { through(r, "a.ply", binaryPly(disk, false), R"({"target": "glb"})"); }},
      {"binary stl", [=](Recorder& r) { through(r, "a.stl", binaryStl(torus)); }},
      {"off with colours",
       [=](Recorder& r) {
         through(r, "a.off",
                 counts("COFF %d %d 0\n", disk) + vertices(disk, "%.9g %.9g %.9g 255 0 0 255\n") +
                     faces(disk, "3 %d %d %d 0.5 0.5 0.5\n", 0));
       }},
  };
}

}  // namespace hgp::recorded

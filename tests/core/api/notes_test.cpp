// Notes on files as they are read, repaired and written.  Law: each cause gives its code, with the count, wherever notes
// are collected.
#include "support/notes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "hgp/api/session.h"

namespace hgp::api {
namespace {

using test::Codes;

io::FileSet fileOf(const std::string& name, const std::string& text) {
  io::FileSet files;
  files.name = name;
  files.main.assign(text.begin(), text.end());
  return files;
}

/// Codes of the notes of `inspect`: on the file's surface and on the model.
Codes inspected(const std::string& name, const std::string& text, const LoadOptions& options = {}) {
  Session session;
  const Status loaded = session.load(fileOf(name, text), options);
  EXPECT_TRUE(loaded) << (loaded ? "" : told(loaded.error()));
  if (!loaded) return {};
  const auto json = nlohmann::json::parse(session.inspect()->json);
  Codes codes;
  for (const auto& surface : json["surfaces"])
    for (const auto& note : surface["notes"]) codes.push_back(note["code"]);
  for (const auto& note : json["notes"]) codes.push_back(note["code"]);
  return codes;
}

/// Codes of the notes on the file that the automatic map is written into.
Codes written(const std::string& name, const std::string& text, const WriteOptions& options = {},
              const std::string& target = "") {
  Session session;
  LoadOptions load;
  load.target = target;
  EXPECT_TRUE(session.load(fileOf(name, text), load));
  SolveOptions solve;
  EXPECT_TRUE(session.parametrize(std::nullopt, solve));
  WriteOptions how = options;
  how.name = name;
  const Result<WrittenMap> made = session.write(how);
  EXPECT_TRUE(made) << (made ? "" : told(made.error()));
  return made ? test::codesOf(made->notes) : Codes{};
}

bool has(const Codes& codes, const std::string& code) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}
#define EXPECT_TOLD(codes, code) EXPECT_TRUE(has(codes, code)) << testing::PrintToString(codes)

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kFaces = "f 1 2 3\nf 1 3 4\n";

TEST(NotesOfFiles, WhatAReaderMeetsIsTold) {
  EXPECT_TOLD(inspected("a.obj", kSquare + "f 1 2 3 4\n"), "read-polygons");
  EXPECT_TOLD(inspected("a.obj", kSquare + "call x.obj\n" + kFaces), "read-commands-skipped");
  EXPECT_TOLD(inspected("a.obj", kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1 3 4\n"),
              "read-uv-incomplete");
  EXPECT_TOLD(inspected("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv nan 0 0\nf 1 2 3\n"),
              "read-not-finite");
  const std::string stl =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid s\n";
  EXPECT_TOLD(inspected("a.stl", stl), "read-joined-equal");
}

TEST(NotesOfFiles, WhatAConversionLosesIsTold) {
  LoadOptions toGlb;
  toGlb.target = "glb";
  const std::string text = kSquare + "vt 0 0\no first\nf 1/1 2/1 3/1 4/1\n";
  const Codes codes = inspected("a.obj", text, toGlb);
  EXPECT_TOLD(codes, "convert-polygons-cut");
  EXPECT_TOLD(codes, "convert-uv-lost");
  EXPECT_TOLD(inspected("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv nan 0 0\nf 1 2 3\n", toGlb),
              "convert-unused-placed");
}

TEST(NotesOfFiles, DefectsAreToldWithTheirRepairs) {
  const Codes turned = inspected("a.obj", kSquare + "f 1 2 3\nf 1 4 3\n");
  EXPECT_TOLD(turned, "defect-inconsistent-edge");
  const Codes fin = inspected("a.obj", kSquare + "v 0 0 1\n" + kFaces + "f 1 3 5\n");
  EXPECT_TOLD(fin, "defect-non-manifold-edge");
  EXPECT_TOLD(fin, "repair-split");
  const Codes bow = inspected("a.obj", kSquare + "v -1 0 0\nv -1 -1 0\n" + kFaces + "f 1 5 6\n");
  EXPECT_TOLD(bow, "defect-non-manifold-vertex");
  const Codes twice = inspected("a.obj", kSquare + kFaces + "f 1 2 3\n");
  EXPECT_TOLD(twice, "defect-duplicate-face");
  EXPECT_TOLD(twice, "repair-copies");
  const Codes repeated = inspected("a.obj", kSquare + kFaces + "f 1 1 2\n");
  EXPECT_TOLD(repeated, "defect-repeated-vertex");
  EXPECT_TOLD(repeated, "repair-no-surface");
  const Codes flat = inspected("a.obj", kSquare + "v 0.5 0 0\nf 1 2 3\nf 1 3 4\nf 1 5 2\n");
  EXPECT_TOLD(flat, "defect-zero-area");
  EXPECT_TOLD(flat, "repair-lengths");
  std::string band;
  for (int i = 0; i < 6; ++i) {
    const double a = i * 1.0471975511965976, w = 0.3 * (i < 3 ? 1.0 : 0.9);
    band += "v " + std::to_string(std::cos(a)) + " " + std::to_string(std::sin(a)) + " " +
            std::to_string(w) + "\nv " + std::to_string(1.2 * std::cos(a)) + " " +
            std::to_string(1.2 * std::sin(a)) + " " + std::to_string(-w) + "\n";
  }
  for (int i = 0; i < 6; ++i) {
    const int a = 2 * i + 1, b = 2 * i + 2;
    const int c = i < 5 ? a + 2 : 2, d = i < 5 ? b + 2 : 1;
    band += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\nf " +
            std::to_string(b) + " " + std::to_string(d) + " " + std::to_string(c) + "\n";
  }
  EXPECT_TOLD(inspected("a.obj", band), "repair-one-sided-cut");
  LoadOptions near;
  near.weld = 0.01;
  EXPECT_TOLD(inspected("a.obj", kSquare + "v 1 0 0.001\nf 1 2 3\nf 1 3 4\n", near), "weld");
}

TEST(NotesOfFiles, WhatAWriterChangesBesidesTheUvIsTold) {
  const std::string old = kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
  EXPECT_TOLD(written("a.obj", old + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"), "write-vt-replaced");
  EXPECT_TOLD(written("a.obj", old + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nl 1/1 2/2\n"),
              "write-lines-without-vt");
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "float z\nproperty float s\nproperty float t\nelement face 2\nproperty list uchar int "
      "vertex_indices\nend_header\n0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n3 0 1 2\n3 0 2 3\n";
  WriteOptions withCones;
  withCones.embedCones = true;
  const Codes codes = written("a.ply", ply, withCones, "ply");
  EXPECT_TOLD(codes, "write-uv-replaced");
  EXPECT_TOLD(codes, "write-cones-ply");
}

}  // namespace
}  // namespace hgp::api

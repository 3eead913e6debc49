#include "hgp/api/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "hgp/api/sha256.h"
#include "hgp/io/cone_files.h"
#include "hgp/mesh/nearby_order.h"
#include "hgp/mesh/topology.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

using hgp::test::Shape;

io::FileSet fileSet(const std::string& name, const io::Bytes& bytes) {
  io::FileSet files;
  files.name = name;
  files.main = bytes;
  return files;
}

io::Bytes objOf(const MeshData& mesh) { return io::writePlainObj(mesh, {}, ""); }

/// Two surfaces in one file, the second moved aside.
MeshData together(const MeshData& a, const MeshData& b) {
  MeshData out = a;
  const int first = static_cast<int>(a.positions.size());
  for (Vec3 p : b.positions) out.positions.push_back({p[0] + 10, p[1], p[2]});
  for (auto t : b.triangles) out.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return out;
}

Session loaded(const MeshData& mesh, const LoadOptions& options = {}) {
  Session session;
  const Status done = session.load(fileSet("mesh.obj", objOf(mesh)), options);
  EXPECT_TRUE(done.hasValue()) << (done ? "" : done.error().message);
  return session;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Sha256, AgreesWithTheStandard) {
  EXPECT_EQ(sha256(nullptr, 0), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  const std::string abc = "abc";
  EXPECT_EQ(sha256(reinterpret_cast<const std::uint8_t*>(abc.data()), 3),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const std::string million(1000000, 'a');
  EXPECT_EQ(sha256(reinterpret_cast<const std::uint8_t*>(million.data()), million.size()),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Session, EveryCallBeforeLoadingIsRefused) {
  Session session;
  EXPECT_FALSE(session.inspect().hasValue());
  EXPECT_FALSE(session.parametrize(std::nullopt, {}).hasValue());
  EXPECT_FALSE(session.write({}).hasValue());
  EXPECT_TRUE(session.uv().empty());
}

TEST(Session, InspectKnowsTheTopologyOfEveryShape) {
  for (const Shape& shape : hgp::test::all()) {
    const Session session = loaded(shape.data);
    Result<Verdict> verdict = session.inspect();
    ASSERT_TRUE(verdict.hasValue());
    EXPECT_TRUE(verdict->isGood) << shape.name;
    EXPECT_TRUE(contains(verdict->json, "\"genus\": " + std::to_string(shape.genus))) << shape.name;
    EXPECT_TRUE(contains(verdict->json, "\"boundaryLoops\": " + std::to_string(shape.loops)));
  }
}

TEST(Session, AnUnusableMeshIsRepairedOrWhereStrictInspectedAndNotSolved) {
  MeshData mesh = hgp::test::cube().data;
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_TRUE(loaded(mesh).inspect()->isGood);
  EXPECT_TRUE(contains(loaded(mesh).inspect()->json, "\"defect-inconsistent-edge\""));
  LoadOptions strict;
  strict.isStrict = true;
  Session session = loaded(mesh, strict);
  Result<Verdict> verdict = session.inspect();
  ASSERT_TRUE(verdict.hasValue());
  EXPECT_FALSE(verdict->isGood);
  EXPECT_TRUE(contains(verdict->json, "inconsistent-edge"));
  const Status solved = session.parametrize(std::nullopt, {});
  ASSERT_FALSE(solved.hasValue());
  EXPECT_EQ(solved.error().code, ErrorCode::kUnsupported);
  LoadOptions fix;
  fix.fix.orient = true;
  EXPECT_TRUE(loaded(mesh, fix).inspect()->isGood);
}

TEST(Session, TheSurfaceThatAWeldChangedIsReturned) {
  MeshData mesh = hgp::test::cube().data;
  EXPECT_FALSE(loaded(mesh).repaired().has_value());
  // The first triangle gets corners of its own, a hair away.
  const int count = static_cast<int>(mesh.positions.size());
  const auto first = mesh.triangles[0];
  for (int& v : mesh.triangles[0]) {
    Vec3 p = mesh.positions[static_cast<std::size_t>(v)];
    p[0] += 1e-7;
    mesh.positions.push_back(p);
    v = static_cast<int>(mesh.positions.size()) - 1;
  }
  LoadOptions weld;
  weld.weld = 1e-5;
  const auto repaired = loaded(mesh, weld).repaired();
  ASSERT_TRUE(repaired.has_value());
  EXPECT_EQ(repaired->triangles.size(), 3 * mesh.triangles.size());
  EXPECT_EQ(repaired->vertexOrigin.size(), static_cast<std::size_t>(count));
  ASSERT_EQ(repaired->vertexImage.size(), mesh.positions.size());
  for (int k = 0; k < 3; ++k) {
    const auto was = static_cast<std::size_t>(first[static_cast<std::size_t>(k)]);
    EXPECT_EQ(repaired->vertexImage[was],
              repaired->vertexImage[static_cast<std::size_t>(count + k)]);
  }
}

TEST(Session, CheckCountsTheBudget) {
  const Session session = loaded(hgp::test::icosphere(3).data);
  prescription::Prescription cones;
  cones.q = 4;
  cones.hasCones = true;
  for (int v : {0, 1, 2, 3, 4, 5, 6, 7}) cones.cones.push_back({v, 3, {}});
  EXPECT_TRUE(session.check(cones)->isGood);
  cones.cones.pop_back();
  Result<Verdict> verdict = session.check(cones);
  ASSERT_TRUE(verdict.hasValue());
  EXPECT_FALSE(verdict->isGood);
  EXPECT_EQ(verdict->reason->code, ErrorCode::kPrescription);
  cones.cones.push_back({123456, 3, {}});
  EXPECT_FALSE(session.check(cones)->isGood);
  cones.q = 0;
  EXPECT_FALSE(session.check(cones)->isGood);
}

/// Solves, writes, reads again and verifies what was read: the law of the whole program.
void expectRoundTrip(const MeshData& mesh, const std::optional<prescription::Prescription>& asked,
                     const SolveOptions& options = {}) {
  Session session = loaded(mesh);
  const Status solved = session.parametrize(asked, options);
  ASSERT_TRUE(solved.hasValue()) << solved.error().message;
  ASSERT_TRUE(session.isCertified()) << session.certificateJson();
  EXPECT_EQ(session.cornerToUv().size(), 3 * mesh.triangles.size());
  EXPECT_EQ(session.uv().size(), 2 * session.uvToVertex().size());
  for (std::size_t c = 0; c < session.cornerToUv().size(); ++c) {
    ASSERT_EQ(session.uvToVertex()[session.cornerToUv()[c]], session.triangles()[c]);
  }
  WriteOptions out;
  out.name = "out.obj";
  Result<WrittenMap> written = session.write(out);
  ASSERT_TRUE(written.hasValue());
  Session again;
  ASSERT_TRUE(again.load(fileSet("out.obj", written->files[0].bytes), {}).hasValue());
  Result<prescription::Prescription> cones = readPrescription("c.json", session.conesJson(), 4);
  ASSERT_TRUE(cones.hasValue()) << session.conesJson();
  Result<Verdict> verdict = again.verify(*cones, {});
  ASSERT_TRUE(verdict.hasValue()) << verdict.error().message;
  EXPECT_TRUE(verdict->isGood) << verdict->json;
}

TEST(Session, WhatIsWrittenIsCertifiedAgainAfterReading) {
  prescription::Prescription cones;
  cones.hasCones = true;
  for (int v = 0; v < 8; ++v) cones.cones.push_back({v, 3, {}});
  expectRoundTrip(hgp::test::icosphere(3).data, cones);
}

TEST(Session, AutomaticConesNeedNoPrescription) {
  expectRoundTrip(hgp::test::cube(4).data, std::nullopt);
}

TEST(Session, SuggestedConesGiveTheMapOfAutomaticOnesByteForByte) {
  for (const MeshData& mesh :
       {hgp::test::jittered(hgp::test::pretzel(2, 4), 0.1).data, hgp::test::disk(6).data,
        together(hgp::test::torus(16, 8).data, hgp::test::cube(4).data)}) {
    Session automatic = loaded(mesh);
    ASSERT_TRUE(automatic.parametrize(std::nullopt, {}));
    Session named = loaded(mesh);
    const Result<SuggestedCones> cones = named.suggest({});
    ASSERT_TRUE(cones);
    const auto prescription = readPrescription("cones.json", cones->json, 4);
    ASSERT_TRUE(prescription);
    ASSERT_TRUE(named.parametrize(*prescription, {}));
    EXPECT_EQ(automatic.uv(), named.uv());
    EXPECT_EQ(automatic.cornerToUv(), named.cornerToUv());
    EXPECT_EQ(automatic.conesJson(), cones->json);
    // A session that solved before gives the same.
    ASSERT_TRUE(named.parametrize(std::nullopt, {}));
    EXPECT_EQ(automatic.uv(), named.uv());
  }
}

TEST(Session, ADiskGoesOntoAConvexPolygon) {
  SolveOptions options;
  options.boundary = BoundaryKind::kConvex;
  expectRoundTrip(hgp::test::disk(4).data, std::nullopt, options);
}

TEST(Session, SeveralComponentsAreSolvedApartAndDoNotOverlap) {
  const MeshData mesh = together(hgp::test::disk(3).data, hgp::test::grid(3, 4).data);
  expectRoundTrip(mesh, std::nullopt);
  Session session = loaded(mesh);
  ASSERT_TRUE(session.parametrize(std::nullopt, {}).hasValue());
  const std::size_t split = hgp::test::disk(3).data.positions.size();
  struct Box {
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  };
  Box boxes[2];
  for (std::size_t i = 0; i < session.uvToVertex().size(); ++i) {
    Box& box = boxes[session.uvToVertex()[i] < split ? 0 : 1];
    for (std::size_t k = 0; k < 2; ++k) {
      box.low[k] = std::min(box.low[k], session.uv()[2 * i + k]);
      box.high[k] = std::max(box.high[k], session.uv()[2 * i + k]);
    }
  }
  const auto isApart = [&](std::size_t k) {
    return boxes[0].high[k] < boxes[1].low[k] || boxes[1].high[k] < boxes[0].low[k];
  };
  EXPECT_TRUE(isApart(0) || isApart(1));
}

TEST(Session, ScalesAsAsked) {
  Session session = loaded(hgp::test::disk(3).data);
  SolveOptions options;
  options.boundary = BoundaryKind::kConvex;
  options.scale = Scale::kFit;
  ASSERT_TRUE(session.parametrize(std::nullopt, options).hasValue());
  EXPECT_TRUE(session.isCertified());
  double largest = 0;
  for (double x : session.uv()) {
    EXPECT_GE(x, 0);
    EXPECT_LE(x, 1);
    largest = std::max(largest, x);
  }
  EXPECT_NEAR(largest, 1, 1e-6);

  options.scale = Scale::kUnit;
  ASSERT_TRUE(session.parametrize(std::nullopt, options).hasValue());
  double sum = 0;
  const auto corner = [&](std::size_t c, std::size_t k) {
    return session.uv()[2 * session.cornerToUv()[c] + k];
  };
  const std::size_t sides = session.cornerToUv().size();
  for (std::size_t c = 0; c < sides; ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    sum += std::hypot(corner(next, 0) - corner(c, 0), corner(next, 1) - corner(c, 1));
  }
  EXPECT_NEAR(sum / static_cast<double>(sides), 1, 1e-9);
}

/// A direction per triangle of a flat surface.
prescription::Prescription crosses(std::size_t faces, double angle) {
  prescription::Prescription field;
  field.field.emplace();
  field.field->directions.assign(faces, Vec3{std::cos(angle), std::sin(angle), 0});
  return field;
}

TEST(Session, FramesOfAFieldAreTakenForEveryComponent) {
  const MeshData mesh = together(hgp::test::grid(4, 3).data, hgp::test::annulus(12, 3).data);
  Session session = loaded(mesh);
  SolveOptions options;
  options.frames = FrameSource::kFile;
  const prescription::Prescription field = crosses(mesh.triangles.size(), 0.3);
  const Status done = session.parametrize(field, options);
  ASSERT_TRUE(done.hasValue()) << done.error().message;
  EXPECT_TRUE(session.isCertified());
  EXPECT_TRUE(contains(session.reportJson(), "\"frames\": \"file\""));
  EXPECT_TRUE(contains(session.reportJson(), "\"field-frames\""));
  options.frames = FrameSource::kAuto;
  ASSERT_TRUE(session.parametrize(field, options).hasValue());
  EXPECT_TRUE(contains(session.reportJson(), "\"frames\": \"auto\""));
}

TEST(Session, FramesOfAFileNeedAFieldWithDirections) {
  const MeshData mesh = hgp::test::grid(4, 4).data;
  Session session = loaded(mesh);
  SolveOptions options;
  options.frames = FrameSource::kFile;
  prescription::Prescription bare;
  bare.hasCones = true;
  prescription::Prescription matched = bare;
  matched.field.emplace();
  matched.field->hasMatchings = true;
  const std::vector<std::optional<prescription::Prescription>> without = {std::nullopt, bare,
                                                                          matched};
  for (const auto& asked : without) {
    const Status done = session.parametrize(asked, options);
    ASSERT_FALSE(done.hasValue());
    EXPECT_EQ(done.error().code, ErrorCode::kUsage) << done.error().message;
  }
  options.boundary = BoundaryKind::kConvex;
  EXPECT_FALSE(session.parametrize(crosses(mesh.triangles.size(), 0), options).hasValue());
}

TEST(Session, ConesThatTheFieldDoesNotHaveAreRefusedWithTheirPlaces) {
  const MeshData mesh = hgp::test::grid(4, 4).data;
  Session session = loaded(mesh);
  SolveOptions options;
  options.frames = FrameSource::kFile;
  prescription::Prescription cones;
  cones.hasCones = true;
  cones.cones = {{12, 3, std::nullopt}};
  const auto asked = withField(cones, crosses(mesh.triangles.size(), 0));
  ASSERT_TRUE(asked.hasValue());
  const Status done = session.parametrize(*asked, options);
  ASSERT_FALSE(done.hasValue());
  EXPECT_EQ(done.error().code, ErrorCode::kPrescription);
  ASSERT_EQ(done.error().where.size(), 1U);
  EXPECT_EQ(done.error().where[0].id, 12);
  prescription::Prescription other = cones;
  other.q = 6;
  EXPECT_FALSE(withField(other, crosses(mesh.triangles.size(), 0)).hasValue());
}

/// Large enough to be solved under numbers of its own; the loop is that of the triangle taken out.
Shape scatteredTorus() {
  Shape torus = hgp::test::torus(102, 100);
  return hgp::test::scattered(hgp::test::withoutFaces(torus, {4321}));
}

int vertexAt(const TriMesh& mesh, const Vec3& p) {
  const auto distance = [&](VertexId v) {
    const Vec3& q = mesh.position(v);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  VertexId best(0);
  for (VertexId v : mesh.vertices())
    if (distance(v) < distance(best)) best = v;
  return best.i;
}

TEST(Session, AFileInScatteredOrderIsReportedByItsOwnIds) {
  const Shape torus = scatteredTorus();
  const TriMesh mesh = torus.mesh();
  ASSERT_TRUE(isScattered(mesh));
  Session session = loaded(torus.data);
  prescription::Prescription asked;
  asked.hasCones = true;
  // Outside and inside of the tube, where the surface itself bends that way.
  for (const double x : {1.4, -1.4}) asked.cones.push_back({vertexAt(mesh, {x, 0, 0}), 3, {}});
  for (const double y : {0.6, -0.6}) asked.cones.push_back({vertexAt(mesh, {0, y, 0}), 5, {}});
  std::sort(asked.cones.begin(), asked.cones.end(),
            [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
  asked.boundaries = {{0, -4, -1}};
  asked.handles = {{0, 1}, {1, 0}};
  const Status done = session.parametrize(asked, {});
  ASSERT_TRUE(done.hasValue()) << done.error().message;
  EXPECT_TRUE(session.isCertified());

  // Every triangle of the file is there, under its own vertices, and the right way up.
  const auto& triangles = session.triangles();
  ASSERT_EQ(session.cornerToUv().size(), triangles.size());
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    double uv[3][2];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = session.cornerToUv()[t + k];
      ASSERT_EQ(session.uvToVertex()[i], triangles[t + k]);
      ASSERT_EQ(static_cast<int>(triangles[t + k]), torus.data.triangles[t / 3][k]);
      for (std::size_t x = 0; x < 2; ++x) uv[k][x] = session.uv()[2 * i + x];
    }
    EXPECT_GT((uv[1][0] - uv[0][0]) * (uv[2][1] - uv[0][1]) -
                  (uv[1][1] - uv[0][1]) * (uv[2][0] - uv[0][0]),
              0);
  }
  const auto told = io::readPrescription("cones.json", session.conesJson(), 4);
  ASSERT_TRUE(told.hasValue());
  ASSERT_EQ(told->cones.size(), asked.cones.size());
  for (std::size_t i = 0; i < asked.cones.size(); ++i) {
    EXPECT_EQ(told->cones[i].vertex, asked.cones[i].vertex);
    EXPECT_EQ(told->cones[i].k, asked.cones[i].k);
    ASSERT_TRUE(told->cones[i].position.has_value());
    EXPECT_NEAR((*told->cones[i].position)[0], mesh.position(VertexId(asked.cones[i].vertex))[0],
                1e-6);
  }
  ASSERT_EQ(told->boundaries.size(), 1u);
  EXPECT_TRUE(mesh.isBoundary(VertexId(told->boundaries[0].anchor)));

  // The rotations along the file's own generators, summed over the seams they cross.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> rotation;
  for (const SeamEdge& s : session.seams()) {
    const auto end = [&](int i) { return session.uvToVertex()[static_cast<std::size_t>(i)]; };
    rotation[{end(s.a[0]), end(s.a[1])}] = s.r;
    rotation[{end(s.a[1]), end(s.a[0])}] = -s.r;
  }
  const auto generators = handleGenerators(mesh);
  ASSERT_EQ(generators.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    int sum = 0;
    for (HalfedgeId h : generators[i].crossed) {
      const auto seam = rotation.find(
          {static_cast<std::uint32_t>(mesh.tail(h).i), static_cast<std::uint32_t>(mesh.head(h).i)});
      if (seam != rotation.end()) sum += seam->second;
    }
    EXPECT_EQ(((sum % 4) + 4) % 4, asked.handles[i].r) << "generator " << i;
  }
}

TEST(Session, AFieldInScatteredOrderStaysOnItsTriangles) {
  const Shape torus = scatteredTorus();
  prescription::Prescription field;
  field.field.emplace();
  for (const auto& t : torus.data.triangles) {
    Vec3 c{0, 0, 0};
    for (int v : t)
      for (std::size_t k = 0; k < 3; ++k)
        c[k] += torus.data.positions[static_cast<std::size_t>(v)][k] / 3;
    field.field->directions.push_back({-c[1], c[0], 0});  // around the axis: no cone anywhere
  }
  const auto text = loaded(torus.data).convert(field);
  ASSERT_TRUE(text.hasValue()) << text.error().message;
  const auto read = io::readPrescription("cones.json", *text, 4);
  ASSERT_TRUE(read.hasValue());
  EXPECT_TRUE(read->cones.empty());
  ASSERT_EQ(read->handles.size(), 2u);
  for (const auto& h : read->handles) EXPECT_EQ(h.r, 0);
}

TEST(Session, CancellingIsAFailureOfItsOwn) {
  Session session = loaded(hgp::test::icosphere(4).data);
  SolveOptions options;
  options.progress = [](const ProgressReport&) { return false; };
  const Status solved = session.parametrize(std::nullopt, options);
  ASSERT_FALSE(solved.hasValue());
  EXPECT_EQ(solved.error().code, ErrorCode::kCancelled);
}

TEST(Session, ConesTooCloseToEachOtherAreNamedByTheFilesIds) {
  // A tetrahedron first, so that nothing in the second component has the number that it has in the file.
  const MeshData first = hgp::test::tetrahedron().data;
  const auto offset = static_cast<int>(first.positions.size());
  // Few triangles to make room with for 24 cones.
  const MeshData crowded = hgp::test::pretzel(2, 3).data;
  Session session = loaded(together(first, crowded));
  const Status plain = session.parametrize(std::nullopt, {});
  ASSERT_TRUE(plain) << plain.error().message;
  // Prescribed, so that none of them is merged.
  auto cones = readPrescription("cones.json", session.conesJson(), 4);
  ASSERT_TRUE(cones) << cones.error().message;
  std::set<int> known;
  for (const prescription::PrescribedCone& cone : cones->cones)
    known.insert(static_cast<int>(cone.vertex));
  // Fifty pairs of neighbours leave a grid even less room.
  for (std::size_t f = 0; f < crowded.triangles.size() && known.size() < 124; f += 5) {
    const int a = crowded.triangles[f][0] + offset, b = crowded.triangles[f][1] + offset;
    if (known.contains(a) || known.contains(b)) continue;
    cones->cones.push_back({a, 3, {}, -1});
    cones->cones.push_back({b, 5, {}, -1});
    known.insert({a, b});
  }
  SolveOptions options;
  options.grid.mode = GridMode::kQuad;
  for (double cells : {60.0, 100.0, 140.0, 200.0, 280.0}) {
    options.grid.cells = cells;
    ASSERT_TRUE(session.parametrize(*cones, options));
    if (!session.isAligned()) break;
  }
  ASSERT_FALSE(session.isAligned());
  int inSecond = 0;
  const auto report = nlohmann::json::parse(session.reportJson());
  for (const auto& component : report["components"]) {
    if (component["grid"]["reason"].is_null()) continue;
    const auto& places = component["grid"]["reason"]["where"];
    for (const auto& pair : component["grid"]["closestCones"]) {
      const int a = pair["vertices"][0], b = pair["vertices"][1];
      EXPECT_TRUE(known.contains(a) && known.contains(b)) << a << ' ' << b;
      const nlohmann::json place{{"kind", "edge"}, {"id", a}, {"other", b}};
      EXPECT_NE(std::find(places.begin(), places.end(), place), places.end()) << places;
      inSecond += a >= offset;
    }
  }
  EXPECT_GT(inSecond, 0);
}

TEST(Session, CancellingWhileTheMapIsAlignedIsNoResult) {
  Session session = loaded(hgp::test::pretzel(2, 4).data);
  SolveOptions options;
  options.grid.cells = 2000.0;
  bool isReached = false;
  options.progress = [&](const ProgressReport& r) {
    isReached = isReached || (r.stage == Stage::kAlign && r.fraction > 0.0);
    return !isReached;
  };
  const Status solved = session.parametrize(std::nullopt, options);
  ASSERT_FALSE(solved.hasValue());
  EXPECT_TRUE(isReached);
  EXPECT_EQ(solved.error().code, ErrorCode::kCancelled);
  EXPECT_EQ(solved.error().stage, "align");
}

TEST(Session, ConesFollowTheirPositionsToAChangedFile) {
  MeshData mesh = hgp::test::icosphere(2).data;
  const Session first = loaded(mesh);
  prescription::Prescription cones;
  cones.hasCones = true;
  for (int v = 0; v < 8; ++v) cones.cones.push_back({v, 3, {}});
  Result<std::string> json = first.convert(cones);
  ASSERT_TRUE(json.hasValue());
  std::reverse(mesh.positions.begin(), mesh.positions.end());
  const int last = static_cast<int>(mesh.positions.size()) - 1;
  for (auto& t : mesh.triangles) {
    for (int& v : t) v = last - v;
  }
  const Session second = loaded(mesh);
  Result<prescription::Prescription> read = readPrescription("c.json", *json, 4);
  ASSERT_TRUE(read.hasValue());
  Result<std::string> moved = second.convert(*read);
  ASSERT_TRUE(moved.hasValue());
  Result<prescription::Prescription> found = readPrescription("c.json", *moved, 4);
  ASSERT_EQ(found->cones.size(), 8u);
  for (const prescription::PrescribedCone& c : found->cones) EXPECT_GE(c.vertex, last - 7);
  read->cones[0].position = Vec3{5, 5, 5};
  EXPECT_FALSE(second.convert(*read).hasValue());
}

TEST(Session, RawArraysAreAcceptedAsAModel) {
  const MeshData mesh = hgp::test::icosphere(2).data;
  Session session;
  ASSERT_TRUE(session.loadArrays(mesh.positions, mesh.triangles, {}).hasValue());
  ASSERT_TRUE(session.parametrize(std::nullopt, {}).hasValue());
  EXPECT_TRUE(session.isCertified());
  EXPECT_FALSE(Session().loadArrays(mesh.positions, {{0, 1, 99999}}, {}).hasValue());
}

TEST(Session, AnUncertifiedMapIsOnlyWrittenOnRequest) {
  Session session = loaded(hgp::test::disk(2).data);
  EXPECT_EQ(session.write({}).error().code, ErrorCode::kUsage);
}

TEST(ErrorJson, NamesCodePlaceAndMessage) {
  const std::string json = errorJson(
      {ErrorCode::kPrescription, "prescription", "Σ = 7 \xff", {{Where::Kind::kEdge, 3, 9}}});
  EXPECT_TRUE(contains(json, "\"code\": \"prescription\""));
  EXPECT_TRUE(contains(json, "\"other\": 9"));
}

}  // namespace
}  // namespace hgp::api

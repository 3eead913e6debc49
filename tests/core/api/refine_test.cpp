#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hgp/api/model/load_model.h"
#include "hgp/api/session.h"
#include "hgp/api/session/refined_model.h"
#include "hgp/base/turns.h"
#include "hgp/prescription/cones.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

using Json = nlohmann::json;

Session loadedAs(const std::string& name, const MeshData& mesh) {
  io::FileSet files;
  files.name = name;
  files.main = io::writePlainObj(mesh, {}, "");
  Session session;
  const Status done = session.load(std::move(files), {});
  EXPECT_TRUE(done.hasValue()) << (done ? "" : done.error().message);
  return session;
}

/// Two neighbours with 2π·9/4 each among five triangles: the two triangles between them would have to
/// give each at least 4.5π − 3π, together 3π, and have 2π.
prescription::Prescription impossible() {
  prescription::Prescription asked;
  asked.q = 4;
  asked.hasCones = true;
  const TriMesh mesh = test::icosphere(1).mesh();
  const HalfedgeId h = mesh.halfedge(EdgeId(0));
  asked.cones = {{mesh.tail(h).i, 9, {}}, {mesh.head(h).i, 9, {}}};
  for (int v = 0; asked.cones.size() < 8; ++v)
    if (v != asked.cones[0].vertex && v != asked.cones[1].vertex) asked.cones.push_back({v, 1, {}});
  return asked;
}

TEST(Refine, MapsWhatTheTriangulationForbidsAndWritesTheFinerMesh) {
  Session session = loadedAs("ball.obj", test::icosphere(1).data);
  SolveOptions options;
  ASSERT_TRUE(session.parametrize(impossible(), options).hasValue());
  EXPECT_FALSE(session.isCertified());
  EXPECT_NE(session.reportJson().find("\"refine-offered\""), std::string::npos) << "it is offered";
  EXPECT_TRUE(Json::parse(session.reportJson())["refined"].is_null());

  options.refines = true;
  ASSERT_TRUE(session.parametrize(impossible(), options).hasValue());
  ASSERT_TRUE(session.isCertified());
  const Json report = Json::parse(session.reportJson());
  const Json& refined = report["refined"];
  ASSERT_TRUE(refined.is_object());
  EXPECT_EQ(report["input"]["triangles"], 20);
  EXPECT_EQ(static_cast<std::size_t>(refined["triangles"]), session.triangles().size() / 3);
  EXPECT_EQ(12 + static_cast<int>(refined["edges"]), static_cast<int>(refined["vertices"]));
  EXPECT_GT(static_cast<int>(refined["roundsBefore"]), 0);
  EXPECT_FALSE(refined["where"].empty());
  EXPECT_NE(session.reportJson().find("\"refined\""), std::string::npos);

  // The verdict is about the file: read again, asked the same of the same vertices.
  WriteOptions write;
  write.name = "out.obj";
  Result<WrittenMap> written = session.write(write);
  ASSERT_TRUE(written.hasValue());
  io::FileSet files;
  files.name = "out.obj";
  files.main = written->files[0].bytes;
  Session again;
  ASSERT_TRUE(again.load(std::move(files), {}).hasValue());
  EXPECT_EQ(again.triangles().size(), session.triangles().size());
  Result<Verdict> verdict = again.verify(impossible(), {});
  ASSERT_TRUE(verdict.hasValue());
  EXPECT_TRUE(verdict->isGood) << verdict->json;

  // The session is still of the file that was loaded.
  options.refines = false;
  ASSERT_TRUE(session.parametrize(std::nullopt, options).hasValue());
  EXPECT_EQ(session.triangles().size(), 60u);
}

TEST(Refine, AStoredResultComesWithItsSurface) {
  Session session = loadedAs("ball.obj", test::icosphere(1).data);
  SolveOptions options;
  options.refines = true;
  ASSERT_TRUE(session.parametrize(impossible(), options).hasValue());
  const std::vector<std::uint32_t> triangles = session.triangles();
  const std::vector<double> uv = session.uv();
  const StoredResult refined = session.result();
  ASSERT_TRUE(session.parametrize(std::nullopt, {}).hasValue());
  EXPECT_EQ(session.triangles().size(), 60u);
  ASSERT_TRUE(session.use(refined));
  EXPECT_EQ(session.triangles(), triangles);
  EXPECT_EQ(session.uv(), uv);
}

TEST(Refine, DoesNothingWhereThereIsAMap) {
  Session session = loadedAs("ball.obj", test::icosphere(4).data);
  SolveOptions options;
  options.refines = true;
  ASSERT_TRUE(session.parametrize(std::nullopt, options).hasValue());
  ASSERT_TRUE(session.isCertified());
  EXPECT_TRUE(Json::parse(session.reportJson())["refined"].is_null());
  EXPECT_EQ(session.triangles().size(), 3 * test::icosphere(4).data.triangles.size());
}

TEST(Refine, RefusesFramesOfAFile) {
  Session session = loadedAs("ball.obj", test::icosphere(2).data);
  SolveOptions options;
  options.refines = true;
  options.frames = FrameSource::kFile;
  const Status done = session.parametrize(impossible(), options);
  ASSERT_FALSE(done.hasValue());
  EXPECT_EQ(done.error().code, ErrorCode::kUsage);
}

/// Where the middle of a face lies around the axis of the torus, and around its tube.
std::array<double, 2> anglesOf(const TriMesh& mesh, FaceId f) {
  Vec3 c{};
  for (VertexId v : mesh.corners(f))
    for (std::size_t i = 0; i < 3; ++i) c[i] += mesh.position(v)[i] / 3;
  return {std::atan2(c[1], c[0]), std::atan2(c[2], std::hypot(c[0], c[1]) - 1.0)};
}

/// How often a dual loop winds around both, from positions.
std::array<int, 2> windings(const TriMesh& mesh, const DualLoop& loop) {
  std::array<double, 2> sum{0.0, 0.0};
  for (HalfedgeId h : loop.crossed) {
    const auto a = anglesOf(mesh, TriMesh::face(h)),
               b = anglesOf(mesh, TriMesh::face(mesh.twin(h)));
    for (std::size_t i = 0; i < 2; ++i) sum[i] += std::remainder(b[i] - a[i], 2 * M_PI);
  }
  return {static_cast<int>(std::lround(sum[0] / (2 * M_PI))),
          static_cast<int>(std::lround(sum[1] / (2 * M_PI)))};
}

/// Matchings of a field that turns by m around the axis and by n around the tube.
FrameField fieldTurning(const TriMesh& mesh, int q, int m, int n) {
  FrameField field;
  field.q = q;
  field.matching = PerHalfedge<int>(static_cast<std::size_t>(mesh.halfedgeCount()), 0);
  for (HalfedgeId h : mesh.halfedges()) {
    const auto a = anglesOf(mesh, TriMesh::face(h)),
               b = anglesOf(mesh, TriMesh::face(mesh.twin(h)));
    const auto cuts = [&](std::size_t i) {
      const double step = b[i] - a[i];
      return static_cast<int>(std::lround((step - std::remainder(step, 2 * M_PI)) / (2 * M_PI)));
    };
    field.matching[h] = -(m * cuts(0) + n * cuts(1));
  }
  return field;
}

TEST(Refine, CarriesHandleRotationsToTheGeneratorsOfTheFinerMesh) {
  int changed = 0;
  for (int seed = 0; seed < 6; ++seed) {
    const test::Shape torus = test::scattered(test::torus(9, 7), static_cast<unsigned>(seed + 1));
    io::FileSet files;
    files.name = "torus.obj";
    files.main = io::writePlainObj(torus.data, {}, "");
    Result<Model> model = loadModel(std::move(files), {});
    ASSERT_TRUE(model.hasValue());
    const ModelComponent& before = model->components[0];
    // Without cones the rotation of a loop depends on its homology class alone.
    const int m = 1 + seed % 5, n = 4 - seed % 3;
    const FrameField field = fieldTurning(before.mesh, 6, m, n);
    Request request;
    request.q = 6;
    request.components.emplace_back();
    request.components[0].spec.q = 6;
    for (const DualLoop& loop : handleGenerators(before.mesh))
      request.components[0].spec.handles.push_back(loopHolonomy(field, loop));
    SplitPlace place{"test", {}};
    for (EdgeId e : before.mesh.edges())
      if ((e.i * 7 + seed) % 3 != 0) place.edges.push_back(e);
    Result<RefinedModel> refined = refine(*model, {{place}});
    ASSERT_TRUE(refined.hasValue()) << refined.error().message;
    Result<Request> carried = carryOver(*model, request, {field}, *refined);
    ASSERT_TRUE(carried.hasValue()) << carried.error().message;
    const TriMesh& after = refined->model.components[0].mesh;
    const auto loops = handleGenerators(after);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto w = windings(after, loops[i]);
      const std::optional<int> r = carried->components[0].spec.handles[i];
      EXPECT_EQ(r, reduceTurn(m * w[0] + n * w[1], 6)) << "seed " << seed << ", generator " << i;
      changed += r != request.components[0].spec.handles[i];
    }
  }
  EXPECT_GT(changed, 0) << "the generators of the finer mesh are never others: nothing was tested";
}

}  // namespace
}  // namespace hgp::api

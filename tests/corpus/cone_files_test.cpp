// Problems that others have published: fields with stored matchings, and tables of total angles.
#include <gtest/gtest.h>

#include "corpus/corpus.h"

namespace hgp {
namespace {

std::vector<ConePoint> conesOf(const prescription::Prescription& file) {
  std::vector<ConePoint> cones;
  for (const prescription::PrescribedCone& cone : file.cones)
    cones.push_back({VertexId(cone.vertex), cone.k});
  return cones;
}

/// The prescription of a file with everything that it decides.
Result<CompleteSpec> specOfFile(const TriMesh& mesh, const prescription::Prescription& file) {
  FieldData field = *file.field;
  field.order = file.q;
  return readHolonomy(mesh, field, conesOf(file));
}

void expectSolvedAsAsked(const std::string& meshName, const std::string& conesName, int q) {
  SCOPED_TRACE(conesName);
  if (!test::hasFile(conesName) || !test::hasFile(meshName))
    GTEST_SKIP() << "SKIPPED: " << test::corpusFolder() << "/" << conesName << " is not there";
  const TriMesh mesh = test::meshOfFile(meshName);
  const auto file = io::readPrescription(conesName, test::textOf(conesName), q);
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->q, q);
  ASSERT_TRUE(file->field && file->field->hasMatchings);
  const Result<CompleteSpec> spec = specOfFile(mesh, *file);
  ASSERT_TRUE(spec) << spec.error().message;
  ASSERT_EQ(spec->cones.size(), file->cones.size());
  const Result<Parametrization> p = parametrize(mesh, toSpec(*spec), {});
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_TRUE(p->isCertified);
  EXPECT_EQ(p->spec.handles, spec->handles) << "stored matchings are realised";
  EXPECT_EQ(p->spec.turning, spec->turning);
  for (const MeasuredHandle& handle : p->certificate.seams.handles)
    EXPECT_EQ(handle.measured, spec->handles[static_cast<std::size_t>(handle.index)]);
  for (std::size_t i = 0; i < spec->cones.size(); ++i) {
    EXPECT_EQ(p->certificate.angles.cones[i].vertex, spec->cones[i].vertex);
    EXPECT_EQ(p->certificate.angles.cones[i].measured, spec->cones[i].k);
  }
}

TEST(ConeFiles, EightIsCertifiedWithItsMatchings) {
  expectSolvedAsAsked("Directional/eight.off", "cones/Directional__eight.cones", 4);
}

TEST(ConeFiles, TrainStationOfOrderFiveIsCertifiedWithItsMatchings) {
  expectSolvedAsAsked("Directional/train-station.off", "cones/Directional__train-station-5.cones",
                      5);
}

TEST(ConeFiles, VaseOfOrderSevenIsCertifiedWithItsMatchings) {
  expectSolvedAsAsked("Directional/vase.off", "cones/Directional__vase-7.cones", 7);
}

TEST(ConeFiles, HexTorusWithoutConesIsCertified) {
  expectSolvedAsAsked("Directional/torus.obj", "cones/Directional__torus-hex.cones", 6);
}

/// Directions alone, as the file has them, both for the holonomy and as frames.
/// @param rounds  1, or 2 where the harmonic map without frames is not yet right, and on flat tori, whose harmonic map is
///                always compared
void expectCertifiedWithOwnFrames(const std::string& meshName, const std::string& fieldName,
                                  std::size_t rounds = 1) {
  SCOPED_TRACE(fieldName);
  if (!test::hasFile(fieldName) || !test::hasFile(meshName))
    GTEST_SKIP() << "SKIPPED: " << test::corpusFolder() << "/" << fieldName << " is not there";
  const TriMesh mesh = test::meshOfFile(meshName);
  const auto file = prescription::readRawField(test::textOf(fieldName));
  ASSERT_TRUE(file) << file.error().message;
  const Result<CompleteSpec> spec = readHolonomy(mesh, *file->field);
  ASSERT_TRUE(spec) << spec.error().message;
  ParametrizeOptions options;
  options.frames = file->field;
  const Result<Parametrization> p = parametrize(mesh, toSpec(*spec), options);
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_TRUE(p->isCertified);
  EXPECT_EQ(p->rounds.size(), rounds);
  EXPECT_EQ(p->spec.handles, spec->handles);
  EXPECT_LT(p->certificate.distortion.meanMu, 0.2);
}

TEST(FieldFiles, TrainStationOfOrderFiveIsCertifiedWithItsOwnFrames) {
  expectCertifiedWithOwnFrames("Directional/train-station.off",
                               "Directional/train-station-5.rawfield");
}

TEST(FieldFiles, VaseOfOrderSevenIsCertifiedWithItsOwnFrames) {
  expectCertifiedWithOwnFrames("Directional/vase.off", "Directional/vase-7.rawfield");
}

TEST(FieldFiles, HexTorusIsCertifiedWithItsOwnFrames) {
  expectCertifiedWithOwnFrames("Directional/torus.obj", "Directional/torus-hex.rawfield", 2);
}

#ifndef __EMSCRIPTEN__  // the field is packed
TEST(FieldFiles, EightIsCertifiedWithItsOwnFrames) {
  expectCertifiedWithOwnFrames("Directional/eight.off", "Directional/eight.rawfield.gz", 2);
}
#endif

TEST(ConeFiles, TorusWithAThreeAndAFiveIsRefusedWithTheReason) {
  const std::string name = "cones/Directional__torus_twosings.cones";
  if (!test::hasFile(name))
    GTEST_SKIP() << "SKIPPED: " << test::corpusFolder() << "/" << name << " is not there";
  const TriMesh mesh = test::meshOfFile("Directional/torus.obj");
  const auto file = io::readPrescription(name, test::textOf(name), 4);
  ASSERT_TRUE(file) << file.error().message;
  const Result<CompleteSpec> spec = specOfFile(mesh, *file);
  ASSERT_TRUE(spec) << spec.error().message;
  const Result<Parametrization> p = parametrize(mesh, toSpec(*spec), {});
  ASSERT_FALSE(p);
  EXPECT_EQ(p.error().code, ErrorCode::kPrescription);
  EXPECT_NE(p.error().message.find("torus"), std::string::npos) << p.error().message;
}

void expectTotalAngles(const std::string& meshName, const std::string& anglesName) {
  SCOPED_TRACE(anglesName);
  if (!test::hasFile(anglesName) || !test::hasFile(meshName))
    GTEST_SKIP() << "SKIPPED: " << test::corpusFolder() << "/" << anglesName << " is not there";
  const TriMesh mesh = test::meshOfFile(meshName);
  const Topology topology = computeTopology(mesh);
  ASSERT_EQ(topology.componentCount, 1);
  const auto file = io::readPrescription(anglesName, test::textOf(anglesName), 4);
  ASSERT_TRUE(file) << file.error().message;
  const auto reduced = prescription::reduceTotalAngles(*file, mesh, topology, {});
  ASSERT_TRUE(reduced) << reduced.error().message;
  HolonomySpec spec;
  spec.q = 4;
  spec.cones = conesOf(*reduced);
  spec.turning.resize(topology.loops.size());
  for (const prescription::PrescribedTurning& turning : reduced->boundaries)
    spec.turning[static_cast<std::size_t>(turning.loop)] = turning.l;
  const Result<Parametrization> p = parametrize(mesh, spec, {});
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_TRUE(p->isCertified);
  for (std::size_t j = 0; j < spec.turning.size(); ++j)
    EXPECT_EQ(p->certificate.angles.turnings[j].measured, *spec.turning[j]);
}

TEST(TotalAngles, AircraftIsCertifiedWithItsLoopTotals) {
  expectTotalAngles("ConformalIdealDelaunay/aircraft.obj",
                    "ConformalIdealDelaunay/aircraft_Th_hat");
}

#ifndef __SANITIZE_ADDRESS__  // tens of thousands of triangles: minutes there
TEST(TotalAngles, FertilityIsCertified) {
  expectTotalAngles("ConformalIdealDelaunay/fertility_tri.obj",
                    "ConformalIdealDelaunay/fertility_tri_Th_hat");
}

#ifndef __EMSCRIPTEN__  // the mesh is packed
TEST(TotalAngles, ElephantIsCertified) {
  expectTotalAngles("ConformalIdealDelaunay/elephant.obj.gz",
                    "ConformalIdealDelaunay/elephant_Th_hat");
}
#endif
#endif

}  // namespace
}  // namespace hgp

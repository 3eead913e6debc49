// Random prescriptions, uniform over those that pass the check: how many are certified is measured,
// and asserted.
#include <gtest/gtest.h>

#include <cstdio>

#include "corpus/corpus.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

struct Rate {
  int certified = 0, all = 0;
  std::string missed;
};

void draw(const std::string& name, const TriMesh& mesh, int q, int cones, int draws,
          std::mt19937& random, Rate& rate) {
  const Topology topology = computeTopology(mesh);
  for (int n = 0; n < draws; ++n) {
    const auto spec = test::randomSpec(mesh, topology, {q, cones, false, false}, random);
    if (!spec) continue;
    const Result<Parametrization> p = parametrize(mesh, *spec, {});
    ++rate.all;
    if (p && p->isCertified) {
      ++rate.certified;
    } else {
      rate.missed += " " + name + "/q=" + std::to_string(q) + "/" + std::to_string(cones) +
                     (p ? "" : "(" + p.error().message + ")");
    }
  }
}

void expectNineInTen(const char* where, const Rate& rate) {
  std::printf("random prescriptions, %s: %d of %d certified; not:%s\n", where, rate.certified,
              rate.all, rate.missed.c_str());
  EXPECT_GE(10 * rate.certified, 9 * rate.all) << where << rate.missed;
}

const Rate& rateOnGeneratedSurfaces() {
  static const Rate all = [] {
    std::mt19937 random(131);
    Rate rate;
    for (const test::Shape& shape :
         {test::jittered(test::icosphere(8), 0.01), test::torus(30, 18), test::doubleTorus(4),
          test::pretzel(3, 4), test::pretzel(5, 3), test::disk(10),
          test::withoutFaces(test::jittered(test::icosphere(7), 0.01), {0, 400})}) {
      const TriMesh mesh = shape.mesh();
      for (int cones : {3, 4, 6, 8, 12, 16, 32})
        draw(shape.name, mesh, 4, cones, test::isFullRun() ? 4 : 1, random, rate);
    }
    return rate;
  }();
  return all;
}

TEST(RandomPrescriptions, NineInTenAreCertifiedOnGeneratedSurfaces) {
  EXPECT_GT(rateOnGeneratedSurfaces().all, 40);
  expectNineInTen("generated surfaces", rateOnGeneratedSurfaces());
}

TEST(RandomPrescriptions, NineInTenAreCertifiedWithRealMeshesAmongThem) {
  std::mt19937 random(137);
  Rate real;
  for (const char* name : {"Directional/torus.obj", "Directional/vase.off",
                           "Directional/train-station.off", "Directional/eight.off"}) {
    if (!test::hasFile(name))
      GTEST_SKIP() << "SKIPPED: " << test::corpusFolder() << "/" << name << " is not there";
    const TriMesh mesh = test::meshOfFile(name);
    for (int cones : {3, 6, 12, 24})
      draw(name, mesh, 4, cones, test::isFullRun() ? 4 : 1, random, real);
  }
  EXPECT_GT(real.all, 12);
  std::printf("random prescriptions, real meshes alone: %d of %d\n", real.certified, real.all);
  // Sixteen draws are too few for a rate of their own.
  Rate all = rateOnGeneratedSurfaces();
  all.certified += real.certified;
  all.all += real.all;
  all.missed += real.missed;
  expectNineInTen("generated and real", all);
}

}  // namespace
}  // namespace hgp

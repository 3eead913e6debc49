// Surfaces of very thin triangles whose programs take long under sanitizers; a milder one is in
// tests/core/parametrize/metrics_test.cpp.
#include <gtest/gtest.h>

#include "core/parametrize/stretched.h"

namespace hgp {
namespace {

using test::evenedRounds;
using test::manyCones;
using test::stretched;

TEST(Metrics, TrianglesStretchedFiveThousandTimesAreMapped) {
  const TriMesh mesh = stretched(5000.0);
  const Result<Parametrization> p = parametrize(mesh, manyCones(mesh), {});
  ASSERT_TRUE(p) << p.error().message;
  ASSERT_TRUE(p->isCertified);
  EXPECT_TRUE(certify(mesh, p->spec, p->map).isCertified);
  EXPECT_LE(p->rounds.size(), 24u);
}

TEST(Metrics, RoundsOfBothAreCountedTogether) {
  const TriMesh mesh = stretched(200.0);
  ParametrizeOptions options;
  options.maxRounds = 9;
  const Result<Parametrization> p = parametrize(mesh, manyCones(mesh), options);
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_LE(p->rounds.size(), 9u);
  EXPECT_LE(evenedRounds(*p), 1);
}

}  // namespace
}  // namespace hgp

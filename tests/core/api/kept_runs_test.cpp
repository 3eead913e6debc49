// The same prescription, undo and redo return the kept result; its bytes are those of a new session.
#include "hgp/api/session/kept_runs.h"

#include <gtest/gtest.h>

#include "hgp/api/session.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

struct Counted {
  SolveOptions options;
  int reports = 0;
  Counted() {
    options.progress = [this](const ProgressReport&) {
      ++reports;
      return true;
    };
  }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
};

Session loaded(const test::Shape& shape) {
  Session session;
  EXPECT_TRUE(session.loadArrays(shape.data.positions, shape.data.triangles, {}));
  return session;
}

prescription::Prescription octahedralCones(int moved) {
  prescription::Prescription cones;
  cones.q = 4;
  cones.hasCones = true;
  for (const int v : {0, 1, 2, 3, 4, 5, 6, moved}) cones.cones.push_back({v, 3, {}});
  return cones;
}

TEST(KeptRuns, UndoAndRedoSolveNothingAndHaveTheBytesOfANewSession) {
  const test::Shape shape = test::jittered(test::icosphere(4), 0.02);
  Session session = loaded(shape);
  Counted on;
  std::vector<std::string> certificates;
  std::vector<std::vector<double>> maps;
  const int moved[] = {20, 21, 22};
  for (const int v : moved) {
    ASSERT_TRUE(session.parametrize(octahedralCones(v), on.options));
    certificates.push_back(session.certificateJson());
    maps.push_back(session.uv());
  }
  EXPECT_NE(maps[0], maps[1]);
  for (const std::size_t i : {1u, 0u, 1u, 2u, 2u}) {
    on.reports = 0;
    ASSERT_TRUE(session.parametrize(octahedralCones(moved[i]), on.options));
    EXPECT_EQ(on.reports, 1) << "nothing is computed";
    Session other = loaded(shape);
    ASSERT_TRUE(other.parametrize(octahedralCones(moved[i]), {}));
    EXPECT_EQ(session.uv(), other.uv());
    EXPECT_EQ(session.uv(), maps[i]);
    EXPECT_EQ(session.certificateJson(), other.certificateJson());
    EXPECT_EQ(session.conesJson(), other.conesJson());
  }
}

TEST(KeptRuns, AreNotFoundForOtherArgumentsOrAnotherSurface) {
  Session session = loaded(test::icosphere(3));
  Counted on;
  const auto isComputed = [&](const std::optional<prescription::Prescription>& prescription) {
    on.reports = 0;
    EXPECT_TRUE(session.parametrize(prescription, on.options));
    return on.reports > 1;
  };
  EXPECT_TRUE(isComputed({}));
  EXPECT_FALSE(isComputed({}));
  on.options.scale = Scale::kUnit;
  EXPECT_TRUE(isComputed({}));
  on.options.improve = ImproveOptions{};
  EXPECT_TRUE(isComputed({}));
  on.options.improve->balance = 0.5;
  EXPECT_TRUE(isComputed({}));
  EXPECT_FALSE(isComputed({}));
  setReproducible(true);
  EXPECT_TRUE(isComputed({})) << "on processors with fused multiply-add, the bytes differ";
  setReproducible(false);
  EXPECT_FALSE(isComputed({}));
  prescription::Prescription cones = octahedralCones(7);
  EXPECT_TRUE(isComputed(cones));
  std::swap(cones.cones[0], cones.cones[1]);
  EXPECT_TRUE(isComputed(cones)) << "notes and order are those of the arguments";
  const test::Shape other = test::icosphere(3);
  ASSERT_TRUE(session.loadArrays(other.data.positions, other.data.triangles, {}));
  EXPECT_TRUE(isComputed(cones));
}

TEST(KeptRuns, CanBeCancelledAndTheOldestAreDropped) {
  Session session = loaded(test::icosphere(2));
  ASSERT_TRUE(session.parametrize({}, {}));
  SolveOptions cancel;
  cancel.progress = [](const ProgressReport&) { return false; };
  const Status done = session.parametrize({}, cancel);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kCancelled);
  KeptRuns<int> runs;
  const auto key = [](int q) {
    RunKey out;
    out.options.q = q;
    return out;
  };
  for (int q = 1; q <= 13; ++q) runs.add(key(q), 1000, q);
  EXPECT_EQ(runs.find(key(1)), nullptr);
  ASSERT_NE(runs.find(key(2)), nullptr);
  runs.add(key(14), 1000, 14);
  EXPECT_NE(runs.find(key(2)), nullptr) << "found last, so that it is newer than 3";
  EXPECT_EQ(runs.find(key(3)), nullptr);
  runs.add(key(20), 600'000, 20);
  EXPECT_EQ(runs.find(key(20)), nullptr) << "too large";
}

}  // namespace
}  // namespace hgp::api

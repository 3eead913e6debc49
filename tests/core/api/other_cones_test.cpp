// Other automatic cones where the first have no map.  Laws: the purposes are tried by their number of cones, nearest
// first; the first certified result is taken with a note; nothing else changes.
#include "hgp/api/request/other_cones.h"

#include <gtest/gtest.h>

namespace hgp::api {
namespace {

Parametrization result(bool isCertified) {
  Parametrization run;
  run.isCertified = isCertified;
  return run;
}

/// Certified with cones for one purpose only; each call leaves a note, as a choice of cones may.
SolveFor certifiedFor(std::optional<ConesFor> works, std::vector<ConesFor>& calls, Notes& notes) {
  return [works, &calls, &notes](ConesFor purpose) {
    calls.push_back(purpose);
    notes = {Note("cones-count")};
    return Result<Parametrization>(result(purpose == works));
  };
}

TEST(OtherCones, AreTriedByTheirNumberUntilOneHasAMap) {
  std::vector<ConesFor> calls;
  Notes notes;
  Result<Parametrization> run = result(false);
  ASSERT_TRUE(mapWithOtherCones({}, certifiedFor(ConesFor::kFewer, calls, notes), run, notes));
  EXPECT_TRUE(run->isCertified);
  EXPECT_EQ(calls, (std::vector<ConesFor>{ConesFor::kMore, ConesFor::kFewer}));
  EXPECT_EQ(notes, (Notes{Note("cones-count"), Note("cones-other", {{"purpose", "fewer"}})}));

  SolveOptions few;
  few.conesFor = ConesFor::kFew;
  calls.clear();
  run = result(false);
  ASSERT_TRUE(mapWithOtherCones(few, certifiedFor({}, calls, notes), run, notes));
  EXPECT_EQ(calls, (std::vector<ConesFor>{ConesFor::kFewer, ConesFor::kBalanced, ConesFor::kMore,
                                          ConesFor::kLowDistortion}));
}

TEST(OtherCones, WhereNoneHasAMapResultAndNotesStay) {
  std::vector<ConesFor> calls;
  Notes notes{Note("first")};
  Result<Parametrization> run = result(false);
  run->copyOf = {VertexId(7)};
  ASSERT_TRUE(mapWithOtherCones({}, certifiedFor({}, calls, notes), run, notes));
  EXPECT_FALSE(run->isCertified);
  EXPECT_EQ(run->copyOf, std::vector{VertexId(7)});
  EXPECT_EQ(notes, Notes{Note("first")});
}

TEST(OtherCones, ACertifiedMapAndConesThatWereCountedOrAlignedAreKept) {
  std::vector<ConesFor> calls;
  Notes notes;
  Result<Parametrization> certified = result(true);
  ASSERT_TRUE(mapWithOtherCones({}, certifiedFor(ConesFor::kMore, calls, notes), certified, notes));
  SolveOptions counted, aligned;
  counted.coneCount = 8;
  aligned.alignToCurvature = true;
  for (const SolveOptions& options : {counted, aligned}) {
    Result<Parametrization> run = result(false);
    ASSERT_TRUE(
        mapWithOtherCones(options, certifiedFor(ConesFor::kMore, calls, notes), run, notes));
    EXPECT_FALSE(run->isCertified);
  }
  EXPECT_TRUE(calls.empty());
}

TEST(OtherCones, ACancelledSolveCancels) {
  const SolveFor solve = [](ConesFor) {
    return Result<Parametrization>(Failure{ErrorCode::kCancelled, "solve", "", {}});
  };
  Result<Parametrization> run = result(false);
  Notes notes;
  const Status done = mapWithOtherCones({}, solve, run, notes);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace hgp::api

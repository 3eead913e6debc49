// Notes as sentences.  Laws: a template is filled as phrase.h says; every template of the catalogue is complete.
#include "hgp/base/phrase.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "hgp/base/result.h"

namespace hgp {
namespace {

TEST(Phrase, CountsNumbersPlacesAndOptionalPartsAreFilledIn) {
  EXPECT_EQ(phrase(Note("read-glb-followed", {{"bytes", 1}})),
            "ignored: 1 byte after the end of the GLB");
  EXPECT_EQ(phrase(Note("read-glb-followed", {{"bytes", 2}})),
            "ignored: 2 bytes after the end of the GLB");
  const Note crack("crack", {{"vertices", 8}, {"gap", 2e-6}, {"weld", 2.1e-6}, {"partial", 1}});
  EXPECT_EQ(phrase(crack),
            "a crack: at least 8 boundary vertices lie within 2e-06 of another one; --weld 2.1e-06 "
            "closes it");
  const std::vector<Where> edges{{Where::Kind::kEdge, 0, 3}, {Where::Kind::kEdge, 4, 7}};
  EXPECT_EQ(phrase(Note("defect-non-manifold-edge",
                        {{"count", 9}, {"first", 1}, {"more", 1}, {"repaired", 1}}, edges)),
            "repaired: 9 edges have more than two faces (first: 0–3, 4–7, …)");
  EXPECT_EQ(phrase(Note("cones-other-number", {{"asked", 4}, {"placed", 3}, {"more", 0}})),
            "4 cones asked for, 3 placed: the mesh has no vertices for more.");
}

TEST(Phrase, UnknownCodesAndMissingValuesDoNotEndTheProgram) {
  EXPECT_EQ(phrase(Note("of-a-newer-version")), "of-a-newer-version");
  EXPECT_EQ(phrase(Note("read-stl-count")),
            "the count in the header is 0; the file holds ? triangles");
}

TEST(Phrase, SeveralNotesAreJoined) {
  EXPECT_EQ(phrase(Notes{Note("read-strips"), Note("read-line-ends")}),
            "triangle strips are read as triangles; the lines end in CR alone");
}

TEST(Phrase, DefectsAreAllTheCodesThatBeginSoAndAreJoinedAlike) {
  for (const Phrase& p : defectPhrases()) EXPECT_EQ(p.code.substr(0, 7), "defect-");
  for (const std::span<const Phrase> others : {mapPhrases(), otherPhrases()})
    for (const Phrase& p : others) EXPECT_NE(p.code.substr(0, 7), "defect-");
  const Notes two{Note("defect-zero-area", {{"count", 2}}), Note("defect-extent")};
  EXPECT_EQ(phraseDefects(two), phrase(two));
}

TEST(Phrase, EveryTemplateIsWellFormedAndItsCodeUnique) {
  std::set<std::string_view> codes;
  std::vector<Phrase> all(defectPhrases().begin(), defectPhrases().end());
  for (const std::span<const Phrase> others : {mapPhrases(), otherPhrases()})
    all.insert(all.end(), others.begin(), others.end());
  for (const Phrase& p : all) {
    EXPECT_TRUE(codes.insert(p.code).second) << p.code;
    // Throws where a bracket is not closed.
    EXPECT_FALSE(phrase(Note(std::string(p.code))).empty()) << p.code;
    for (const char bracket : {']', '}'})
      EXPECT_EQ(phrase(Note(std::string(p.code))).find(bracket), std::string::npos) << p.code;
  }
}

TEST(Told, TheMessageIsFollowedByItsAdvice) {
  Failure failure{ErrorCode::kLimit, "read", "more than the limit of 3 triangles.", {}};
  EXPECT_EQ(told(failure), failure.message);
  failure.advice = {Note("raise-triangles")};
  EXPECT_EQ(told(failure),
            "more than the limit of 3 triangles. Raise it by --max-triangles (limits.triangles).");
}

}  // namespace
}  // namespace hgp

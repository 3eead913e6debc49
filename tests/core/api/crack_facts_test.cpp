// Boundaries that run alongside each other without being joined, and the bound of the search for them.
#include <gtest/gtest.h>

#include "hgp/api/model/needed_repairs.h"
#include "support/notes.h"

namespace hgp {
namespace {

/// Two strips side by side: one long edge below, `squares` short ones above, so that all but two of the upper
/// strip's vertices lie inside the lower one's edge.
MeshData stripsWithTJunctions(int squares) {
  MeshData mesh;
  const double length = squares;
  mesh.positions = {{0, -1, 0}, {length, -1, 0}, {length, 0, 0}, {0, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (int i = 0; i <= squares; ++i) {
    // The ends are the corners of the lower strip, so that the strips are joined there.
    mesh.positions.push_back({1.0 * i, 1, 0});
    if (i > 0 && i < squares) mesh.positions.push_back({1.0 * i, 0, 0});
  }
  const auto above = [](int i) { return i == 0 ? 4 : 3 + 2 * i; };
  const auto below = [&](int i) { return i == 0 ? 3 : i == squares ? 2 : 4 + 2 * i; };
  for (int i = 0; i < squares; ++i) {
    mesh.triangles.push_back({below(i), below(i + 1), above(i + 1)});
    mesh.triangles.push_back({below(i), above(i + 1), above(i)});
  }
  return mesh;
}

TEST(CrackFacts, VerticesOnALongEdgeAreFound) {
  for (const int squares : {5, 20}) {
    const api::CrackFacts facts = api::crackFacts(stripsWithTJunctions(squares));
    EXPECT_EQ(facts.onEdges, squares - 1);
    EXPECT_EQ(facts.vertices, 0);
    EXPECT_EQ(facts.edgeGap, 0.0);
    EXPECT_FALSE(facts.isPartial);
  }
}

TEST(CrackFacts, TheSearchEndsAtItsBoundAndSaysSo) {
  const MeshData mesh = stripsWithTJunctions(20);
  const api::CrackFacts facts = api::crackFacts(mesh, 100);
  EXPECT_TRUE(facts.isPartial);
  EXPECT_GT(facts.onEdges, 0);
  EXPECT_LT(facts.onEdges, 19);
  const Notes notes = api::crackNotes(facts);
  ASSERT_EQ(test::codesOf(notes), test::Codes{"t-junctions"});
  EXPECT_EQ(*notes[0].find("partial"), NoteValue("partial", 1));
}

}  // namespace
}  // namespace hgp

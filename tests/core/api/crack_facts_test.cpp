// Boundaries that run alongside each other without being joined, and the bound of the search for them.
#include <gtest/gtest.h>

#include "hgp/api/model/cracks.h"
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

/// Two rows of squares, the second `gap` above the first.
MeshData rowsOfSquares(int squares, double gap, double height) {
  MeshData mesh;
  for (const double y : {0.0, height, height + gap, 2 * height + gap})
    for (int i = 0; i <= squares; ++i) mesh.positions.push_back({1.0 * i, y, 0});
  const int row = squares + 1;
  for (const int first : {0, 2 * row})
    for (int i = first; i < first + squares; ++i) {
      mesh.triangles.push_back({i, i + 1, i + row + 1});
      mesh.triangles.push_back({i, i + row + 1, i + row});
    }
  return mesh;
}

TEST(CrackFacts, AWeldIsAdvisedThatClosesTheCrack) {
  const api::CrackFacts facts = api::crackFacts(rowsOfSquares(6, 1e-3, 1.0));
  EXPECT_EQ(facts.vertices, 14);
  EXPECT_DOUBLE_EQ(facts.gap, 1.0 + 1e-3 - 1.0);
  EXPECT_GT(facts.weld, facts.gap);
  EXPECT_LT(facts.weld, 1.2e-3);
  EXPECT_EQ(facts.spoiled, 0);
  EXPECT_EQ(std::get<double>(api::crackNotes(facts).at(0).find("weld")->value), facts.weld);
}

TEST(CrackFacts, NoWeldIsAdvisedThatWouldCollapseTriangles) {
  // Rows that are lower than the gap between them is wide.
  const api::CrackFacts facts = api::crackFacts(rowsOfSquares(6, 1e-3, 5e-4));
  EXPECT_GT(facts.vertices, 14);
  EXPECT_EQ(facts.weld, 0.0);
  EXPECT_EQ(facts.spoiled, 24) << "all there are";
}

TEST(CrackFacts, NoWeldIsAdvisedThatWouldLayTrianglesOnOthers) {
  MeshData mesh = rowsOfSquares(2, 1.0, 1.0);
  const auto row = static_cast<int>(mesh.positions.size()) / 4;
  for (int i = 0; i < 2 * row; ++i) {  // the second row lies 1e-3 above the first
    Vec3 p = mesh.positions[static_cast<std::size_t>(i)];
    p[2] = 1e-3;
    mesh.positions[static_cast<std::size_t>(2 * row + i)] = p;
  }
  const api::CrackFacts facts = api::crackFacts(mesh);
  EXPECT_EQ(facts.vertices, 4 * row);
  EXPECT_EQ(facts.weld, 0.0);
  EXPECT_GE(facts.spoiled, 4);
  EXPECT_LE(facts.spoiled, static_cast<int>(mesh.triangles.size()));
}

}  // namespace
}  // namespace hgp

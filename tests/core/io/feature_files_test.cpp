// Lists of feature edges in files.
#include "hgp/prescription/feature_files.h"

#include <gtest/gtest.h>

#include "hgp/prescription/cones.h"

namespace hgp::io {
namespace {

using Pair = std::array<int, 2>;

TEST(FeatureFiles, SharpListsSidesOfTriangles) {
  const Result<prescription::PrescribedFeatures> read =
      prescription::readFeatures("part.sharp", "3\n1,0,2\r\n0, 7, 1\n1,8,0\n");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->sides, (std::vector<Pair>{{0, 2}, {7, 1}, {8, 0}}));
  EXPECT_TRUE(read->lines.empty());
}

TEST(FeatureFiles, ObjLinesAreCountedFromOne) {
  const Result<prescription::PrescribedFeatures> read =
      prescription::readFeatures("part.obj", "v 0 0 0\nl 1 2 3\nf 1 2 3\nl 4 1\n");
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->lines.size(), 2u);
  EXPECT_EQ(read->lines[0].vertices, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(read->lines[1].vertices, (std::vector<int>{3, 0}));
}

TEST(FeatureFiles, OtherwiseRowsAreTwoVertices) {
  const Result<prescription::PrescribedFeatures> read =
      prescription::readFeatures("edges.txt", "# creases\n\n0 4\n4,\t9 # last\n");
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->lines.size(), 2u);
  EXPECT_EQ(read->lines[1].vertices, (std::vector<int>{4, 9}));
}

TEST(FeatureFiles, WrongRowsAreNamed) {
  const struct {
    const char *name, *text;
    int line;
  } wrong[] = {{"a.sharp", "2\n1,0,2\n", 1},
               {"a.sharp", "1\n1,0,3\n", 2},
               {"a.sharp", "x\n", 1},
               {"a.sharp", "1\n1,0\n", 2},
               {"a.sharp", "1\n0,-1,0\n", 2},
               {"a.obj", "v 0 0 0\nl 0 1\n", 2},
               {"a.obj", "l 3 3\n", 1},
               {"a.obj", "l 3\n", 1},
               {"a.obj", "l 1/1 2/2\n", 1},
               {"a.txt", "0 1\n2\n", 2},
               {"a.txt", "0 0\n", 1},
               {"a.txt", "0 1 2\n", 1},
               {"a.txt", "1 99999999999999999999\n", 1}};
  for (const auto& [name, text, line] : wrong) {
    const Result<prescription::PrescribedFeatures> read = prescription::readFeatures(name, text);
    ASSERT_FALSE(read) << name << ": " << text;
    EXPECT_EQ(read.error().code, ErrorCode::kMalformed);
    ASSERT_FALSE(read.error().where.empty()) << text;
    EXPECT_EQ(read.error().where[0].id, line) << text;
  }
}

TEST(FeatureFiles, FeaturesAreStoredWithCones) {
  prescription::Prescription p;
  p.hasCones = true;
  p.features.hasRims = true;
  p.features.lines = {{{3, 1, 4}, {{0, 0, 0}, {0.1, 0, 1}, {1, 2, 3}}}, {{5, 9}}};
  const Result<prescription::Prescription> read =
      prescription::readConesJson(prescription::writeConesJson(p));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(read->features.hasRims);
  ASSERT_EQ(read->features.lines.size(), 2u);
  EXPECT_EQ(read->features.lines[0].vertices, p.features.lines[0].vertices);
  EXPECT_EQ(read->features.lines[0].positions, p.features.lines[0].positions);
  EXPECT_TRUE(read->features.lines[1].positions.empty());
  const Result<prescription::PrescribedFeatures> alone =
      prescription::readFeatures("x.json", prescription::writeConesJson(p));
  ASSERT_TRUE(alone);
  EXPECT_EQ(alone->lines.size(), 2u);
  p.features = {};
  EXPECT_EQ(prescription::writeConesJson(p).find("features"), std::string::npos);
}

TEST(FeatureFiles, AListInJsonKnowsTheFileItIsFor) {
  prescription::Prescription p;
  p.sha256 = std::string(64, 'a');
  p.features.lines = {{{3, 1, 4}}};
  const auto list = prescription::readFeatures("x.json", prescription::writeConesJson(p));
  ASSERT_TRUE(list);
  EXPECT_EQ(list->sha256, p.sha256);
}

TEST(FeatureFiles, WhatIsAskedForComesBeforeThePrescriptionAndThisBeforeTheList) {
  using Mark = prescription::FeatureMark;
  prescription::PrescribedFeatures own, list, asked;
  own.lines = {{{0, 1}}};
  own.creaseDegrees = 20;
  list.lines = {{{5, 6}}};
  list.sides = {{7, 0}};
  list.sha256 = "file";
  list.creaseDegrees = 10;
  list.marks = {Mark::kLines};
  list.hasRims = true;

  prescription::PrescribedFeatures none = own;
  prescription::addFeatures(none, std::nullopt, asked);
  EXPECT_EQ(none.lines[0].vertices, (std::vector<int>{0, 1}));
  EXPECT_EQ(none.creaseDegrees, 20);

  prescription::PrescribedFeatures both = own;
  prescription::addFeatures(both, list, asked);
  ASSERT_EQ(both.lines.size(), 1U);
  EXPECT_EQ(both.lines[0].vertices, (std::vector<int>{5, 6}));
  EXPECT_EQ(both.sides, list.sides);
  EXPECT_EQ(both.sha256, "file");
  EXPECT_EQ(both.creaseDegrees, 20);
  EXPECT_EQ(both.marks, list.marks);
  EXPECT_TRUE(both.hasRims);

  asked.creaseDegrees = 40;
  asked.marks = {Mark::kNormals};
  prescription::addFeatures(own, list, asked);
  EXPECT_EQ(own.creaseDegrees, 40);
  EXPECT_EQ(own.marks, asked.marks);
}

TEST(FeatureFiles, MarksAreNamedByWords) {
  using Mark = prescription::FeatureMark;
  EXPECT_EQ(prescription::featureMarksNamed({})->size(), 4U);
  EXPECT_EQ(prescription::featureMarksNamed({"normals", "lines", "normals"}),
            (std::vector<Mark>{Mark::kLines, Mark::kNormals}));
  EXPECT_FALSE(prescription::featureMarksNamed({"lines", "colours"}));
}

TEST(FeatureFiles, WrongFeaturesInJsonAreNamed) {
  for (const char* features :
       {"[]", "{\"rims\": 1}", "{\"lines\": 3}", "{\"lines\": [{}]}",
        "{\"lines\": [{\"vertices\": [1]}]}", "{\"lines\": [{\"vertices\": [1, -2]}]}",
        "{\"lines\": [{\"vertices\": [1, 1]}]}",
        "{\"lines\": [{\"vertices\": [1, 2], \"positions\": [[0, 0, 0]]}]}",
        "{\"lines\": [{\"vertices\": [1, 2], \"positions\": [[0, 0, 0], [0, 0]]}]}"}) {
    const Result<prescription::Prescription> read =
        prescription::readConesJson(std::string("{\"q\": 4, \"features\": ") + features + "}");
    ASSERT_FALSE(read) << features;
    EXPECT_EQ(read.error().code, ErrorCode::kMalformed) << features;
  }
}

}  // namespace
}  // namespace hgp::io

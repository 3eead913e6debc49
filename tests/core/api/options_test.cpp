// Options of JSON objects: every row of the table sets its option, and wrong ones are refused by name.

#include <gtest/gtest.h>

#include "hgp/api/option_table.h"
#include "hgp/api/option_words.h"
#include "hgp/api/options_from_json.h"
#include "hgp/base/check.h"

namespace hgp::api {
namespace {

template <class Options>
std::string refusal(const std::string& json, Spelling spelling = Spelling::kJson) {
  const auto made = optionsFromJson<Options>(json, spelling);
  return made ? "accepted" : made.error().message;
}

TEST(OptionsFromJson, EveryOptionIsTaken) {
  const auto load = optionsFromJson<LoadOptions>(
      R"({"surface": 2, "weld": 0.5, "limits": {"bytes": 5000000000, "triangles": 9}, "strict": false,
          "fix": {"orient": true, "split": false}, "writeRepairs": true, "target": "glb"})");
  ASSERT_TRUE(load) << load.error().message;
  EXPECT_EQ(load->surface, 2);
  EXPECT_EQ(load->weld, 0.5);
  EXPECT_EQ(load->limits.maxBytes, 5'000'000'000U);
  EXPECT_EQ(load->limits.maxTriangles, 9U);
  EXPECT_TRUE(load->fix.orient && !load->fix.split && !load->fix.degenerate);
  EXPECT_TRUE(load->writesRepairs && !load->isStrict);
  EXPECT_EQ(load->target, "glb");

  const auto solve = optionsFromJson<SolveOptions>(
      R"({"q": 6, "count": 8, "conesFor": "few", "alignToCurvature": true, "boundary": "convex",
          "maxRounds": 3, "method": "soft", "frames": "file", "improve": "area", "keepGoing": true,
          "refine": true, "convexPolygons": true, "grid": {"spacing": 0.25, "mode": "quad"}})");
  ASSERT_TRUE(solve) << solve.error().message;
  EXPECT_EQ(solve->q, 6);
  EXPECT_EQ(solve->coneCount, 8);
  EXPECT_EQ(solve->conesFor, ConesFor::kFew);
  EXPECT_EQ(solve->boundary, BoundaryKind::kConvex);
  EXPECT_EQ(solve->maxRounds, 3);
  EXPECT_EQ(solve->method, Method::kSoft);
  EXPECT_EQ(solve->frames, FrameSource::kFile);
  EXPECT_EQ(solve->improve.value_or(ImproveOptions()).balance, 1.0);
  EXPECT_TRUE(solve->alignToCurvature && solve->keepsGoing && solve->refines &&
              solve->convexPolygons && !solve->choosesCells);
  EXPECT_EQ(solve->grid.spacing, 0.25);
  EXPECT_EQ(solve->grid.mode, GridMode::kQuad);

  const auto verify = optionsFromJson<VerifyOptions>(R"({"q": 2, "uvSet": 1, "tolerance": 1e-4})");
  ASSERT_TRUE(verify);
  EXPECT_TRUE(verify->q == 2 && verify->uvSet == 1 && verify->tolerance == 1e-4);

  const auto write = optionsFromJson<WriteOptions>(
      R"({"format": "flat-obj", "gridMaterial": true, "uvSet": 3, "name": "x.obj", "embedCones": true,
          "allowUncertified": true, "use": true})");
  ASSERT_TRUE(write);
  EXPECT_EQ(write->format, MapFormat::kFlatObj);
  EXPECT_EQ(write->gridTiles, 0.0);
  EXPECT_TRUE(write->uvSet == 3 && write->name == "x.obj" && write->embedCones &&
              write->allowUncertified && write->pointsMaterials);
}

TEST(OptionsFromJson, AbsentAndNullKeepTheDefaults) {
  const auto solve = optionsFromJson<SolveOptions>(R"({"q": null, "grid": null, "improve": null})");
  ASSERT_TRUE(solve);
  EXPECT_EQ(solve->q, SolveOptions().q);
  EXPECT_FALSE(solve->grid.isAsked() || solve->improve || solve->choosesCells);
  const auto load = optionsFromJson<LoadOptions>("{}");
  ASSERT_TRUE(load);
  EXPECT_EQ(load->weld, LoadOptions::kWeldAutomatic);
  EXPECT_FALSE(load->isStrict);
}

TEST(OptionsFromJson, NamedRepairsAreTheOnlyOnesAndAModeChoosesTheCells) {
  EXPECT_TRUE(optionsFromJson<LoadOptions>(R"({"fix": []})")->isStrict);
  EXPECT_TRUE(optionsFromJson<LoadOptions>(R"({"fix": ["split"]})")->fix.split);
  EXPECT_EQ(optionsFromJson<LoadOptions>(R"({"weld": "none"})")->weld, LoadOptions::kWeldNever);
  EXPECT_TRUE(optionsFromJson<SolveOptions>(R"({"grid": {"mode": "quad"}})")->choosesCells);
  EXPECT_EQ(optionsFromJson<SolveOptions>(R"({"quality": true})")->improve->balance, 0.0);
}

TEST(OptionsFromJson, WrongOptionsAreRefusedByName) {
  EXPECT_EQ(refusal<SolveOptions>(R"({"conesfor": "few"})"),
            "there is no option 'conesfor'; did you mean 'conesFor'?");
  EXPECT_EQ(refusal<VerifyOptions>(R"({"zzzzzzzzzz": 1})"),
            "there is no option 'zzzzzzzzzz'; there are: q, uvSet, tolerance");
  EXPECT_EQ(refusal<SolveOptions>(R"({"q": 65})"), "q must be from 1 to 64, not 65");
  EXPECT_EQ(refusal<SolveOptions>(R"({"q": 4.5})"), "q must be an integer, not 4.5");
  EXPECT_EQ(refusal<SolveOptions>(R"({"q": true})"), "q must be an integer, not true");
  EXPECT_EQ(refusal<SolveOptions>(R"({"count": 99999999999})"),
            "count must be at most 2147483647, not 99999999999");
  EXPECT_EQ(refusal<SolveOptions>(R"({"count": -1})"), "count must be at least 0, not -1");
  EXPECT_EQ(refusal<LoadOptions>(R"({"limits": {"bytes": 0}})"),
            "limits.bytes must be at least 1, not 0");
  EXPECT_EQ(refusal<SolveOptions>(R"({"scale": "big"})"),
            "scale must be 'solved', 'unit' or 'fit', not 'big'");
  EXPECT_EQ(refusal<SolveOptions>(R"({"improve": 1.5})"),
            "improve must be 'isometric', 'conformal', 'area' or a number from -1 to 1, not 1.5");
  EXPECT_EQ(refusal<SolveOptions>(R"({"grid": {"spacing": 0}})"),
            "grid.spacing must be above 0, not 0");
  EXPECT_EQ(refusal<SolveOptions>(R"({"grid": 7})"), "grid must be an object, not 7");
  EXPECT_EQ(refusal<SolveOptions>(R"({"grid": {"cells": 4, "spacing": 1}})"),
            "grid.cells and grid.spacing exclude each other");
  EXPECT_EQ(refusal<LoadOptions>(R"({"fix": ["holes"]})"),
            "fix must be a list of 'orient', 'split' and 'degenerate', not [\"holes\"]");
  EXPECT_EQ(refusal<LoadOptions>(R"({"fix": {"split": 1}})"),
            "fix must be a list of 'orient', 'split' and 'degenerate', not {\"split\":1}");
  EXPECT_EQ(refusal<LoadOptions>("[1]"), "options must be a JSON object");
  EXPECT_EQ(refusal<LoadOptions>("{"), "options must be a JSON object");
  EXPECT_EQ(refusal<WriteOptions>(R"({"": 1})").substr(0, 21), "there is no option ''");
}

TEST(OptionsFromJson, RepairsThatAreNamedContradictStrict) {
  EXPECT_EQ(refusal<LoadOptions>(R"({"strict": true, "fix": ["orient"]})"),
            "strict and fix exclude each other: 'strict' makes no repairs; leave out either");
  // Without a repair both say the same; and false is what an absent value is.
  for (const char* strict : {R"({"strict": true, "fix": []})", R"({"strict": false, "fix": []})",
                             R"({"strict": true, "fix": {"orient": false}})", R"({"fix": []})"}) {
    const auto load = optionsFromJson<LoadOptions>(strict);
    ASSERT_TRUE(load) << strict << load.error().message;
    EXPECT_TRUE(load->isStrict && !load->fix.isAny()) << strict;
  }
  EXPECT_FALSE(optionsFromJson<LoadOptions>(R"({"strict": false})")->isStrict);
  EXPECT_FALSE(optionsFromJson<LoadOptions>(R"({"fix": ["orient"]})")->isStrict);
}

TEST(OptionsFromJson, AScaleAndAGridAreNamedAsTheyWereGiven) {
  const std::string why =
      " exclude each other: 'unit' and 'fit' would undo a grid, in which one cell "
      "is one unit of uv";
  for (const std::string name : {"cells", "spacing", "mode"}) {
    const std::string value = name == "mode" ? "\"quad\"" : "2";
    const std::string grid = "{\"scale\": \"unit\", \"grid\": {\"" + name + "\": " + value + "}}";
    EXPECT_EQ(refusal<SolveOptions>(grid), "scale and grid." + name + why);
  }
  EXPECT_EQ(refusal<SolveOptions>(R"({"scale": "fit", "grid_mode": "quad"})", Spelling::kPython),
            "scale and grid_mode" + why);
}

TEST(OptionsFromJson, DeepAndLongValuesAreRefusedAndShownInPart) {
  const auto nested = [](int depth) {
    return "{\"q\": " + std::string(at(depth), '[') + std::string(at(depth), ']') + "}";
  };
  EXPECT_EQ(refusal<SolveOptions>(nested(9)), "q must be an integer, not [[[[[[[[[]]]]]]]]]");
  EXPECT_EQ(refusal<SolveOptions>(nested(1'000'000)),
            "options must not be nested deeper than 16 lists and objects");
  std::string umlauts;
  for (int i = 0; i < 100; ++i) umlauts += "ü";
  const std::string shown = umlauts.substr(0, 40);
  EXPECT_EQ(refusal<LoadOptions>("{\"target\": \"" + umlauts + "\"}"),
            "target must be 'obj', 'glb', 'gltf' or 'ply', not '" + shown + "…'");
  EXPECT_EQ(refusal<LoadOptions>("{\"target\": \"x" + umlauts + "\"}"),
            "target must be 'obj', 'glb', 'gltf' or 'ply', not 'x" + umlauts.substr(0, 38) + "…'");
  const std::string list = refusal<LoadOptions>("{\"fix\": [\"" + umlauts + "\"]}");
  EXPECT_NE(list.find("not [\"" + umlauts.substr(0, 58) + "…"), std::string::npos) << list;
}

TEST(OptionsFromJson, SetsAreThoseThatAreWrittenAndThoseThatAreRead) {
  EXPECT_EQ(optionsFromJson<WriteOptions>(R"({"uvSet": 15})")->uvSet, 15);
  EXPECT_EQ(refusal<WriteOptions>(R"({"uvSet": 16})"), "uvSet must be from -1 to 15, not 16");
  EXPECT_EQ(optionsFromJson<VerifyOptions>(R"({"uvSet": 63})")->uvSet, 63);
  EXPECT_EQ(refusal<VerifyOptions>(R"({"uvSet": 64})"), "uvSet must be from -1 to 63, not 64");
}

TEST(OptionsFromJson, PythonHasItsOwnNamesAndValues) {
  const Spelling python = Spelling::kPython;
  const auto solve = optionsFromJson<SolveOptions>(R"({"max_rounds": 5, "cells": 400})", python);
  ASSERT_TRUE(solve) << solve.error().message;
  EXPECT_TRUE(solve->maxRounds == 5 && solve->grid.cells == 400.0);
  EXPECT_EQ(refusal<SolveOptions>(R"({"maxRounds": 5})", python),
            "there is no option 'maxRounds'; did you mean 'max_rounds'?");
  EXPECT_EQ(refusal<SolveOptions>(R"({"refine": 1})", python),
            "refine must be True or False, not 1");
  EXPECT_EQ(refusal<SolveOptions>(R"({"cells": 9, "grid": 1})", python),
            "cells and grid exclude each other");
  EXPECT_EQ(refusal<WriteOptions>(R"({"": "obj"})", python).substr(0, 21), "there is no option ''");
}

/// Every word of a row in turn; words that the parser did not know would leave the default behind.
template <class Options>
void expectWords(const char* name, const char* member, auto valueOf) {
  for (const OptionRow& row : optionRows<Options>()) {
    if (std::string(row.name) != name) continue;
    std::vector<decltype(valueOf(Options()))> values;
    for (const std::string& word : wordsOf(row)) {
      const std::string key = member ? member : name;
      const std::string inner = "{\"" + key + "\": \"" + word + "\"}";
      const auto made = optionsFromJson<Options>(member ? "{\"grid\": " + inner + "}" : inner);
      ASSERT_TRUE(made) << made.error().message;
      values.push_back(valueOf(*made));
    }
    ASSERT_GE(values.size(), 2U);
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) EXPECT_NE(values[i], values[j]) << name;
  }
}

TEST(OptionsFromJson, EachWordOfTheTableHasAValueOfItsOwn) {
  expectWords<SolveOptions>("conesFor", nullptr, [](const auto& o) { return o.conesFor; });
  expectWords<SolveOptions>("boundary", nullptr, [](const auto& o) { return o.boundary; });
  expectWords<SolveOptions>("method", nullptr, [](const auto& o) { return o.method; });
  expectWords<SolveOptions>("frames", nullptr, [](const auto& o) { return o.frames; });
  expectWords<SolveOptions>("scale", nullptr, [](const auto& o) { return o.scale; });
  expectWords<SolveOptions>("improve", nullptr, [](const auto& o) { return o.improve->balance; });
  expectWords<SolveOptions>("grid.mode", "mode", [](const auto& o) { return o.grid.mode; });
  expectWords<LoadOptions>("weld", nullptr, [](const auto& o) { return o.weld; });
  expectWords<LoadOptions>("target", nullptr, [](const auto& o) { return o.target; });
  expectWords<WriteOptions>("format", nullptr, [](const auto& o) { return o.format; });
}

TEST(OptionsFromJson, FlagsOfTheCommandLineHaveTheWordsOfTheTable) {
  EXPECT_EQ(wordsOfFlag("--frames"), (std::vector<std::string>{"auto", "file"}));
  EXPECT_TRUE(wordsOfFlag("--json").empty());
}

}  // namespace
}  // namespace hgp::api

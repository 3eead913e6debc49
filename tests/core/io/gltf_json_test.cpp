#include <gtest/gtest.h>

#include "hgp/io/gltf/json/json.h"
#include "hgp/io/gltf/patch/splice.h"

namespace hgp::io {
namespace {

JsonText parsed(const std::string& text) {
  auto json = JsonText::parse(text);
  EXPECT_TRUE(json.hasValue()) << text;
  return std::move(json).value();
}

TEST(GltfJson, FindsValuesWithTheirSpelling) {
  const JsonText json =
      parsed("\xEF\xBB\xBF{ \"a\\u0062\" : [1.50, {\"c\": \"\\ud83d\\ude00\"}] }");
  const int list = json.find(JsonText::kRoot, "ab");
  ASSERT_GE(list, 0);
  const auto items = json.children(list);
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(json.raw(items[0]), "1.50");
  EXPECT_EQ(json.string(json.find(items[1], "c")), "\xF0\x9F\x98\x80");
  EXPECT_EQ(json.pointer(json.find(items[1], "c")), "/ab/1/c");
}

TEST(GltfJson, IntegersHaveNoFractionNoExponentAndFitADouble) {
  const JsonText json = parsed("[0, -3, 9007199254740992, 1.0, 1e2, 9007199254740993, true]");
  const auto items = json.children(JsonText::kRoot);
  EXPECT_EQ(json.integer(items[0]), 0);
  EXPECT_EQ(json.integer(items[1]), -3);
  EXPECT_EQ(json.integer(items[2]), 9007199254740992);
  for (std::size_t i = 3; i < items.size(); ++i) EXPECT_FALSE(json.integer(items[i])) << i;
}

TEST(GltfJson, RefusesWhatIsNotJson) {
  for (const char* text : {"",           " ",          "{",
                           "[1,]",       "{\"a\":1,}", "{a:1}",
                           "[01]",       "[1.]",       "[+1]",
                           "[.5]",       "[1e]",       "nul",
                           "[\"\x01\"]", "[\"\\x\"]",  "[\"\\u12g4\"]",
                           "\"a",        "{\"a\" 1}",  "[1 2]",
                           "{}{}",       "[\"\xFF\"]", "{\"a\":1,\"\\u0061\":2}"}) {
    EXPECT_FALSE(JsonText::parse(text).hasValue()) << text;
  }
}

TEST(GltfJson, StopsAtTheLimits) {
  const std::string deep(100'000, '[');
  const auto tooDeep = JsonText::parse(deep);
  ASSERT_FALSE(tooDeep);
  EXPECT_EQ(tooDeep.error().code, ErrorCode::kMalformed);
  JsonLimits few;
  few.values = 3;
  const auto tooMany = JsonText::parse("[1,2,3]", few);
  ASSERT_FALSE(tooMany);
  EXPECT_EQ(tooMany.error().code, ErrorCode::kLimit);
}

TEST(JsonPatch, LeavesEveryOtherByteAlone) {
  const std::string text = "{\n  \"a\": 1.0,\n  \"b\": [ 1, 2 ],\n  \"c\": {}\n}\n";
  const JsonText json = parsed(text);
  EXPECT_EQ(JsonPatch(json).text(), text);
  JsonPatch patch(json);
  patch.set(JsonText::kRoot, "a", "2");
  patch.append(json.find(JsonText::kRoot, "b"), "3");
  patch.set(json.find(JsonText::kRoot, "c"), "d", "null");
  patch.set(JsonText::kRoot, "e", "[]");
  EXPECT_EQ(patch.text(),
            "{\n  \"a\": 2,\n  \"b\": [ 1, 2, 3 ],\n  \"c\": {\"d\":null},\n  \"e\":[]\n}\n");
}

TEST(JsonPatch, RemovesMembersWithTheirCommas) {
  const std::string text = R"({"a":1,"b":2,"c":3,"d":4})";
  const JsonText json = parsed(text);
  const auto without = [&](std::initializer_list<const char*> keys) {
    JsonPatch patch(json);
    for (const char* key : keys) patch.remove(json.find(JsonText::kRoot, key));
    return patch.text();
  };
  EXPECT_EQ(without({"a"}), R"({"b":2,"c":3,"d":4})");
  EXPECT_EQ(without({"a", "b"}), R"({"c":3,"d":4})");
  EXPECT_EQ(without({"b", "c"}), R"({"a":1,"d":4})");
  EXPECT_EQ(without({"a", "c"}), R"({"b":2,"d":4})");
  EXPECT_EQ(without({"d"}), R"({"a":1,"b":2,"c":3})");
  EXPECT_EQ(without({"a", "b", "c", "d"}), "{}");
  JsonPatch patch(json);
  for (const char* key : {"a", "b", "c", "d"}) patch.remove(json.find(JsonText::kRoot, key));
  patch.set(JsonText::kRoot, "e", "5");
  EXPECT_EQ(patch.text(), R"({"e":5})");
}

TEST(JsonPatch, ForgetsEditsInsideWhatIsRemoved) {
  const JsonText json = parsed(R"({"x":{"y":{"z":1}},"w":2})");
  const int x = json.find(JsonText::kRoot, "x");
  JsonPatch patch(json);
  patch.set(json.find(x, "y"), "z", "3");
  patch.remove(json.find(json.find(x, "y"), "z"));
  patch.remove(x);
  EXPECT_EQ(patch.text(), R"({"w":2})");
}

}  // namespace
}  // namespace hgp::io

#include <gtest/gtest.h>

#include "hgp/io/gltf/json/file.h"
#include "support/notes.h"

namespace hgp::io {
namespace {

TEST(GltfUri, NamesBesideTheFileAreFine) {
  const std::pair<const char*, const char*> names[] = {
      {"a.bin", "a.bin"},
      {"./a.bin", "a.bin"},
      {"dir/sub/a.bin", "dir/sub/a.bin"},
      {"a%20b.bin", "a b.bin"},
      {"..a/b..bin", "..a/b..bin"},
      {"%E2%82%AC.bin", "€.bin"},
      {"%252e%252e/x", "%2e%2e/x"},
      {"Material%20%2325.png", "Material #25.png"}};
  for (const auto& [uri, name] : names) {
    const auto result = relativeName(uri);
    ASSERT_TRUE(result) << uri;
    EXPECT_EQ(*result, name);
  }
}

TEST(GltfUri, PathsThatLeaveTheFolderAreRefusedWithTheReason) {
  for (const char* uri :
       {"",           "/a",          "//host/a", "../a",  "a/../b", "a/..",   "%2e%2e/a",
        "..%2fa",     "%2fa",        "a%5cb",    "a\\b",  "C:/a",   "c%3a/a", "file:///a",
        "http://h/a", "HTTPS://h/a", "a%00b",    "a\nb",  "%",      "%2",     "%gg",
        "a//b",       "a?b",         "a#b",      "data:x"}) {
    const auto result = relativeName(uri);
    ASSERT_FALSE(result) << uri;
    EXPECT_EQ(result.error().code, ErrorCode::kMalformed);
  }
}

TEST(GltfUri, Base64IsTheInverseOfItself) {
  Bytes bytes;
  for (int n = 0; n < 40; ++n) {
    const std::string text = encodeBase64(bytes);
    EXPECT_EQ(decodedSize(text), bytes.size());
    EXPECT_EQ(decodeBase64(text), bytes);
    bytes.push_back(static_cast<std::uint8_t>(n * 37 + 5));
  }
  EXPECT_EQ(decodeBase64("TQ"), (Bytes{'M'}));
  for (const char* wrong : {"A", "AAAAA", "A===", "AA=A", "AA A", "A\nAA", "AA-_"}) {
    EXPECT_FALSE(decodeBase64(wrong)) << wrong;
  }
}

/// A JSON chunk of `json` and a BIN chunk of four bytes.
Bytes smallGlb(const std::string& json) {
  Bytes glb = {'g', 'l', 'T', 'F', 2, 0, 0, 0, 0, 0, 0, 0};
  glb.push_back(static_cast<std::uint8_t>(json.size()));
  for (int b : std::initializer_list<int>{0, 0, 0, 'J', 'S', 'O', 'N'})
    glb.push_back(static_cast<std::uint8_t>(b));
  for (char c : json) glb.push_back(static_cast<std::uint8_t>(c));
  for (int b : std::initializer_list<int>{4, 0, 0, 0, 'B', 'I', 'N', 0, 1, 2, 3, 4})
    glb.push_back(static_cast<std::uint8_t>(b));
  glb[8] = static_cast<std::uint8_t>(glb.size());
  return glb;
}

TEST(GltfContainer, BytesAfterTheEndAndHeadersWithTooSmallCountsAreNoted) {
  const Bytes good = smallGlb("{}  ");
  ASSERT_TRUE(openContainer(good)->notes.empty());
  for (const std::size_t behind : {1, 4, 8, 30}) {
    Bytes glb = good;
    glb.insert(glb.end(), behind, 7);
    const auto read = openContainer(glb);
    ASSERT_TRUE(read) << behind;
    EXPECT_EQ(read->bin.size(), 4u);
    EXPECT_EQ(read->notes, Notes{Note("read-glb-followed", {{"bytes", behind}})});
  }
  for (const int says : {0, 12, 20, 23, 24, 35}) {
    Bytes glb = good;
    glb[8] = static_cast<std::uint8_t>(says);
    const auto read = openContainer(glb);
    ASSERT_TRUE(read) << says;
    EXPECT_EQ(test::codesOf(read->notes), test::Codes{"read-glb-longer"});
    EXPECT_EQ(read->bin.size(), 4u);
  }
  Bytes more = good, both = good;
  more[8] = 37;  // something is missing
  EXPECT_FALSE(openContainer(more));
  both[8] = 30;  // neither fits
  both.insert(both.end(), 4, 7);
  EXPECT_FALSE(openContainer(both));
}

TEST(GltfContainer, ChunksWithoutPaddingAreTakenWhereTheNextFollows) {
  const Bytes glb = smallGlb("{} ");  // what is read are views of it
  const auto read = openContainer(glb);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->json, "{} ");
  EXPECT_EQ(read->bin.size(), 4u);
  EXPECT_EQ(test::codesOf(read->notes), test::Codes{"read-glb-unpadded"});
}

TEST(GltfContainer, EveryTruncatedGlbIsRefused) {
  Bytes glb = {'g', 'l', 'T', 'F', 2, 0, 0, 0, 36, 0, 0, 0};
  for (int b : std::initializer_list<int>{4, 0, 0, 0, 'J', 'S', 'O', 'N', '{', '}', ' ', ' '}) {
    glb.push_back(static_cast<std::uint8_t>(b));
  }
  for (int b : std::initializer_list<int>{4, 0, 0, 0, 'B', 'I', 'N', 0, 1, 2, 3, 4}) {
    glb.push_back(static_cast<std::uint8_t>(b));
  }
  const auto whole = openContainer(glb);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->json, "{}  ");
  EXPECT_EQ(whole->bin.size(), 4u);
  for (std::size_t size = 0; size < glb.size(); ++size) {
    Bytes cut(glb.begin(), glb.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(openContainer(cut)) << size;
    if (size < 12) continue;
    cut[8] = static_cast<std::uint8_t>(size);
    EXPECT_EQ(openContainer(cut).hasValue(), size == 24) << size;
  }
}

}  // namespace
}  // namespace hgp::io

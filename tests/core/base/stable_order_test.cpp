// Sorting by index.  Laws: every number once, none before a smaller one, equal ones in their order.
#include "hgp/base/stable_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>

namespace hgp {
namespace {

TEST(StableOrder, HasEveryNumberOnceAndKeepsEqualOnesInOrder) {
  std::mt19937 random(29);
  for (const std::size_t count : {0u, 1u, 2u, 40u, 500u}) {
    std::vector<int> keys(count);
    for (int& key : keys) key = static_cast<int>(random() % 12);
    const std::vector<std::size_t> order =
        stableOrder(count, [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    ASSERT_EQ(order.size(), count);
    EXPECT_EQ(std::accumulate(order.begin(), order.end(), std::size_t{0}),
              count == 0 ? 0 : count * (count - 1) / 2);
    for (std::size_t i = 1; i < count; ++i)
      EXPECT_LT(std::pair(keys[order[i - 1]], order[i - 1]), std::pair(keys[order[i]], order[i]));
  }
}

TEST(SortStably, MovesAsTheStandardSort) {
  std::mt19937 random(30);
  std::vector<std::pair<int, std::string>> list(300);
  for (auto& [key, name] : list) {
    key = static_cast<int>(random() % 20);
    name = std::to_string(random());
  }
  auto expected = list;
  const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::stable_sort(expected.begin(), expected.end(), less);
  sortStably(list, less);
  EXPECT_EQ(list, expected);
  list.clear();
  sortStably(list, less);
  EXPECT_TRUE(list.empty());
}

}  // namespace
}  // namespace hgp

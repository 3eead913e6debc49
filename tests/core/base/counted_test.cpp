#include "hgp/base/counted.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace hgp {
namespace {

TEST(Counted, OnlyOneIsSingular) {
  EXPECT_EQ(counted(1, "edge"), "1 edge");
  EXPECT_EQ(counted(0, "edge"), "0 edges");
  EXPECT_EQ(counted(std::size_t{12}, "edge"), "12 edges");
  EXPECT_EQ(counted(std::int64_t{1}, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(counted(2u, "vertex", "vertices"), "2 vertices");
}

}  // namespace
}  // namespace hgp

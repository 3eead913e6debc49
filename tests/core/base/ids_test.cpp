#include "hgp/base/ids.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace hgp {
namespace {

template <class T, class Index>
concept Indexable = requires(T t, Index i) {
  t[i];
};

TEST(Ids, AnArrayAcceptsOnlyItsOwnId) {
  static_assert(Indexable<PerFace<int>, FaceId>);
  static_assert(!Indexable<PerFace<int>, VertexId>);
  static_assert(!Indexable<PerFace<int>, int>);
  static_assert(!std::is_convertible_v<int, FaceId>);
  static_assert(!std::is_convertible_v<FaceId, VertexId>);
}

TEST(Ids, DefaultMeansNone) {
  EXPECT_FALSE(VertexId().isValid());
  EXPECT_TRUE(VertexId(0).isValid());
  EXPECT_LT(VertexId(1), VertexId(2));
}

TEST(Ids, RangesVisitEachIdOnce) {
  int expected = 0;
  for (EdgeId e : IdRange<EdgeId>(5)) EXPECT_EQ(e.i, expected++);
  EXPECT_EQ(expected, 5);
  for (EdgeId e : IdRange<EdgeId>(0)) FAIL() << e.i;
}

TEST(Ids, ArraysHoldTheirValues) {
  PerVertex<double> x(3, 1.5);
  x[VertexId(1)] = 2.0;
  const PerVertex<double>& y = x;
  EXPECT_EQ(y[VertexId(1)], 2.0);
  EXPECT_EQ(y.size(), 3);
  double sum = 0;
  for (double v : y) sum += v;
  EXPECT_EQ(sum, 5.0);
}

}  // namespace
}  // namespace hgp

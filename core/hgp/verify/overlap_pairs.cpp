#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "hgp/mesh/box.h"
#include "hgp/verify/face_values.h"

namespace hgp {
namespace {

using Corners = std::array<Vec2, 3>;

/// Whether all of t is on the outer side of an edge of s, up to `slack`.
bool isSeparated(const Corners& s, const Corners& t, double slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 &a = s[k], &b = s[(k + 1) % 3], &c = s[(k + 2) % 3];
    const Vec2 normal{a[1] - b[1], b[0] - a[0]};
    const auto height = [&](const Vec2& p) {
      return normal[0] * (p[0] - a[0]) + normal[1] * (p[1] - a[1]);
    };
    const double inner = height(c) < 0 ? -1 : 1;
    const double limit = slack * std::sqrt(normal[0] * normal[0] + normal[1] * normal[1]);
    if (std::all_of(t.begin(), t.end(), [&](const Vec2& p) { return inner * height(p) <= limit; }))
      return true;
  }
  return false;
}

/// A tree of boxes over the triangles: halves of the longer side, down to a few each.
class Joiner {
 public:
  Joiner(const UvMap& map, long long most) : map_(map), most_(most) {
    boxes_.reserve(map.cornerUv.size());
    for (std::size_t t = 0; t < map.cornerUv.size(); ++t) {
      Box<2> box;
      for (const Vec2& p : cornersOf(static_cast<int>(t))) box.add(p);
      boxes_.push_back(box);
      all_.add(box.low);
      all_.add(box.high);
    }
    slack_ = all_.isEmpty ? 0 : 1e-6 * all_.extent();
    order_.resize(boxes_.size());
    std::iota(order_.begin(), order_.end(), 0);
    isIn_.assign(boxes_.size(), 0);
    if (!order_.empty()) build(0, static_cast<int>(order_.size()));
  }

  OverlapPairs run() {
    if (!nodes_.empty()) joinOwn(0);
    OverlapPairs out;
    out.pairs = pairs_;
    out.isMore = pairs_ >= most_;
    for (std::size_t t = 0; t < isIn_.size(); ++t)
      if (isIn_[t] != 0) out.triangles.push_back(static_cast<int>(t));
    return out;
  }

 private:
  static constexpr int kLeaf = 4;
  struct Node {
    Box<2> box;
    int begin = 0, end = 0;
    int right = -1;  ///< −1: a leaf; the left child follows its parent
  };

  Corners cornersOf(int t) const {
    const auto& c = map_.cornerUv[static_cast<std::size_t>(t)];
    Corners out;
    for (std::size_t k = 0; k < 3; ++k) out[k] = map_.uv[static_cast<std::size_t>(c[k])];
    return out;
  }
  const Box<2>& boxOf(int t) const { return boxes_[static_cast<std::size_t>(t)]; }

  int build(int begin, int end) {
    const auto self = static_cast<int>(nodes_.size());
    Node node;
    node.begin = begin;
    node.end = end;
    for (int i = begin; i < end; ++i) {
      node.box.add(boxOf(order_[static_cast<std::size_t>(i)]).low);
      node.box.add(boxOf(order_[static_cast<std::size_t>(i)]).high);
    }
    nodes_.push_back(node);
    if (end - begin <= kLeaf) return self;
    const std::size_t axis =
        node.box.high[0] - node.box.low[0] >= node.box.high[1] - node.box.low[1] ? 0 : 1;
    const auto middle = [&](int t) { return boxOf(t).low[axis] + boxOf(t).high[axis]; };
    const int half = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                     [&](int a, int b) { return middle(a) < middle(b); });
    build(begin, half);
    const int right = build(half, end);
    nodes_[static_cast<std::size_t>(self)].right = right;
    return self;
  }

  bool mayOverlap(const Box<2>& a, const Box<2>& b) const {
    for (std::size_t k = 0; k < 2; ++k)
      if (a.high[k] - b.low[k] <= slack_ || b.high[k] - a.low[k] <= slack_) return false;
    return true;
  }

  bool isNeighbour(int s, int t) const {
    const auto &a = map_.cornerUv[static_cast<std::size_t>(s)],
               &b = map_.cornerUv[static_cast<std::size_t>(t)];
    return std::any_of(a.begin(), a.end(),
                       [&](int i) { return std::find(b.begin(), b.end(), i) != b.end(); });
  }

  void test(int s, int t) {
    if (pairs_ >= most_ || !mayOverlap(boxOf(s), boxOf(t)) || isNeighbour(s, t)) return;
    const Corners a = cornersOf(s), b = cornersOf(t);
    if (isSeparated(a, b, slack_) || isSeparated(b, a, slack_)) return;
    ++pairs_;
    isIn_[static_cast<std::size_t>(s)] = isIn_[static_cast<std::size_t>(t)] = 1;
  }

  void joinOwn(int n) {
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    if (node.right < 0) {
      for (int i = node.begin; i < node.end; ++i)
        for (int j = i + 1; j < node.end; ++j)
          test(order_[static_cast<std::size_t>(i)], order_[static_cast<std::size_t>(j)]);
      return;
    }
    joinOwn(n + 1);
    joinOwn(node.right);
    joinTwo(n + 1, node.right);
  }

  void joinTwo(int m, int n) {
    const Node &a = nodes_[static_cast<std::size_t>(m)], &b = nodes_[static_cast<std::size_t>(n)];
    if (pairs_ >= most_ || !mayOverlap(a.box, b.box)) return;
    if (a.right < 0 && b.right < 0) {
      for (int i = a.begin; i < a.end; ++i)
        for (int j = b.begin; j < b.end; ++j)
          test(order_[static_cast<std::size_t>(i)], order_[static_cast<std::size_t>(j)]);
    } else if (b.right < 0 || (a.right >= 0 && a.end - a.begin >= b.end - b.begin)) {
      joinTwo(m + 1, n);
      joinTwo(a.right, n);
    } else {
      joinTwo(m, n + 1);
      joinTwo(m, b.right);
    }
  }

  const UvMap& map_;
  long long most_, pairs_ = 0;
  double slack_ = 0;
  Box<2> all_;
  std::vector<Box<2>> boxes_;
  std::vector<int> order_;
  std::vector<char> isIn_;
  std::vector<Node> nodes_;
};

}  // namespace

OverlapPairs findOverlapPairs(const UvMap& map, long long most) { return Joiner(map, most).run(); }

}  // namespace hgp

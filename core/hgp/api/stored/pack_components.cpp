#include "hgp/api/stored/pack_components.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/stable_order.h"

namespace hgp::api {
namespace {

// Space around a component, relative to its size.
constexpr double kGap = 0.03125;

/// The power of two of which all shifts of this box are multiples.
double quantumOf(const UvBox& box, double unit) {
  const double extent = box.extent();
  return std::max(unit, extent > 0 ? std::ldexp(1.0, std::ilogb(extent) - 4) : 0.0);
}

double roundedUp(double x, double quantum) {
  return quantum > 0 ? std::ceil(x / quantum) * quantum : x;
}

/// Fills strips one after the other.
class Packer {
 public:
  /// The lower left corner of a place for a box of this size.
  Vec2 place(const Vec2& size) {
    if (isColumn_ ? next_ + size[1] > stripLength_ : next_ + size[0] > stripLength_) {
      startStrip(size);
    }
    const Vec2 corner = isColumn_ ? Vec2{side_[0], next_} : Vec2{next_, side_[1]};
    next_ += isColumn_ ? size[1] : size[0];
    width_ = std::max(width_, isColumn_ ? size[0] : size[1]);
    return corner;
  }

 private:
  void startStrip(const Vec2& size) {
    side_[isColumn_ ? 0 : 1] += width_;
    isColumn_ = side_[0] <= side_[1];
    const std::size_t along = isColumn_ ? 1 : 0;
    side_[along] = std::max(side_[along], size[along]);
    stripLength_ = side_[along];
    next_ = width_ = 0;
  }

  Vec2 side_{0, 0};  ///< extent of the complete strips
  bool isColumn_ = true;
  double stripLength_ = -1, next_ = 0, width_ = 0;
};

}  // namespace

std::vector<Vec2> packBoxes(const std::vector<UvBox>& boxes, double unit) {
  std::vector<Vec2> shifts(boxes.size(), Vec2{0, 0});
  const auto isUsed = [](const UvBox& box) { return !box.isEmpty; };
  if (std::count_if(boxes.begin(), boxes.end(), isUsed) < 2) return shifts;
  const auto extentOf = [&](std::size_t i) { return boxes[i].isEmpty ? 0.0 : boxes[i].extent(); };
  const std::vector<std::size_t> order = stableOrder(
      boxes.size(), [&](std::size_t a, std::size_t b) { return extentOf(a) < extentOf(b); });
  Packer packer;
  for (const std::size_t i : order) {
    const UvBox& box = boxes[i];
    if (box.isEmpty) continue;
    // A shift is rounded up by less than one quantum; the reserved place includes this margin.
    const double quantum = quantumOf(box, unit);
    const double room = quantum + kGap * box.extent();
    const Vec2 corner = packer.place({box.size(0) + room, box.size(1) + room});
    for (std::size_t k = 0; k < 2; ++k) {
      shifts[i][k] = roundedUp(corner[k] - box.low[k], quantum);
    }
  }
  return shifts;
}

Vec2 centringShift(const UvBox& box, double unit) {
  const double quantum = quantumOf(box, unit);
  Vec2 shift{0, 0};
  for (std::size_t k = 0; quantum > 0 && k < 2; ++k) {
    shift[k] = -std::nearbyint((box.low[k] + box.high[k]) / 2 / quantum) * quantum;
  }
  return shift;
}

}  // namespace hgp::api

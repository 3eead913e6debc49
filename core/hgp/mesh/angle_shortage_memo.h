// The last answer of findAngleShortage, kept.  Role: choosing cones, checking and solving ask for the same angles.
#pragma once

#include <utility>

#include "hgp/mesh/angle_shortage.h"

namespace hgp {

/// Belongs to one mesh; not for use by several threads at a time.
class AngleShortageMemo {
 public:
  /// findAngleShortage(mesh, q, k); searches only if the angles differ from those asked for last.
  const std::optional<AngleShortage>& find(const TriMesh& mesh, int q, const PerVertex<int>& k);
  int searches() const { return searches_; }

  /// For searches from now on.
  void startFrom(NearAngles nearAngles) { nearAngles_ = std::move(nearAngles); }
  const NearAngles& nearAngles() const { return nearAngles_; }

 private:
  NearAngles nearAngles_;
  int searches_ = 0;
  int q_ = 0;
  PerVertex<int> k_;
  std::optional<AngleShortage> found_;
};

}  // namespace hgp

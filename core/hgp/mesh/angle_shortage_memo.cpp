#include "hgp/mesh/angle_shortage_memo.h"

namespace hgp {

const std::optional<AngleShortage>& AngleShortageMemo::find(const TriMesh& mesh, int q,
                                                            const PerVertex<int>& k) {
  if (searches_ > 0 && q == q_ && k.raw() == k_.raw()) return found_;
  found_ = findAngleShortage(mesh, q, k, nearAngles_);
  q_ = q;
  k_ = k;
  ++searches_;
  return found_;
}

}  // namespace hgp

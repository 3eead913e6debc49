#include "hgp/features/ways.h"

#include "hgp/base/turns.h"

namespace hgp {

RealSum partOf(const RealUnknowns& unknowns, int copy, int part) {
  RealSum sum;
  for (RealUnknowns::Rows::InnerIterator it(unknowns.rows, 2 * copy + part); it; ++it)
    sum[static_cast<int>(it.col())] = it.value();
  return sum;
}

void addAlong(RealSum& sum, const RealUnknowns& unknowns, int copy, int direction, double factor) {
  const int d = reduceTurn(direction, 4);
  addTo(sum, partOf(unknowns, copy, d % 2), d < 2 ? factor : -factor);
}

RealSum wayAlong(const RealUnknowns& unknowns, int from, int direction,
                 const std::vector<SeamStep>& steps, int to) {
  RealSum sum;
  addAlong(sum, unknowns, from, direction, -1.0);
  for (const SeamStep& s : steps) {
    addAlong(sum, unknowns, s.copyBefore, s.before, 1.0);
    addAlong(sum, unknowns, s.copyAfter, s.after, -1.0);
    direction = s.after;
  }
  addAlong(sum, unknowns, to, direction, 1.0);
  return sum;
}

}  // namespace hgp

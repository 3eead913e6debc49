#include "hgp/field/prepared_surface.h"

#include <algorithm>

#include "hgp/field/cone_angles.h"

namespace hgp {
namespace {

/// Up to this many triangles the Laplacian is factored for the search for too few triangles alone.
constexpr int kFactorForAngles = 200'000;

/// Whether `asked` prescribes exactly what `found` has; a file lists its cones in its own order.
bool isExactly(const HolonomySpec& asked, const CompleteSpec& found) {
  if (asked.q != found.q || asked.cones.size() != found.cones.size()) return false;
  if (asked.turning.size() != found.turning.size()) return false;
  if (asked.handles.size() != found.handles.size()) return false;
  std::vector<ConePoint> cones = asked.cones;
  sortCones(cones);
  const auto isSame = [](const ConePoint& a, const ConePoint& b) {
    return a.vertex == b.vertex && a.k == b.k;
  };
  return std::equal(cones.begin(), cones.end(), found.cones.begin(), isSame) &&
         std::equal(asked.turning.begin(), asked.turning.end(), found.turning.begin()) &&
         std::equal(asked.handles.begin(), asked.handles.end(), found.handles.begin());
}

}  // namespace

PreparedSurface::PreparedSurface(const TriMesh& mesh, Metric metric)
    : mesh_(&mesh), context_(std::make_shared<FieldContext>(prepareSurface(mesh, metric))) {
  // On a large surface the factor costs more than the search, and is soon freed.
  const auto angles = [this](const AngleQuestion& question) {
    const bool isWorthIt = hasConnection_ || mesh_->faceCount() <= kFactorForAngles;
    return isWorthIt && requireConnection() ? std::optional(coneAngles(*mesh_, *context_, question))
                                            : std::nullopt;
  };
  shortages_.startFrom(angles);
}

PreparedSurface& PreparedSurface::evened() {
  if (isEvened()) return *this;
  if (!evened_) evened_ = std::make_unique<PreparedSurface>(*mesh_, Metric::kEvened);
  return *evened_;
}

Status PreparedSurface::requireConnection() {
  if (hasConnection_) return Done{};
  if (Status done = prepareConnection(*mesh_, *context_); !done) return done;
  hasConnection_ = true;
  return Done{};
}

void PreparedSurface::releaseConnection() {
  context_->laplacian = {};
  context_->handles = {};
  hasConnection_ = false;
}

Result<PrescribedField> PreparedSurface::field(const HolonomySpec& spec) {
  if (last_ && isExactly(spec, last_->spec)) return *last_;
  last_.reset();
  if (Status done = requireConnection(); !done) return std::move(done).error();
  Result<PrescribedField> made = prescribedField(*mesh_, *context_, spec);
  if (made) last_ = *made;
  return made;
}

}  // namespace hgp

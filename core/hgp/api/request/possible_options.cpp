#include "hgp/api/request/possible_options.h"

#include <cmath>

#include "hgp/api/request/feature_request.h"
#include "hgp/base/check.h"

namespace hgp::api {
namespace {

Failure cannotRefineFrames() {
  return {ErrorCode::kUsage,
          "refine",
          "Frames of a file belong to its triangles and cannot be refined with the mesh; leave out "
          "either.",
          {}};
}

Failure wrongBalance() {
  return {ErrorCode::kUsage,
          "improve",
          "An improvement is \"isometric\", \"conformal\", \"area\", or a number from -1 (angles) "
          "through 0 (isometric) to 1 (areas).",
          {}};
}

/// Checks that options and q allow an aligned grid.
Status checkGrid(const SolveOptions& options, int q) {
  if (!options.grid.isAsked()) return Done{};
  const auto refuse = [](std::string text) {
    return Failure{ErrorCode::kUsage, "align", std::move(text), {}};
  };
  if (q != 2 && q != 4)
    return refuse(formatText("a grid of squares needs q = 2 or 4; these cones have q = %d", q));
  if (options.boundary == BoundaryKind::kConvex)
    return refuse("a convex boundary has no seams to align; leave out the grid");
  if (options.scale != Scale::kSolved)
    return refuse("an aligned map has one cell per unit of uv; leave out the scale or the grid");
  if (options.grid.cells > 0 && options.grid.spacing > 0)
    return refuse("cells and spacing exclude each other; give one of them");
  return Done{};
}

/// Checks that nothing is asked of a convex boundary that a map without cones and seams does not have.
Status checkConvex(const SolveOptions& options) {
  if (options.boundary != BoundaryKind::kConvex) return Done{};
  const auto refuse = [](const char* text) {
    return Failure{ErrorCode::kUsage, "boundary", text, {}};
  };
  if (choosesCones(options))
    return refuse(
        "A map onto a convex polygon has no cones; leave out their number, purpose and alignment.");
  if (options.q != 4)
    return refuse("A map onto a convex polygon has no seams that turn; leave out q.");
  if (options.method != Method::kAuto)
    return refuse("A map onto a convex polygon has a method of its own; leave out the method.");
  return Done{};
}

}  // namespace

Status checkOptions(const SolveOptions& options, int q) {
  if (Status possible = checkGrid(options, q); !possible) return possible;
  if (Status possible = checkConvex(options); !possible) return possible;
  if (options.improve && !(std::fabs(options.improve->balance) <= 1.0)) return wrongBalance();
  if (options.frames == FrameSource::kFile && options.refines) return cannotRefineFrames();
  return Done{};
}

}  // namespace hgp::api

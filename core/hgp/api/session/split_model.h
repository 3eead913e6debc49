// A surface whose edges are split where features leave a map no room.  Role: plain CAD has triangles between three
// features and edges that join them, which no map along all features can have (docs/decisions/095).
#pragma once

#include "hgp/api/session/refined_model.h"

namespace hgp::api {

/// What is split: edges across the plane of a symmetric map, and triangles between three features; all edges between features; also the triangles at features.
enum class Splits { kCrowded, kChords, kAround };
inline constexpr Splits kAllSplits[] = {Splits::kCrowded, Splits::kChords, Splits::kAround};

/// A model and its request after no, one or several refinements. References only, until something is split.
struct SplitModel {
  const Model* model;
  const Request* request;
  std::optional<RefinedModel> refined;  ///< *model, if something was split
  std::optional<Request> carried;
  RefinedFacts facts;
  const bool crossesPlane;  ///< edges across the plane of a symmetric map are split

  SplitModel(const Model& m, const Request& r);
  SplitModel(const SplitModel&) = delete;
  SplitModel& operator=(const SplitModel&) = delete;

  /// Splits the edges for `splits`, beyond triangles between features only on components of which isOpen is set. Other
  /// files than those of polygons become polygons first. New vertices follow the old ones, step by step.
  Status split(Splits splits, const std::vector<char>& isOpen);

 private:
  using Places = std::vector<std::vector<SplitPlace>>;
  Status splitEdges(const Places& places);
  Status take(RefinedModel next);
};

/// Whether a run takes no further splits of a surface: it has more than kLargestRefinement triangles.
bool isTooLargeToSplit(const Model& split);

/// Whether a triangle has three feature edges, or an edge crosses the plane of a symmetric map.
bool isCrowded(const Model& model, const Request& request);

}  // namespace hgp::api

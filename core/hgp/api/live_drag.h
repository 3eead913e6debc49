// A cone of a session's result that is dragged.  Role: LiveEdit at the API boundary, in ids and arrays of the surface.
// A drag uses its session: calls of both are made by one thread at a time.
#pragma once

#include "hgp/api/session.h"
#include "hgp/parametrize/live_edit.h"

namespace hgp::api {

/// What a position of the cone gives.
struct LiveView {
  LiveState state = LiveState::kHeat;
  /// As Session::uv() and cornerToUv(): the other components as they are, this one moved; uv that no corner uses are
  /// left in. Empty for kHeat.
  std::vector<double> uv;
  std::vector<std::uint32_t> cornerToUv;
  std::vector<float>
      logScale;  ///< log conformal factor by surface vertex; NaN outside the component
  std::vector<int> notPositive;      ///< triangles of the surface
  std::vector<std::string> reasons;  ///< why the map is not certified
  std::string cones;                 ///< hgp-cones: the prescription that the map is certified for
  bool wantsPreparation =
      false;  ///< prepareHere() lets the cone go on; of heat: prepareToward() takes it nearer
};

/// The maps are certified as they are, in float64, before any rounding for a file, and are not stored. When the cone is
/// dropped, drop() stores the last of them at once; Session::parametrize with its `cones` gives a result whose bytes do not
/// depend on the path.
class LiveDrag {
 public:
  /// Starts from the session's result. Fails with kUsage if there is none, if it is on a refined surface, and if no cone
  /// is at the vertex.
  /// @param session  outlives the drag, which ends when the session loads or solves
  static Result<LiveDrag> begin(Session& session, int vertex);
  LiveDrag(LiveDrag&&) noexcept;
  LiveDrag& operator=(LiveDrag&&) noexcept;
  ~LiveDrag();

  /// Fails with kUsage where no cone can be: at other cones, on boundaries, on other components.
  Result<LiveView> moveTo(int vertex);
  /// Prepares the neighbourhood of the last certified position; takes about as long as begin().
  Status prepareHere();
  /// Goes towards a vertex for which moveTo() gave heat, as far as the prepared neighbourhood allows, and prepares that of
  /// the position reached; returns its vertex, or −1 where no nearer position has a certified map.
  Result<int> prepareToward(int vertex);
  /// Stores the last certified map as the session's result, verified as stored like that of any run; this ends the drag.
  /// Its bytes depend on the path of the cone, which its report says.
  Status drop();

 private:
  struct State;
  explicit LiveDrag(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hgp::api

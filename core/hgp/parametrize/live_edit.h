// A cone that is dragged over a solved map.  Role: gives a map, and the verifier's certificate for it, while the hand moves.
#pragma once

#include <memory>

#include "hgp/field/prepared_surface.h"
#include "hgp/verify/certificate.h"

namespace hgp {

/// What is known for a position of the cone.
enum class LiveState : unsigned char {
  kHeat,       ///< the conformal factor alone: there is no map
  kCertified,  ///< a map, which the verifier certifies in float64; it is not stored
  kFails       ///< a map with the reasons why it is not certified
};
const char* liveStateName(LiveState state);  ///< "heat", "certified", "fails"

struct LiveFrame {
  LiveState state = LiveState::kHeat;
  VertexId cone;                 ///< where it is now
  CompleteSpec spec;             ///< with it there; rotations of handles follow its path
  PerVertex<double> u;           ///< log conformal factor
  UvMap map;                     ///< empty for kHeat; the cut is extended along the path
  std::vector<VertexId> copyOf;  ///< uv index → vertex
  Certificate certificate;       ///< of `map`, without its distortion; empty for kHeat
  bool wantsAnchor = false;      ///< beginHere() would give a map (kHeat), or allow to go farther
};

/// The maps depend on the path of the cone, and their bytes are not those of a run with the same cones. Each satisfies
/// the seam conditions by construction; whether it is certified is what the verifier says of it.
class LiveEdit {
 public:
  /// Starts from a map: of a run, or of a file. Prepares the neighbourhood of the cone, for about the time of a first
  /// round. Fails with kUsage if `cone` is not a cone of `spec`, or the map does not have the seams of these cones.
  /// @param surface  of the map; used until the end of the edit
  /// @param map      certified for `spec`
  static Result<LiveEdit> begin(PreparedSurface& surface, const CompleteSpec& spec,
                                const UvMap& map, VertexId cone);
  LiveEdit(LiveEdit&&) noexcept;
  LiveEdit& operator=(LiveEdit&&) noexcept;
  ~LiveEdit();

  /// The map with the cone at v. Fails with kUsage where no cone can be: at other cones and on boundaries.
  Result<LiveFrame> moveTo(VertexId v);
  /// Prepares the neighbourhood of the cone's last position that had a certified map, and starts from that map.
  Status beginHere();

  /// Goes towards v, which is out of reach: to a position with fewer edges to v that has a certified map, and prepares
  /// its neighbourhood. False, and nothing is prepared, if the neighbourhood of now has none.
  Result<bool> beginToward(VertexId v);

  /// The last certified map, or that of the start.
  struct Reached {
    CompleteSpec spec;
    UvMap map;  ///< every uv is used
    std::vector<VertexId> copyOf;
  };
  Reached reached() const;
  ConePoint cone() const;    ///< at the last position with a certified map
  int preparations() const;  ///< begin() and beginHere(), where they had something to do

 private:
  struct State;
  explicit LiveEdit(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hgp

// The rules of a certificate and what is said where one is broken.  Role: shared by what checks them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hgp/base/note.h"

namespace hgp {

/// What a map must satisfy. Order: from "cannot be measured" to "measured and wrong".
enum class Rule {
  kPrescription,  ///< the prescription does not fit this mesh
  kMalformedUv,   ///< cornerUv has the wrong size or an index out of range
  kNotFinite,     ///< a used uv is NaN or infinite
  kOrientation,   ///< a triangle whose signed area is not positive
  kConeAngle,     ///< an interior angle sum that is not as asked
  kTurning,       ///< a boundary loop whose turning is not as asked
  kSeam,          ///< a seam whose sides are not related by a rotation by a multiple of 2π/q
  kHandle,        ///< a handle whose rotation is not as asked
  kFeature,       ///< a prescribed feature edge that is not exactly straight
  kGaussBonnet,   ///< the measured integers break Lemma 6.2
  kEuler,         ///< V − E + F ≠ 2c − 2g − m
  /// Deviations above the tolerance that the resolution of the number type explains, or areas that
  /// span more than it resolves
  kRange,
  kEmpty,  ///< there is no triangle
};
/// Short stable name used in JSON ("orientation", "cone-angle", …).
const char* ruleName(Rule rule);

/// The id, of the mesh that was verified, which stands in a message as a number; who numbers otherwise replaces it.
struct NamedId {
  enum class Kind : std::uint8_t { kVertex, kLoop, kHandle };
  Kind kind;
  int id;
  std::size_t at;  ///< where in the message its digits begin
};

/// Why a map is not certified.
struct Reason {
  Rule rule;
  int count = 0;             ///< places that break the rule
  double worst = 0;          ///< measured number at the worst place, in the rule's own unit
  std::string message;       ///< one sentence: rule, numbers
  std::vector<Where> where;  ///< the worst places, worst first ("Show worst")
  std::optional<NamedId> named = {};  ///< in `message`
};

}  // namespace hgp

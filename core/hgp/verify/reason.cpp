#include "hgp/verify/reason.h"

namespace hgp {

const char* ruleName(Rule rule) {
  switch (rule) {
    case Rule::kPrescription:
      return "prescription";
    case Rule::kMalformedUv:
      return "malformed-uv";
    case Rule::kNotFinite:
      return "not-finite";
    case Rule::kOrientation:
      return "orientation";
    case Rule::kConeAngle:
      return "cone-angle";
    case Rule::kTurning:
      return "turning";
    case Rule::kSeam:
      return "seam";
    case Rule::kHandle:
      return "handle";
    case Rule::kFeature:
      return "feature";
    case Rule::kGaussBonnet:
      return "gauss-bonnet";
    case Rule::kEuler:
      return "euler";
    case Rule::kRange:
      return "range";
    case Rule::kEmpty:
      return "empty";
  }
  return "unknown";
}

}  // namespace hgp

// What a stored number type can hold exactly.  Role: of files, for maps that are rounded before they are written.
#pragma once

namespace hgp {

struct StoredNumbers {
  int digits = 53;                      ///< of the significand: 53 for float64, 24 for float32
  bool holdsFlipped = false;            ///< 1 − v is stored (glTF): it must be exact, too
  bool hasIntegerTranslations = false;  ///< translations are rounded to integers, not to even steps
};

}  // namespace hgp

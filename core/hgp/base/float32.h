// Rounding to single precision that compilers cannot remove.  Role: values are verified as they are stored.
#pragma once

namespace hgp {

/// The float nearest to x, as a double; an infinity where |x| rounds beyond the range of float.
/// A function that is not inlined, instead of two casts: g++ 12 at -O2 and above removes pairs of
/// double → float → double conversions (in its vectorizer of straight-line code).
double roundToFloat(double x);

}  // namespace hgp

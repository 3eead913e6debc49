// Rounding to single precision that is really done.  Role: values are verified as they are stored.
#pragma once

namespace hgp {

/// The float nearest to x, as a double; an infinity where |x| rounds beyond the range of float.
/// Out of line, never written as a cast there and back: g++ 12 at -O2 and above turns a pair of
/// double → float → double conversions into nothing (its vectorizer of straight-line code).
double roundToFloat(double x);

}  // namespace hgp

// Elementary functions whose results are bit-identical on every processor, system and compiler.  Role: replaces the
// functions of C libraries, which differ in the last bit; with kernels without fused multiply-add, maps have the
// same bits natively and in WebAssembly (decision 046).
#pragma once

#include <complex>

namespace hgp::portable {

// Made of + − × ÷ and square roots, each rounded once (IEEE 754, to nearest, nothing fused), and of exact
// operations. Angles are in radians. Errors are in units in the last place (ulp) of results that are
// normal numbers; NaN gives NaN.

double exp(double x);    ///< 1 ulp; 0 below −745.2, infinite above 709.8
double log(double x);    ///< 1 ulp; −∞ at 0, NaN below
double log1p(double x);  ///< log(1 + x), 3 ulp
double log2(double x);   ///< 2 ulp; exact at powers of two

/// xʸ for x ≥ 0, exp(y log x): 2 + |y log x| ulp.
double pow(double x, double y);
double cosh(double x);  ///< 2 ulp
double tanh(double x);  ///< 2 ulp of 1, not of the result: small results have fewer digits

double sin(double x);  ///< 1 ulp for |x| < 10⁶; beyond, 2π is replaced by the nearest double
double cos(double x);  ///< as sin
double tan(double x);  ///< 3 ulp

/// The angle of (x, y) in [−π, π], 2 ulp; zeros with signs and infinite arguments as in ISO C.
double atan2(double y, double x);
double asin(double x);  ///< 4 ulp; NaN outside [−1, 1]
double acos(double x);  ///< 4 ulp; NaN outside [−1, 1]

/// √(x² + y² …) without overflow, 2 ulp.
double hypot(double x, double y);
double hypot(double x, double y, double z);

inline double abs(double x) { return x < 0 ? -x : x; }
double abs(const std::complex<double>& z);  ///< hypot
double arg(const std::complex<double>& z);  ///< atan2
std::complex<double> polar(double radius, double angle);

/// a / b = a b̄ / |b|² without overflow of |b|²; compilers scale in different ways.
std::complex<double> divide(const std::complex<double>& a, const std::complex<double>& b);

}  // namespace hgp::portable

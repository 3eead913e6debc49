// Aligned scratch for the dense kernels.  Role: allocated once per factorization.
#pragma once

#include <complex>
#include <cstdint>
#include <memory>

#include "hgp/linalg/kernels/dense_kernels.h"

namespace hgp::linalg {

/// Scalars in the form that the kernels expect: complex numbers as pairs of doubles.
inline double* raw(double* p) { return p; }
inline double* raw(std::complex<double>* p) { return reinterpret_cast<double*>(p); }

class KernelWorkspace {
 public:
  KernelWorkspace() : raw_(new double[kKernelWorkspace + 8]) {}
  /// kKernelWorkspace doubles at a multiple of 64 bytes.
  double* data() const {
    const auto address = reinterpret_cast<std::uintptr_t>(raw_.get());
    return reinterpret_cast<double*>((address + 63) / 64 * 64);
  }

 private:
  std::unique_ptr<double[]> raw_;
};

}  // namespace hgp::linalg

// Ratios of a measurement of two maps over many surfaces.  Role: the summaries of bench/distortion and bench/compare.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "surface_rows.h"

namespace hgp::bench {

/// The measurements of maps for which ratios are computed.
inline double excessOf(const MeasuredMap& m) { return m.excess; }
inline double energyOf(const MeasuredMap& m) { return 4.0 + m.excess; }
inline double muOf(const MeasuredMap& m) { return m.meanMu; }
inline double sigmaOf(const MeasuredMap& m) { return m.sigma; }
inline double secondsOf(const MeasuredMap& m) { return m.seconds; }
inline double conesOf(const MeasuredMap& m) { return m.cones; }

/// Ratios of one number of two maps, ascending.
class Ratios {
 public:
  using Number = std::function<double(const MeasuredMap&)>;
  using Pair = std::function<bool(const SurfaceRow&, const MeasuredMap& of, const MeasuredMap& to)>;

  /// Over the surfaces that have both maps, satisfy `counts` and have a positive denominator.
  Ratios(const std::vector<SurfaceRow>& rows, const std::string& of, const std::string& to,
         const Number& number, const Pair& counts);

  int count() const { return static_cast<int>(values_.size()); }
  double at(double share) const;  ///< quantile; @pre count() > 0
  /// A line below ratioHead().
  std::string cells(const std::string& label) const;

 private:
  std::vector<double> values_;
};

std::string ratioHead();

}  // namespace hgp::bench

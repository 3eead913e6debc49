// A map whose translations are rounded, and the rounding that gives a number of cells.  Role: the linear step of
// align.cpp; quads are to be as many as asked for.
#pragma once

#include "hgp/grid/grid_system.h"
#include "hgp/grid/repair_change.h"

namespace hgp {

/// The change of minimum strain that makes the translations the integers y.
struct RoundedMap {
  double factor = 1.0;  ///< ratio to the requested density
  double scale = 1.0;   ///< cells per unit of the map
  std::vector<Gaussian> y;
  Eigen::VectorXcd x;
  double cells = 0.0;  ///< area of the map in cells, signed
};

/// With `integers`, or with those near the map at this density.
RoundedMap roundedMap(const GridSystem& system, const ChangeContext& context,
                      const IntegerChoice& choice, double scale, double factor,
                      std::vector<Gaussian> integers = {});

/// Rounding a few large cells changes their number. The map at the density, near the requested one, at which the rounded
/// map has about as many cells as asked for; where there are few integers so that their number jumps, with one of them
/// changed so that it has (of these, the one with the least strain).
/// @param scale   of the requested density, with `cells` cells
/// @param affords  called before every step; false ends the search
RoundedMap roundedToCells(const GridSystem& system, const ChangeContext& context,
                          const IntegerChoice& choice, double scale, double cells,
                          const std::function<bool()>& affords);

}  // namespace hgp

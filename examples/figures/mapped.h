// A model with its map, and scenes made of them.  Role: the common part of all figures.
#pragma once

#include <optional>
#include <string>

#include "../picture/render.h"
#include "hgp/parametrize/parametrize.h"

namespace hgp::figures {

/// A solved and verified model.
struct Mapped {
  MeshData data;
  TriMesh mesh;
  Parametrization result;
};

struct Order {
  int q = 4;
  std::optional<HolonomySpec> spec;  ///< empty: automatic cones
  int coneCount = 0;
  std::optional<ImproveOptions> improve;
  int maxRounds = 12;
  Method method = Method::kAuto;
  GridOptions grid;  ///< if given: one cell per unit of uv
};

/// Solves and prints one line about the result. Empty if the prescription is not possible.
std::optional<Mapped> mapped(const std::string& name, const MeshData& data, const Order& order);

/// uv of every triangle corner, times `scale`.
std::vector<std::array<Vec2, 3>> cornerUv(const Mapped& m, double scale);

/// The surface with its uv, and cones as dots; the caller sets `paint`.
/// @param cells  approximate number of pattern cells along the square root of the surface's area
picture::Scene surfaceScene(const Mapped& m, double cells);
/// The map itself: the cut surface in the plane.
picture::Scene planeScene(const Mapped& m, double cells);

/// Adds seams as lines to both scenes; both sides of a chain have the same colour, and different chains have
/// different colours.
void drawSeams(const Mapped& m, picture::Scene& surface, picture::Scene* plane);

/// μ = |f_z̄| / |f_z| of every triangle.
std::vector<double> muPerFace(const Mapped& m);

/// Grid lines at integers, in q/2 directions: q = 4 squares, q = 6 triangles.
picture::Paint gridPaint(int q, picture::Colour background = {0.93, 0.95, 0.98});
/// Colours from 0 (pale) to `top` (dark).
picture::Colour heat(double value, double top);
picture::Colour coneColour(int k, int q);

}  // namespace hgp::figures

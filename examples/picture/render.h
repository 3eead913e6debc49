// A camera, a depth buffer and one light.  Role: pictures of textured surfaces without a GPU.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hgp/mesh/mesh_data.h"
#include "image.h"

namespace hgp::picture {

/// A spot of the surface under one pixel.
struct Spot {
  int face = 0;
  Vec3 weights{};  ///< barycentric, of the face's corners
  Vec2 uv{};
  double footprint = 0;  ///< uv length of one pixel, with which textures are filtered
};
using Paint = std::function<Colour(const Spot&)>;

struct Line {
  Vec3 from, to;
  Colour colour;
};
struct Dot {
  Vec3 at;
  Colour colour;
};

struct Scene {
  MeshData mesh;
  std::vector<std::array<Vec2, 3>> uv;  ///< per corner
  Paint paint;
  std::vector<Line> lines;
  std::vector<Dot> dots;
  double lineWidth = 2.0, dotRadius = 4.5;  ///< pixels
  bool isFlat = false;                      ///< a planar drawing: viewed from above, without light
};

struct Camera {
  double turn = 30, lift = 20;  ///< degrees around the vertical axis, and upwards
  double zoom = 1;              ///< 1: the whole model fills the picture
  std::optional<Vec3> focus{};  ///< point at the centre; empty: the centre of the model
};

Image render(const Scene& scene, const Camera& camera, int width, int height);

}  // namespace hgp::picture

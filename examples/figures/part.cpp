#include "part.h"

#include "../models/models.h"
#include "hgp/features/creases.h"
#include "hgp/quads/quads.h"
#include "mapped.h"

namespace hgp::figures {
namespace {

/// Quads as pairs of triangles, with their edges as lines.
picture::Scene quadScene(const QuadMesh& quads) {
  picture::Scene scene;
  scene.mesh.positions = quads.positions;
  const picture::Colour ink{0.114, 0.247, 0.388};
  for (const auto& q : quads.quads) {
    scene.mesh.triangles.push_back({q[0], q[1], q[2]});
    scene.mesh.triangles.push_back({q[0], q[2], q[3]});
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t a = static_cast<std::size_t>(q[k]);
      const std::size_t b = static_cast<std::size_t>(q[(k + 1) % 4]);
      if (a < b) scene.lines.push_back({quads.positions[a], quads.positions[b], ink});
    }
  }
  scene.lineWidth = 2;
  scene.paint = [](const picture::Spot&) { return picture::Colour{0.93, 0.95, 0.98}; };
  return scene;
}

}  // namespace

std::vector<picture::Image> partPanels(bool isSmall, const Draw& draw, bool& isCertified) {
  const MeshData data = isSmall ? models::gear(5, 2) : models::gear(9, 4);
  const picture::Camera camera{20, 52, 1};
  std::vector<picture::Image> panels;
  std::optional<Mapped> along;
  for (const bool isAlong : {false, true}) {
    Order order;
    order.grid.cells = isSmall ? 600 : 1800;
    order.grid.mode = GridMode::kQuad;
    if (isAlong) {
      order.spec.emplace();
      if (const Result<TriMesh> mesh = buildTriMesh(data))
        order.spec->features = findCreases(*mesh);
    }
    std::optional<Mapped> m = mapped(isAlong ? "along creases" : "as solved", data, order);
    isCertified =
        isCertified && m && m->result.isCertified && m->result.grid && m->result.grid->isAligned;
    if (!m) continue;
    picture::Scene scene = surfaceScene(*m, 1);
    scene.uv = cornerUv(*m, 1.0);
    scene.paint = gridPaint(4);
    scene.dotRadius = 5;
    panels.push_back(draw(scene, camera));
    along = std::move(m);
  }
  const Result<QuadMesh> quads =
      along ? extractQuads(along->mesh, along->result.map, 4) : Result<QuadMesh>(Failure());
  isCertified = isCertified && quads && quads->clipped == 0;
  if (quads) panels.push_back(draw(quadScene(*quads), camera));
  return panels;
}

}  // namespace hgp::figures

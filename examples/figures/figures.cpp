// figures NAME [-o FILE] [--small]: reproduces the figures of the paper with our own models.

#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>

#include "../models/models.h"
#include "../models/vectors.h"
#include "mapped.h"
#include "part.h"

namespace {

using namespace hgp;
using namespace hgp::figures;
using picture::Camera;
using picture::Image;
using picture::sideBySide;

struct Request {
  std::string output;
  bool isSmall = false;  ///< coarse models, for tests
};

/// A figure; empty if a map is missing, which the caller reports.
struct Drawing {
  std::vector<Image> rows;
  bool isCertified = true;
};

bool take(const std::optional<Mapped>& m, Drawing& drawing) {
  drawing.isCertified = drawing.isCertified && m && m->result.isCertified;
  return m.has_value();
}

/// Pictures are this wide, so that they are sharp on screens with two pixels per CSS pixel.
constexpr int kWidth = 1600;

/// Renders a scene; small for tests, because rendering would take longer than solving.
Image drawn(const Request& request, const picture::Scene& scene, const Camera& camera, int width,
            int height) {
  const int part = request.isSmall ? 6 : 1;
  return render(scene, camera, width / part, height / part);
}

// Fig. 1: four models that are hard for older methods, with the map as a pattern and μ as colours.
Drawing hardModels(const Request& request) {
  const bool isSmall = request.isSmall;
  const std::pair<const char*, MeshData> models[] = {
      {"knot", isSmall ? models::knot(10, 90) : models::knot(12, 110)},
      {"lattice", isSmall ? models::pretzel(26) : models::lattice(44)},
      {"colander", isSmall ? models::colander(3) : models::colander(5)},
      {"creature", isSmall ? models::creature(30) : models::creature(80)}};
  const Camera cameras[] = {{20, 70, 1}, {28, 24, 1}, {20, 12, 1}, {38, 14, 1}};
  Drawing drawing;
  std::vector<Image> patterns, heats;
  for (int i = 0; i < 4; ++i) {
    const std::optional<Mapped> m = mapped(models[i].first, models[i].second, {});
    if (!take(m, drawing)) continue;
    picture::Scene scene = surfaceScene(*m, 34);
    scene.dotRadius = 4.5;
    scene.paint = gridPaint(4);
    patterns.push_back(drawn(request, scene, cameras[i], kWidth / 4, kWidth / 4));
    const std::vector<double> mu = muPerFace(*m);
    scene.paint = [&](const picture::Spot& spot) { return heat(mu[spot.face], 0.5); };
    heats.push_back(drawn(request, scene, cameras[i], kWidth / 4, kWidth / 4));
  }
  drawing.rows = {sideBySide(patterns), sideBySide(heats)};
  return drawing;
}

VertexId nearestVertex(const MeshData& data, const Vec3& p) {
  using namespace hgp::models;
  int best = 0;
  for (int v = 0; v < static_cast<int>(data.positions.size()); ++v) {
    if (norm(data.positions[v] - p) < norm(data.positions[best] - p)) best = v;
  }
  return VertexId(best);
}

/// Rotates, scales and translates uv so that images of cones lie on lattice points: with three cones of 2π/3 the
/// sphere consists of two equal triangles, and then the pattern itself continues across every seam.
void alignToCones(const Mapped& m, picture::Scene& scene, int cells) {
  std::vector<Vec2> images;
  std::vector<char> isSeen(m.data.positions.size(), 0);
  for (std::size_t i = 0; i < m.result.map.uv.size(); ++i) {
    const VertexId v = m.result.copyOf[i];
    for (const ConePoint& c : m.result.spec.cones) {
      if (c.vertex == v && !isSeen[v.i]) {
        isSeen[v.i] = 1;
        images.push_back(m.result.map.uv[i]);
      }
    }
  }
  if (images.size() < 2) return;
  const double dx = images[1][0] - images[0][0], dy = images[1][1] - images[0][1];
  // Lines are at distance 1, so lattice points are 2/√3 apart.
  const double f = cells * 2 / std::sqrt(3.0) / (dx * dx + dy * dy);
  scene.uv = cornerUv(m, 1);
  for (auto& corners : scene.uv) {
    for (Vec2& p : corners) {
      const double x = p[0] - images[0][0], y = p[1] - images[0][1];
      p = {f * (dx * x + dy * y), f * (dx * y - dy * x)};
    }
  }
}

// Fig. 2: q = 6, three cones of 2π/3 on spheres.
Drawing hexagonal(const Request& request) {
  Drawing drawing;
  std::vector<Image> panels;
  const MeshData round = models::sphere(request.isSmall ? 3 : 5);
  const MeshData cube = models::cube(request.isSmall ? 16 : 40);
  for (const auto& [name, data] : {std::pair{"sphere", round}, std::pair{"cube", cube}}) {
    Order order;
    HolonomySpec spec;
    spec.q = 6;
    for (int i = 0; i < 3; ++i) {
      const double a = 2.0944 * i + 0.5;
      spec.cones.push_back({nearestVertex(data, {std::sin(a), 0.35, std::cos(a)}), 2});
    }
    order.q = 6;
    order.spec = spec;
    const std::optional<Mapped> m = mapped(name, data, order);
    if (!take(m, drawing)) continue;
    picture::Scene scene = surfaceScene(*m, 20);
    scene.paint = gridPaint(6);
    alignToCones(*m, scene, 12);
    panels.push_back(drawn(request, scene, {25, 35, 0.95}, kWidth / 4, kWidth / 4));
    panels.push_back(drawn(request, scene, {85, -15, 0.95}, kWidth / 4, kWidth / 4));
  }
  drawing.rows = {sideBySide(panels)};
  return drawing;
}

// Fig. 3: about a million triangles.
Drawing largeModel(const Request& request) {
  Drawing drawing;
  const MeshData data = request.isSmall ? models::creature(40) : models::byName("million");
  const std::optional<Mapped> m = mapped("million", data, {});
  if (!take(m, drawing)) return drawing;
  picture::Scene scene = surfaceScene(*m, 60);
  scene.paint = gridPaint(4);
  scene.dotRadius = 5;
  drawing.rows = {sideBySide({drawn(request, scene, {38, 14, 1}, kWidth / 2, 760),
                              drawn(request, scene, {-60, 20, 1}, kWidth / 2, 760)})};
  return drawing;
}

// Fig. 6: the surface, the map, and the two sides of every seam in one colour.
Drawing twinSeams(const Request& request) {
  Drawing drawing;
  Order order;
  order.coneCount = 12;
  const MeshData data = models::pretzel(request.isSmall ? 30 : 60);
  const std::optional<Mapped> m = mapped("pretzel", data, order);
  if (!take(m, drawing)) return drawing;
  picture::Scene surface = surfaceScene(*m, 24), plane = planeScene(*m, 24);
  surface.paint = plane.paint = gridPaint(4, {0.97, 0.97, 0.97});
  surface.lineWidth = plane.lineWidth = 6;
  drawSeams(*m, surface, &plane);
  drawing.rows = {sideBySide({drawn(request, surface, {20, 50, 1}, kWidth / 2, 760),
                              drawn(request, plane, {}, kWidth / 2, 760)})};
  return drawing;
}

/// Scales the pattern so that its lines are `spacing` apart at vertex v.
void scaleAt(const Mapped& m, VertexId v, double spacing, picture::Scene& scene) {
  using namespace hgp::models;
  double uvLength = 0, length = 0;
  for (HalfedgeId h : outgoingHalfedges(m.mesh, v)) {
    const auto& corners = m.result.map.cornerUv[h.i / 3];
    const Vec2 &a = m.result.map.uv[corners[h.i % 3]], &b = m.result.map.uv[corners[(h.i + 1) % 3]];
    uvLength += std::hypot(b[0] - a[0], b[1] - a[1]);
    length += norm(m.mesh.position(m.mesh.head(h)) - m.mesh.position(v));
  }
  scene.uv = cornerUv(m, length / uvLength / spacing);
}

/// Eight strong cones on a coarse model. In the map of the first program, one cone of 5π has only 3π, and a regular
/// neighbour has 4π, although no triangle is flipped.
HolonomySpec hardCones(const MeshData& data) {
  const std::pair<Vec3, int> cones[] = {
      {{-0.410, -0.083, 0.293}, 8}, {{-0.401, 0.063, -0.278}, 10}, {{-0.419, -0.019, -0.292}, 1},
      {{-0.797, 0.570, 0.159}, 1},  {{-0.533, -0.209, -0.078}, 1}, {{-0.739, 0.074, 0.063}, 1},
      {{-0.349, -0.789, 0.313}, 1}, {{-0.702, -0.042, 0.051}, 1}};
  HolonomySpec spec;
  for (const auto& [place, k] : cones) spec.cones.push_back({nearestVertex(data, place), k});
  return spec;
}

// Fig. 8: the map of the first program with frames, with wrong angles (red at regular vertices), and after frame fixing.
Drawing frameFixing(const Request& request) {
  Drawing drawing;
  const MeshData data = models::creature(26);
  Order order;
  order.spec = hardCones(data);
  order.method = Method::kHarmonic;  // the default untangles here instead
  const VertexId hard = order.spec->cones[1].vertex;
  Camera camera{190, 15, 7, data.positions[hard.i]};
  std::vector<Image> panels;
  // The third round is the first with frames on F_cb; the map of least errors is drawn.
  for (int rounds : {3, 12}) {
    order.maxRounds = rounds;
    const std::optional<Mapped> m = mapped(rounds == 3 ? "before" : "after", data, order);
    if (!m) return {{}, false};
    drawing.isCertified = m->result.isCertified;
    picture::Scene scene = surfaceScene(*m, 1);
    for (const MeasuredCone& wrong : m->result.certificate.angles.wrong) {
      if (wrong.asked == m->result.spec.q) {
        scene.dots.push_back({m->mesh.position(wrong.vertex), {1.0, 0.3, 0.25}});
      }
    }
    scaleAt(*m, hard, 0.02, scene);
    scene.dotRadius = 9;
    scene.paint = gridPaint(4);
    panels.push_back(drawn(request, scene, camera, kWidth / 2, 716));
  }
  drawing.rows = {sideBySide(panels)};
  return drawing;
}

// Fig. 9: conformal distortion with the same cones: frames on all triangles [Lipman 2012], the program as
// printed, ours as solved, and improved. bench/COMPARE.md has the numbers of more surfaces and methods.
Drawing distortion(const Request& request) {
  Drawing drawing;
  const MeshData data = models::creature(request.isSmall ? 36 : 70);
  const std::pair<const char*, Method> methods[] = {{"all frames", Method::kAllFrames},
                                                    {"printed", Method::kPrinted},
                                                    {"as solved", Method::kAuto},
                                                    {"conformal", Method::kAuto}};
  std::vector<Image> panels;
  for (const auto& [name, method] : methods) {
    Order order;
    order.method = method;
    if (std::strcmp(name, "conformal") == 0) order.improve.emplace().balance = -1.0;
    const std::optional<Mapped> m = mapped(name, data, order);
    if (!take(m, drawing)) continue;
    picture::Scene scene = surfaceScene(*m, 40);
    const std::vector<double> mu = muPerFace(*m);
    scene.paint = [&](const picture::Spot& spot) { return heat(mu[spot.face], 0.3); };
    panels.push_back(drawn(request, scene, {38, 14, 1}, 380, 361));
  }
  const int part = request.isSmall ? 6 : 1;
  Image scale(80 / part, 361 / part);
  const int top = 28 / part, bottom = 332 / part;
  for (int y = top; y < bottom; ++y) {
    for (int x = 26 / part; x < 48 / part; ++x)
      scale.at(x, y) = heat(static_cast<double>(bottom - y) / (bottom - top), 1);
  }
  panels.push_back(scale);
  drawing.rows = {sideBySide(panels)};
  return drawing;
}

// Lines across seams (red): as solved, and aligned to a grid.
Drawing alignedLines(const Request& request) {
  const MeshData data = request.isSmall ? models::pretzel(26) : models::rings(70);
  const double cells = request.isSmall ? 900 : 1500;
  Drawing drawing;
  std::vector<Image> panels;
  for (bool isAligned : {false, true}) {
    Order order;
    if (isAligned) order.grid.cells = cells;
    const std::optional<Mapped> m = mapped(isAligned ? "aligned" : "as solved", data, order);
    if (!take(m, drawing)) continue;
    drawing.isCertified =
        drawing.isCertified && (!isAligned || (m->result.grid && m->result.grid->isAligned));
    picture::Scene scene = surfaceScene(*m, std::sqrt(cells));
    if (isAligned) scene.uv = cornerUv(*m, 1.0);
    scene.paint = gridPaint(4);
    drawSeams(*m, scene, nullptr);
    for (picture::Line& line : scene.lines) line.colour = {0.85, 0.08, 0.08};
    scene.dotRadius = 5;
    scene.lineWidth = 3.5;
    panels.push_back(drawn(request, scene, {16, 58, 2.1}, kWidth / 2, 543));
  }
  drawing.rows = {sideBySide(panels)};
  return drawing;
}

// A part with sharp edges: the pattern as solved, along them, and the quads of that map.
Drawing part(const Request& request) {
  Drawing drawing;
  const auto draw = [&](const picture::Scene& scene, const Camera& camera) {
    return drawn(request, scene, camera, kWidth / 3, 420);
  };
  drawing.rows = {sideBySide(partPanels(request.isSmall, draw, drawing.isCertified))};
  return drawing;
}

struct Figure {
  const char* name;
  const char* about;
  std::function<Drawing(const Request&)> draw;
};

const std::vector<Figure>& all() {
  static const std::vector<Figure> kFigures = {
      {"fig1", "four hard models, pattern and distortion", hardModels},
      {"fig2", "q = 6, three cones of 2π/3", hexagonal},
      {"fig3", "a million triangles", largeModel},
      {"fig6", "the two sides of every seam in one colour", twinSeams},
      {"aligned", "lines across seams, as solved and aligned to a grid", alignedLines},
      {"part", "a part, its lines along its sharp edges, and its quads", part},
      {"fig8", "wrong cone angles, and frames fixed", frameFixing},
      {"fig9",
       "conformal distortion, 0 (pale) to 0.3 (dark): frames on all triangles, as printed, as "
       "solved, "
       "and with --improve conformal",
       distortion}};
  return kFigures;
}

int usage() {
  std::fprintf(stderr, "usage: figures NAME [-o FILE.png] [--small]\n");
  for (const Figure& f : all()) std::fprintf(stderr, "  %s  %s\n", f.name, f.about);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  Request request;
  const Figure* figure = nullptr;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--small") == 0) {
      request.isSmall = true;
    } else if (std::strcmp(argv[i], "-o") == 0 && i + 1 < argc) {
      request.output = argv[++i];
    } else {
      for (const Figure& f : all()) figure = std::strcmp(argv[i], f.name) == 0 ? &f : figure;
      if (!figure) return usage();
    }
  }
  if (!figure) return usage();
  if (request.output.empty()) request.output = std::string(figure->name) + ".png";
  const Drawing drawing = figure->draw(request);
  if (!drawing.rows.empty() && !writePng(request.output, picture::stacked(drawing.rows))) {
    std::fprintf(stderr, "figures: cannot write %s\n", request.output.c_str());
    return 7;
  }
  return drawing.isCertified ? 0 : 6;
}

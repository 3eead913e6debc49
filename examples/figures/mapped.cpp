#include "mapped.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "../models/vectors.h"
#include "hgp/field/prepared_surface.h"
#include "hgp/parametrize/along/along_features.h"

namespace hgp::figures {

using picture::Colour;

namespace {

using namespace hgp::models;

void say(const std::string& name, const Mapped& m) {
  const Certificate& c = m.result.certificate;
  std::printf(
      "%s: %d triangles, genus %d, %d loops, %zu cones, %zu rounds, %s, μ mean %.4f "
      "p95 %.4f, area rms log2 %.2f\n",
      name.c_str(), c.faceCount, c.genus, c.loopCount, m.result.spec.cones.size(),
      m.result.rounds.size(), m.result.isCertified ? "certified" : "NOT certified",
      c.distortion.meanMu, c.distortion.p95Mu, c.distortion.rmsLogArea);
  for (const Round& r : m.result.rounds) {
    std::printf("  %s: %s, %d flipped, %d wrong angles, %.2f s\n", r.method.c_str(),
                r.solverStatus.c_str(), r.flipped, r.wrongAngles, r.seconds);
  }
  std::fflush(stdout);
}

/// The i-th of a sequence of clearly different hues.
Colour hue(int i) {
  const double h = std::fmod(i * 0.618034, 1.0) * 6;
  const auto channel = [&](double shift) {
    const double x = std::fmod(h + shift, 6.0);
    return 0.12 + 0.78 * std::clamp(std::abs(x - 3) - 1, 0.0, 1.0);
  };
  return {channel(0), channel(4), channel(2)};
}

/// A colour index per seam edge: the same along a chain of seam edges between two junctions or cones.
PerEdge<int> chainsOf(const Mapped& m) {
  PerEdge<int> chain(static_cast<std::size_t>(m.mesh.edgeCount()), -1);
  PerVertex<std::vector<EdgeId>> at(static_cast<std::size_t>(m.mesh.vertexCount()));
  const auto& seams = m.result.certificate.seams.seams;
  for (const MeasuredSeam& s : seams) {
    const HalfedgeId h = m.mesh.halfedge(s.edge);
    at[m.mesh.tail(h)].push_back(s.edge);
    at[m.mesh.head(h)].push_back(s.edge);
  }
  std::vector<char> isEnd(static_cast<std::size_t>(m.mesh.vertexCount()), 0);
  for (const ConePoint& c : m.result.spec.cones) isEnd[c.vertex.i] = 1;
  int count = 0;
  for (const MeasuredSeam& s : seams) {
    if (chain[s.edge] >= 0) continue;
    std::vector<EdgeId> open{s.edge};
    while (!open.empty()) {
      const EdgeId e = open.back();
      open.pop_back();
      if (chain[e] >= 0) continue;
      chain[e] = count;
      const HalfedgeId h = m.mesh.halfedge(e);
      for (VertexId v : {m.mesh.tail(h), m.mesh.head(h)}) {
        if (at[v].size() != 2 || isEnd[v.i]) continue;
        for (EdgeId other : at[v]) open.push_back(other);
      }
    }
    ++count;
  }
  return chain;
}

double surfaceArea(const MeshData& data) {
  double area = 0;
  for (const auto& t : data.triangles) {
    const Vec3& p = data.positions[t[0]];
    area += norm(cross(data.positions[t[1]] - p, data.positions[t[2]] - p)) / 2;
  }
  return area;
}

}  // namespace

std::optional<Mapped> mapped(const std::string& name, const MeshData& data, const Order& order) {
  Result<TriMesh> mesh = buildTriMesh(data);
  if (!mesh) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), mesh.error().message.c_str());
    return {};
  }
  ParametrizeOptions options;
  options.improve = order.improve;
  options.maxRounds = order.maxRounds;
  options.method = order.method;
  options.grid = order.grid;
  SuggestOptions cones;
  cones.q = order.q;
  cones.coneCount = order.coneCount;
  PreparedSurface surface(*mesh);
  Result<CompleteSpec> chosen =
      order.spec ? Result<CompleteSpec>(CompleteSpec{}) : suggestCones(surface, cones);
  if (!chosen) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), chosen.error().message.c_str());
    return {};
  }
  const HolonomySpec spec = order.spec ? *order.spec : toSpec(*chosen);
  Result<Parametrization> result = spec.features.empty()
                                       ? parametrize(surface, spec, options)
                                       : parametrizeAlongFeatures(surface, spec, options);
  if (!result) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), result.error().message.c_str());
    return {};
  }
  Mapped m{data, std::move(*mesh), std::move(*result)};
  say(name, m);
  return m;
}

std::vector<std::array<Vec2, 3>> cornerUv(const Mapped& m, double scale) {
  std::vector<std::array<Vec2, 3>> out;
  for (const auto& t : m.result.map.cornerUv) {
    std::array<Vec2, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const Vec2& p = m.result.map.uv[t[i]];
      corners[i] = {scale * p[0], scale * p[1]};
    }
    out.push_back(corners);
  }
  return out;
}

picture::Scene surfaceScene(const Mapped& m, double cells) {
  picture::Scene scene;
  scene.mesh = m.data;
  // The map has the surface's area.
  scene.uv = cornerUv(m, cells / std::sqrt(surfaceArea(m.data)));
  for (const ConePoint& c : m.result.spec.cones) {
    scene.dots.push_back({m.mesh.position(c.vertex), coneColour(c.k, m.result.spec.q)});
  }
  return scene;
}

picture::Scene planeScene(const Mapped& m, double cells) {
  picture::Scene scene;
  scene.isFlat = true;
  scene.mesh.triangles = m.result.map.cornerUv;
  for (const Vec2& p : m.result.map.uv) scene.mesh.positions.push_back({p[0], p[1], 0});
  scene.uv = cornerUv(m, cells / std::sqrt(surfaceArea(m.data)));
  std::vector<int> k(static_cast<std::size_t>(m.mesh.vertexCount()), 0);
  for (const ConePoint& c : m.result.spec.cones) k[c.vertex.i] = c.k;
  for (std::size_t i = 0; i < m.result.map.uv.size(); ++i) {
    const int cone = k[m.result.copyOf[i].i];
    if (cone > 0) {
      scene.dots.push_back({scene.mesh.positions[i], coneColour(cone, m.result.spec.q)});
    }
  }
  return scene;
}

void drawSeams(const Mapped& m, picture::Scene& surface, picture::Scene* plane) {
  const PerEdge<int> chain = chainsOf(m);
  for (const MeasuredSeam& s : m.result.certificate.seams.seams) {
    const HalfedgeId h = m.mesh.halfedge(s.edge);
    const Colour colour = hue(chain[s.edge]);
    surface.lines.push_back(
        {m.mesh.position(m.mesh.tail(h)), m.mesh.position(m.mesh.head(h)), colour});
    if (!plane) continue;
    for (HalfedgeId side : {h, m.mesh.twin(h)}) {
      if (!side.isValid()) continue;
      const auto& corners = plane->mesh.triangles[TriMesh::face(side).i];
      plane->lines.push_back({plane->mesh.positions[corners[side.i % 3]],
                              plane->mesh.positions[corners[(side.i + 1) % 3]], colour});
    }
  }
}

std::vector<double> muPerFace(const Mapped& m) {
  const auto uv = cornerUv(m, 1);
  std::vector<double> mu;
  for (std::size_t f = 0; f < uv.size(); ++f) {
    const auto& t = m.data.triangles[f];
    const Vec3 a = m.data.positions[t[1]] - m.data.positions[t[0]];
    const Vec3 b = m.data.positions[t[2]] - m.data.positions[t[0]];
    // The triangle in its own plane: (0, 0), (x1, 0), (x2, y2).
    const double x1 = norm(a), x2 = dot(a, b) / x1, y2 = norm(cross(a, b)) / x1;
    const Vec2 du{uv[f][1][0] - uv[f][0][0], uv[f][1][1] - uv[f][0][1]};
    const Vec2 dv{uv[f][2][0] - uv[f][0][0], uv[f][2][1] - uv[f][0][1]};
    const Vec2 fx{du[0] / x1, du[1] / x1};
    const Vec2 fy{(dv[0] - x2 * fx[0]) / y2, (dv[1] - x2 * fx[1]) / y2};
    const double fz = std::hypot(fx[0] + fy[1], fx[1] - fy[0]);
    const double fzBar = std::hypot(fx[0] - fy[1], fx[1] + fy[0]);
    mu.push_back(fzBar / fz);
  }
  return mu;
}

picture::Paint gridPaint(int q, Colour background) {
  const int directions = q % 2 == 0 ? q / 2 : q;
  return [=](const picture::Spot& spot) {
    double line = 0;
    for (int i = 0; i < directions; ++i) {
      const double a = std::numbers::pi * i / directions;
      const double x = -std::sin(a) * spot.uv[0] + std::cos(a) * spot.uv[1];
      const double distance = std::abs(x - std::round(x));
      const double blur = std::max(spot.footprint, 1e-9);
      const double cover = std::clamp((0.06 + blur / 2 - distance) / blur, 0.0, 1.0);
      // If a cell is smaller than a pixel, only its mean is visible.
      line = std::max(line, blur > 0.5 ? 0.12 : cover);
    }
    return picture::mix(background, {0.114, 0.247, 0.388}, line);  // the page's ink
  };
}

Colour heat(double value, double top) {
  const Colour stops[] = {
      {0.97, 0.97, 0.93}, {0.99, 0.85, 0.5}, {0.93, 0.45, 0.2}, {0.6, 0.1, 0.2}, {0.2, 0.03, 0.15}};
  const double t = std::clamp(value / top, 0.0, 0.9999) * 4;
  const int i = static_cast<int>(t);
  return picture::mix(stops[i], stops[i + 1], t - i);
}

Colour coneColour(int k, int q) {
  // As on the page.
  if (k < q) return {1.0, 0.761, 0.239};  // positive curvature
  if (k == q) return {0.788, 0.824, 0.859};
  return {0.345, 0.706, 1.0};
}

}  // namespace hgp::figures

// Where a cone can go in the disc of a drag, and how frames and scale change with it.
#include <algorithm>

#include "hgp/base/portable_math.h"
#include "hgp/parametrize/live/drag_disc.h"

namespace hgp::live {

std::vector<HalfedgeId> DragDisc::pathTo(VertexId v) const {
  if (ring_[v] < 0 || ring_[v] > reach() || isFixed(v)) return {};
  // Breadth first from the cone, so that the same vertex always has the same path.
  std::vector<VertexId> queue{cone_};
  std::vector<std::pair<VertexId, HalfedgeId>> reached{{cone_, HalfedgeId()}};
  const auto find = [&](VertexId w) {
    return std::find_if(reached.begin(), reached.end(),
                        [&](const auto& r) { return r.first == w; });
  };
  for (std::size_t i = 0; i < queue.size() && find(v) == reached.end(); ++i)
    for (HalfedgeId h : outgoingHalfedges(mesh_, queue[i])) {
      const VertexId w = mesh_.head(h);
      if (isFixed(w) || ring_[w] < 0 || ring_[w] > reach() || find(w) != reached.end()) continue;
      reached.emplace_back(w, h);
      queue.push_back(w);
    }
  std::vector<HalfedgeId> path;
  if (find(v) == reached.end()) return path;
  for (VertexId w = v; w != cone_; w = mesh_.tail(path.back())) path.push_back(find(w)->second);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<VertexId> DragDisc::towards(VertexId v) const {
  std::vector<VertexId> found;
  PerVertex<int> edges(mesh_.vertexCount(), -1);
  std::vector<VertexId> queue{v};
  edges[v] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const VertexId u = queue[i];
    if (edges[cone_] >= 0 && edges[u] >= edges[cone_]) break;
    if (!pathTo(u).empty()) found.push_back(u);
    for (HalfedgeId h : outgoingHalfedges(mesh_, u)) {
      const VertexId w = mesh_.head(h);
      if (edges[w] >= 0) continue;
      edges[w] = edges[u] + 1;
      queue.push_back(w);
    }
  }
  return found;
}

/// e^{Δu − iΔθ}: by how much the field turns and scales a triangle.
Complex DragDisc::changeAt(const MovedField& field, FaceId f) const {
  return portable::polar(portable::exp(field.scaleAt(f)), -field.angleAt(f));
}

/// The mean of these changes out of reach. Fields are defined up to a similarity; this one keeps the map in its place.
Complex DragDisc::gaugeOf(const MovedField& field) const {
  if (far_.empty()) return 1.0;
  double scale = 0.0;
  Complex turn = 0.0;
  for (FaceId f : far_) {
    scale += field.scaleAt(f);
    turn += portable::polar(1.0, -field.angleAt(f));
  }
  const double size = portable::abs(turn);
  const double mean = portable::exp(scale / static_cast<double>(far_.size()));
  return size > 0.0 ? mean * turn / size : Complex(mean);
}

Complex DragDisc::targetAt(const MovedField& field, FaceId f) const {
  const Complex frame = portable::polar(portable::exp(scaleAt(f)), -setup_.seams.frameAngle[f]);
  return changeAt(field, f) / gaugeOf(field) * scale_ * frame;
}

/// x*, numbered as `cut` does.
Eigen::VectorXcd DragDisc::startOf(const MovedCut& cut) const {
  Eigen::VectorXcd x = x_;
  if (cut.reusedUnknown() >= 0)
    x[cut.reusedUnknown()] = valueOf(still_.termsOf(cut.path().front()), x_);
  return x;
}

}  // namespace hgp::live

#include "hgp/parametrize/live/moved_field.h"

#include <Eigen/Dense>

#include "hgp/mesh/face_flood.h"

namespace hgp::live {

MovedField::MovedField(const TriMesh& mesh, const FieldContext& context)
    : mesh_(mesh), context_(context), angle_(static_cast<std::size_t>(mesh.faceCount()), 0.0) {
  PerFace<char> isSeen(static_cast<std::size_t>(mesh.faceCount()), 0);
  isSeen[FaceId(0)] = 1;
  tree_.reserve(static_cast<std::size_t>(mesh.faceCount()));
  floodFaces(mesh, FaceId(0), [&](HalfedgeId h, FaceId g) {
    if (isSeen[g]) return false;
    isSeen[g] = 1;
    tree_.push_back(h);
    return true;
  });
}

void MovedField::moveScale(int q, ConePoint cone, VertexId to) {
  const double curvature = coneCurvature(cone.k, q);
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(context_.surface.nodeCount);
  gap[context_.surface.node[cone.vertex]] -= curvature;
  gap[context_.surface.node[to]] += curvature;
  u_ = context_.laplacian.solve(gap);
}

void MovedField::move(int q, ConePoint cone, VertexId to, const MovedCut& cut) {
  moveScale(q, cone, to);
  correctHandles(q, cut);
  for (HalfedgeId h : tree_)
    angle_[TriMesh::face(mesh_.twin(h))] =
        angle_[TriMesh::face(h)] + omega(h) - turnAngle(cut.pathTurnAcross(h), q);
}

/// Δω across h, from face(h) to its twin's.
double MovedField::omega(HalfedgeId h) const {
  const EdgeId e = mesh_.edge(h);
  const HalfedgeId own = mesh_.halfedge(e);
  const std::vector<int>& node = context_.surface.node.raw();
  double value = u_[node[at(mesh_.head(own).i)]] - u_[node[at(mesh_.tail(own).i)]];
  if (harmonic_.size() > 0) value += harmonic_[e];
  value *= context_.surface.weight[e];
  return own == h ? value : -value;
}

void MovedField::correctHandles(int q, const MovedCut& cut) {
  const HandleBasis& handles = context_.handles;
  harmonic_ = {};
  handleChange_.assign(handles.loops.size(), 0);
  if (handles.loops.empty()) return;
  Eigen::VectorXd missing(static_cast<Eigen::Index>(handles.loops.size()));
  for (std::size_t i = 0; i < handles.loops.size(); ++i) {
    double have = 0.0;
    for (HalfedgeId h : handles.loops[i].crossed) {
      handleChange_[i] += cut.pathTurnAcross(h);
      have += omega(h);
    }
    missing[static_cast<Eigen::Index>(i)] = principalAngle(turnAngle(handleChange_[i], q) - have);
  }
  harmonic_ = combineForms(mesh_, context_.surface, handles, handles.periods.ldlt().solve(missing));
}

double MovedField::scaleAt(VertexId v) const {
  const int node = context_.surface.node[v];
  return node < 0 ? 0.0 : u_[node];
}

double MovedField::scaleAt(FaceId f) const {
  double sum = 0.0;
  for (VertexId v : mesh_.corners(f)) sum += scaleAt(v);
  return sum / 3.0;
}

}  // namespace hgp::live

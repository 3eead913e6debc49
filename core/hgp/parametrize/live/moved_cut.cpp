#include "hgp/parametrize/live/moved_cut.h"

namespace hgp::live {

MovedCut::MovedCut(const TriMesh& mesh, const CutMesh& cut, const SeamRotations& seams,
                   const ReducedUnknowns& unknowns, VertexId cone)
    : mesh_(mesh),
      cut_(cut),
      seams_(seams),
      unknowns_(unknowns),
      uvCount_(cut.vertexCount()),
      movedAt_(static_cast<std::size_t>(mesh.halfedgeCount()), -1) {
  for (HalfedgeId h : outgoingHalfedges(mesh, cone)) turn_ += seams.rotation[TriMesh::previous(h)];
  turn_ = reduceTurn(turn_, seams.q);
}

void MovedCut::move(std::vector<HalfedgeId> path) {
  for (const Copy& copy : moved_)
    for (HalfedgeId h : copy.corners) movedAt_[h] = -1;
  moved_.clear();
  uvCount_ = cut_.vertexCount();
  reused_ = -1;
  path_ = std::move(path);
  if (path_.empty() || turn_ == 0) return;
  reused_ = unknowns_.vertexUnknown[mesh_.head(path_.back())];
  moveStart();
  Terms point = anchored(path_.front());
  for (std::size_t i = 1; i < path_.size(); ++i)
    point = passVertex(std::move(point), path_[i - 1], path_[i]);
  placeCone(std::move(point), path_.back());
}

/// The position of a corner before the move.
Terms MovedCut::anchored(HalfedgeId corner) const {
  Terms terms;
  for (SparseRows::InnerIterator it(unknowns_.copies, cut_.copy[corner].i); it; ++it)
    terms.push_back({static_cast<int>(it.col()), it.value()});
  return terms;
}

/// A point in the chart of face(h), seen from the face across h.
Terms MovedCut::crossed(const Terms& point, HalfedgeId h) const {
  if (!cut_.isSeam[mesh_.edge(h)]) return point;
  const Complex R = rotation(seams_.rotation[h], seams_.q);
  Terms there = anchored(TriMesh::next(mesh_.twin(h)));  // the tail of h
  add(anchored(h), -R, there);
  add(point, R, there);
  return there;
}

void MovedCut::begin(int uv, VertexId vertex, Terms position) {
  moved_.push_back({uv, vertex, std::move(position), {}});
}

void MovedCut::append(HalfedgeId corner) {
  moved_.back().corners.push_back(corner);
  movedAt_[corner] = static_cast<int>(moved_.size()) - 1;
}

/// The cone's old vertex, once around counterclockwise from the path: ζ_s + R_s (x − ζ) in sector s. The sector that the
/// path divides gets one more copy.
void MovedCut::moveStart() {
  const HalfedgeId first = path_.front();
  const VertexId v = mesh_.tail(first);
  const Terms centre = anchored(first);
  const auto beginSector = [&](HalfedgeId h, int turn) {
    const Complex R = rotation(turn, seams_.q);
    Terms position = anchored(h);
    add(centre, -R, position);
    add({{reused_, 1.0}}, R, position);
    const bool isDivided = h != first && cut_.copy[h] == cut_.copy[first];
    begin(isDivided ? uvCount_++ : cut_.copy[h].i, v, std::move(position));
  };
  int turn = 0;
  beginSector(first, turn);
  append(first);
  for (HalfedgeId crossing = TriMesh::previous(first);;
       crossing = TriMesh::previous(mesh_.twin(crossing))) {
    const HalfedgeId h = mesh_.twin(crossing);
    if (h == first) return;
    if (cut_.isSeam[mesh_.edge(crossing)]) {
      turn += seams_.rotation[crossing];
      beginSector(h, turn);
    }
    append(h);
  }
}

/// Clockwise around a vertex of the path, from the left of `in` to the left of `out`, and on to the right of `in`.
/// @param point  ζ in the chart to the left of `in`; returned in the chart to the left of `out`
Terms MovedCut::passVertex(Terms point, HalfedgeId in, HalfedgeId out) {
  HalfedgeId h = TriMesh::next(in);
  for (; h != out; h = TriMesh::next(mesh_.twin(h))) point = crossed(point, h);
  const Complex R = rotation(turn_, seams_.q);
  Terms right = point;
  while (h != mesh_.twin(in)) {
    right = crossed(right, h);
    const bool isNextSector = h == out || cut_.isSeam[mesh_.edge(h)];
    h = TriMesh::next(mesh_.twin(h));
    if (isNextSector) {
      Terms position;
      add(right, 1.0 - R, position);
      add(anchored(h), R, position);
      begin(uvCount_++, mesh_.tail(h), std::move(position));
    }
    append(h);
  }
  return point;
}

/// The path's end, once around clockwise from the left of `in` to its right: ζ in every chart.
void MovedCut::placeCone(Terms point, HalfedgeId in) {
  HalfedgeId h = TriMesh::next(in);
  begin(cut_.copy[h].i, mesh_.tail(h), point);
  append(h);
  while (h != mesh_.twin(in)) {
    point = crossed(point, h);
    const bool isNextSector = cut_.isSeam[mesh_.edge(h)];
    h = TriMesh::next(mesh_.twin(h));
    if (isNextSector) begin(cut_.copy[h].i, mesh_.tail(h), point);
    append(h);
  }
}

Terms MovedCut::termsOf(HalfedgeId corner) const {
  const int at = movedAt_[corner];
  return at < 0 ? anchored(corner) : moved_[static_cast<std::size_t>(at)].position;
}

int MovedCut::uvOf(HalfedgeId corner) const {
  const int at = movedAt_[corner];
  return at < 0 ? cut_.copy[corner].i : moved_[static_cast<std::size_t>(at)].uv;
}

int MovedCut::pathTurnAcross(HalfedgeId h) const {
  if (turn_ == 0) return 0;
  const EdgeId e = mesh_.edge(h);
  for (HalfedgeId on : path_)
    if (mesh_.edge(on) == e) return on == h ? turn_ : -turn_;
  return 0;
}

int MovedCut::turnAcross(HalfedgeId h) const {
  return reduceTurn(seams_.rotation[h] + pathTurnAcross(h), seams_.q);
}

}  // namespace hgp::live

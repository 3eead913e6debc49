#include "hgp/field/read_holonomy.h"

#include <cmath>

#include "hgp/base/check.h"

namespace hgp {
namespace {

Failure malformed(const std::string& message) {
  return Failure{ErrorCode::kMalformed, "field", message, {}};
}

/// Angles of 3D directions in each face's own coordinates (corner 0 → corner 1 is angle 0).
PerFace<double> directionAngles(const TriMesh& mesh, const std::vector<Vec3>& directions) {
  PerFace<double> angle(static_cast<std::size_t>(mesh.faceCount()), 0.0);
  for (FaceId f : mesh.faces()) {
    const auto [a, b, c] = mesh.corners(f);
    const auto edge = [&](VertexId from, VertexId to) {
      Vec3 e{};
      for (std::size_t i = 0; i < 3; ++i) e[i] = mesh.position(to)[i] - mesh.position(from)[i];
      return e;
    };
    const auto dot = [](const Vec3& x, const Vec3& y) {
      return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    };
    const Vec3 e1 = edge(a, b), e2 = edge(a, c);
    const double length = std::sqrt(dot(e1, e1));
    // The second axis is e2 without its part along e1.
    Vec3 axis{};
    for (std::size_t i = 0; i < 3; ++i) axis[i] = e2[i] - e1[i] * dot(e1, e2) / (length * length);
    const double height = std::sqrt(dot(axis, axis));
    const Vec3& d = directions[static_cast<std::size_t>(f.i)];
    angle[f] = std::atan2(dot(d, axis) / height, dot(d, e1) / length);
  }
  return angle;
}

Status storeMatchings(const TriMesh& mesh, const std::vector<Matching>& matchings, int sign,
                      FrameField& field) {
  field.matching = PerHalfedge<int>(static_cast<std::size_t>(mesh.halfedgeCount()), 0);
  for (const Matching& m : matchings) {
    if (m.from < 0 || m.from >= mesh.faceCount())
      return malformed("A matching names face " + std::to_string(m.from) + "; the mesh has " +
                       std::to_string(mesh.faceCount()) + ".");
    HalfedgeId found;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(FaceId(m.from), k);
      if (mesh.tail(h).i == m.tail && mesh.head(h).i == m.head) found = h;
    }
    if (!found.isValid() || mesh.isBoundary(found) ||
        (m.to >= 0 && TriMesh::face(mesh.twin(found)).i != m.to))
      return malformed("A matching names edge " + std::to_string(m.tail) + " → " +
                       std::to_string(m.head) + " of face " + std::to_string(m.from) +
                       ", which is no interior edge of the mesh.");
    field.matching[found] = sign * m.turn;
    field.matching[mesh.twin(found)] = -sign * m.turn;
  }
  return Done{};
}

/// −Σ matchings ccw around v: k_v mod q.
int angleClass(const TriMesh& mesh, const FrameField& field, VertexId v) {
  long long sum = 0;
  for (HalfedgeId h : outgoingHalfedges(mesh, v)) sum += field.matching[h];
  return reduceTurn(sum, field.q);
}

/// Σ matchings ccw around a shrunk loop: l mod q.
int turningClass(const TriMesh& mesh, const FrameField& field, const BoundaryLoop& loop) {
  long long sum = 0;
  for (HalfedgeId boundary : loop.halfedges)
    for (HalfedgeId h : outgoingHalfedges(mesh, mesh.tail(boundary))) sum -= field.matching[h];
  return reduceTurn(sum, field.q);
}

/// l_j in the given classes mod q, nearest to the loops' own turning, balancing Lemma 6.2.
std::vector<int> liftTurning(const TriMesh& mesh, const FieldContext& context,
                             const FrameField& field, const std::vector<ConePoint>& cones) {
  const auto& loops = context.topology.loops;
  const int q = field.q;
  std::vector<int> turning;
  std::vector<double> natural;
  long long left =
      static_cast<long long>(q) * (2 - 2 * context.topology.genus - static_cast<int>(loops.size()));
  for (const ConePoint& cone : cones) left -= q - cone.k;
  for (const BoundaryLoop& loop : loops) {
    double turned = 0.0;
    for (HalfedgeId h : loop.halfedges) turned += curvature(mesh, context.geometry, mesh.tail(h));
    natural.push_back(q * turned / (2.0 * kPi));
    const int c = turningClass(mesh, field, loop);
    turning.push_back(c + q * static_cast<int>(std::lround((natural.back() - c) / q)));
    left -= turning.back();
  }
  while (left != 0 && !turning.empty() && left % q == 0) {
    const int step = left > 0 ? q : -q;
    std::size_t best = 0;
    double bestCost = 1e300;
    for (std::size_t j = 0; j < turning.size(); ++j) {
      const double cost =
          std::abs(turning[j] + step - natural[j]) - std::abs(turning[j] - natural[j]);
      if (cost < bestCost) best = j, bestCost = cost;
    }
    turning[best] += step;
    left -= step;
  }
  return turning;
}

/// Number of interior vertices whose class does not match the cones that came along.
int disagreements(const TriMesh& mesh, const FrameField& field,
                  const std::vector<ConePoint>& expected) {
  PerVertex<int> k(static_cast<std::size_t>(mesh.vertexCount()), field.q);
  for (const ConePoint& cone : expected) k[cone.vertex] = cone.k;
  int count = 0;
  for (VertexId v : mesh.vertices())
    if (!mesh.isIsolated(v) && !mesh.isBoundary(v))
      count += angleClass(mesh, field, v) != reduceTurn(k[v], field.q);
  return count;
}

CompleteSpec specWithCones(const TriMesh& mesh, const FieldContext& context,
                           const FrameField& field, const std::vector<ConePoint>& cones) {
  CompleteSpec spec;
  spec.q = field.q;
  for (const ConePoint& cone : cones)
    if (cone.k != field.q) spec.cones.push_back(cone);
  spec.turning = liftTurning(mesh, context, field, spec.cones);
  for (const DualLoop& loop : context.handles.loops)
    spec.handles.push_back(loopHolonomy(field, loop));
  return spec;
}

/// The nearest cones in the matchings' classes when no directions tell more.
std::vector<ConePoint> conesOfClasses(const TriMesh& mesh, const FrameField& field) {
  std::vector<ConePoint> cones;
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v) || mesh.isBoundary(v)) continue;
    const int c = angleClass(mesh, field, v);
    if (c != 0) cones.push_back({v, 2 * c < field.q ? c + field.q : c});
  }
  return cones;
}

}  // namespace

CompleteSpec specOfField(const TriMesh& mesh, const FieldContext& context,
                         const FrameField& field) {
  CompleteSpec spec;
  spec.q = field.q;
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v) || mesh.isBoundary(v)) continue;
    const int k = inducedAngleIndex(mesh, context.geometry, field, v);
    if (k != field.q) spec.cones.push_back({v, k});
  }
  for (const BoundaryLoop& loop : context.topology.loops)
    spec.turning.push_back(inducedTurning(mesh, context.geometry, field, loop));
  for (const DualLoop& loop : context.handles.loops)
    spec.handles.push_back(loopHolonomy(field, loop));
  return spec;
}

Result<CompleteSpec> specOfFieldData(const TriMesh& mesh, const FieldContext& context,
                                     const FieldData& data,
                                     const std::vector<ConePoint>& expected) {
  FrameField field;
  field.q = data.order;
  const bool hasDirections = !data.directions.empty();
  if (hasDirections && static_cast<int>(data.directions.size()) != mesh.faceCount())
    return malformed("The field has " + std::to_string(data.directions.size()) +
                     " faces, the mesh " + std::to_string(mesh.faceCount()) + ".");
  if (!hasDirections && !data.hasMatchings)
    return malformed("The field has neither directions nor matchings.");
  if (hasDirections) field.angle = directionAngles(mesh, data.directions);
  if (!data.hasMatchings) {
    matchPrincipally(mesh, context.geometry, field);
    return specOfField(mesh, context, field);
  }
  // Files differ in the sign of a matching; the one that reproduces the cones (or, without cones,
  // that stays closer to transport) is meant.
  if (Status stored = storeMatchings(mesh, data.matchings, 1, field); !stored)
    return std::move(stored).error();
  FrameField flipped = field;
  for (int& r : flipped.matching.raw()) r = -r;
  if (!expected.empty() || !hasDirections) {
    if (expected.empty()) return specWithCones(mesh, context, field, conesOfClasses(mesh, field));
    const int wrong = disagreements(mesh, field, expected);
    const int wrongFlipped = wrong ? disagreements(mesh, flipped, expected) : 0;
    if (wrong && wrongFlipped)
      return Failure{ErrorCode::kPrescription,
                     "field",
                     "The matchings contradict the cones at " +
                         std::to_string(std::min(wrong, wrongFlipped)) +
                         " vertices, with either sign: Σ of matchings around a vertex must be −k "
                         "(mod q). Is this the mesh they belong to?",
                     {}};
    return specWithCones(mesh, context, wrong ? flipped : field, expected);
  }
  const CompleteSpec asStored = specOfField(mesh, context, field);
  const CompleteSpec asFlipped = specOfField(mesh, context, flipped);
  return asStored.cones.size() <= asFlipped.cones.size() ? asStored : asFlipped;
}

}  // namespace hgp

#include "hgp/field/read_holonomy.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

Failure malformed(const std::string& message) {
  return Failure{ErrorCode::kMalformed, "field", message, {}};
}

/// Angles of 3D directions in each face's own coordinates (corner 0 → corner 1 is angle 0).
Status directionAngles(const TriMesh& mesh, const std::vector<Vec3>& directions,
                       PerFace<double>& angle) {
  angle = PerFace<double>(static_cast<std::size_t>(mesh.faceCount()), 0.0);
  std::vector<Where> without;
  for (FaceId f : mesh.faces()) {
    const auto [a, b, c] = mesh.corners(f);
    const Vec3 e1 = subtract(mesh.position(b), mesh.position(a));
    const Vec3 e2 = subtract(mesh.position(c), mesh.position(a));
    const double length = norm(e1);
    // The second axis is e2 minus its component along e1.
    Vec3 axis{};
    for (std::size_t i = 0; i < 3; ++i) axis[i] = e2[i] - e1[i] * dot(e1, e2) / (length * length);
    const double height = norm(axis);
    const Vec3& d = directions[static_cast<std::size_t>(f.i)];
    const double x = dot(d, e1) / length, y = dot(d, axis) / height;
    angle[f] = portable::atan2(y, x);
    const bool isDirection = std::isfinite(x) && std::isfinite(y) && (x != 0.0 || y != 0.0);
    if (!isDirection) without.push_back({Where::Kind::kFace, f.i});
  }
  if (without.empty()) return Done{};
  Failure failure = malformed(
      formatText("The field has triangles without a direction (%zu of %d): a direction must be "
                 "finite and not normal to its triangle.",
                 without.size(), mesh.faceCount()));
  failure.where = std::move(without);
  return failure;
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

/// −Σ of the matchings counterclockwise around v: k_v mod q.
int angleClass(const TriMesh& mesh, const FrameField& field, VertexId v) {
  long long sum = 0;
  for (HalfedgeId h : outgoingHalfedges(mesh, v)) sum += field.matching[h];
  return reduceTurn(sum, field.q);
}

/// Σ of the matchings counterclockwise around a loop shrunk to a point: l mod q.
int turningClass(const TriMesh& mesh, const FrameField& field, const BoundaryLoop& loop) {
  long long sum = 0;
  for (HalfedgeId boundary : loop.halfedges)
    for (HalfedgeId h : outgoingHalfedges(mesh, mesh.tail(boundary))) sum -= field.matching[h];
  return reduceTurn(sum, field.q);
}

/// The l_j in the given classes mod q nearest to the loops' own turning that satisfy Lemma 6.2.
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

/// Number of interior vertices whose class mod q differs from that of the expected cones.
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

/// Number of interior vertices at which the two lists of cones differ.
int differences(const TriMesh& mesh, int q, const std::vector<ConePoint>& a,
                const std::vector<ConePoint>& b) {
  PerVertex<int> k(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (const ConePoint& cone : a) k[cone.vertex] += cone.k - q;
  for (const ConePoint& cone : b) k[cone.vertex] -= cone.k - q;
  return mesh.vertexCount() - static_cast<int>(std::count(k.raw().begin(), k.raw().end(), 0));
}

/// Without directions: the cones in the classes of the matchings with k nearest to q.
std::vector<ConePoint> conesOfClasses(const TriMesh& mesh, const FrameField& field) {
  std::vector<ConePoint> cones;
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v) || mesh.isBoundary(v)) continue;
    const int c = angleClass(mesh, field, v);
    if (c != 0) cones.push_back({v, 2 * c < field.q ? c + field.q : c});
  }
  return cones;
}

/// How badly the stored matchings fit if they are read with one sign.
struct Fit {
  int wrong = 0;      ///< vertices whose class is not that of the expected cones
  int foreign = 0;    ///< vertices where the cones of the directions are not those expected
  double turn = 0.0;  ///< squaredTurn

  /// If the counts are equal, the distance from transport decides, but only if it differs clearly: a field that
  /// is far from transport with either sign is read as stored.
  bool isClearlyBetterThan(const Fit& other) const {
    const auto key = std::pair(wrong, foreign), otherKey = std::pair(other.wrong, other.foreign);
    return key < otherKey || (key == otherKey && turn < 0.5 * other.turn);
  }
};

/// The fit of `read`, whose prescription is also set. If the directions have the expected cones, they also determine
/// the turning indices of the loops.
Fit fitOf(const TriMesh& mesh, const FieldContext& context, ReadField& read,
          const std::vector<ConePoint>& expected) {
  const FrameField& field = read.field;
  const int wrong = expected.empty() ? 0 : disagreements(mesh, field, expected);
  if (field.angle.size() == 0) {
    const bool isGiven = !expected.empty();
    read.spec =
        specWithCones(mesh, context, field, isGiven ? expected : conesOfClasses(mesh, field));
    return {wrong, 0, 0.0};
  }
  read.spec = specOfField(mesh, context, field);
  const int foreign = differences(mesh, field.q, read.spec.cones, expected);
  if (foreign > 0 && !expected.empty()) read.spec = specWithCones(mesh, context, field, expected);
  return {wrong, foreign, squaredTurn(mesh, context.geometry, field)};
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

Result<ReadField> fieldOfFieldData(const TriMesh& mesh, const FieldContext& context,
                                   const FieldData& data, const std::vector<ConePoint>& expected) {
  ReadField read;
  FrameField& field = read.field;
  field.q = data.order;
  const bool hasDirections = !data.directions.empty();
  if (hasDirections && static_cast<int>(data.directions.size()) != mesh.faceCount())
    return malformed("The field has " + std::to_string(data.directions.size()) +
                     " faces, the mesh " + std::to_string(mesh.faceCount()) + ".");
  if (!hasDirections && !data.hasMatchings)
    return malformed("The field has neither directions nor matchings.");
  if (hasDirections) {
    if (Status done = directionAngles(mesh, data.directions, field.angle); !done)
      return std::move(done).error();
  }
  if (!data.hasMatchings) {
    matchPrincipally(mesh, context.geometry, field);
    read.spec = specOfField(mesh, context, field);
    return read;
  }
  if (Status stored = storeMatchings(mesh, data.matchings, 1, field); !stored)
    return std::move(stored).error();
  ReadField flipped = read;
  for (int& r : flipped.field.matching.raw()) r = -r;
  const Fit fit = fitOf(mesh, context, read, expected);
  const Fit flippedFit = fitOf(mesh, context, flipped, expected);
  const bool isFlipped = flippedFit.isClearlyBetterThan(fit);
  const int wrong = isFlipped ? flippedFit.wrong : fit.wrong;
  if (wrong > 0)
    return Failure{ErrorCode::kPrescription,
                   "field",
                   "The matchings contradict the cones at " + std::to_string(wrong) +
                       " vertices, with either sign: Σ of matchings around a vertex must be −k "
                       "(mod q). Is this the mesh they belong to?",
                   {}};
  return isFlipped ? std::move(flipped) : std::move(read);
}

Result<CompleteSpec> specOfFieldData(const TriMesh& mesh, const FieldContext& context,
                                     const FieldData& data,
                                     const std::vector<ConePoint>& expected) {
  Result<ReadField> read = fieldOfFieldData(mesh, context, data, expected);
  if (!read) return std::move(read).error();
  return std::move(read->spec);
}

}  // namespace hgp

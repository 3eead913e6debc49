#include "hgp/api/request/feature_request.h"

#include <algorithm>

#include "hgp/api/request/file_marks.h"
#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/features/creases.h"
#include "hgp/mesh/finite.h"
#include "hgp/mesh/vectors.h"

namespace hgp::api {
namespace {

// If the mesh has changed, a vertex is searched within this fraction of the bounding box's diagonal.
constexpr double kSameFeaturePlace = 1e-6;

using Pair = std::array<int, 2>;

Pair sorted(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

Failure refusedFeature(std::string message, std::vector<Where> where = {}, Notes advice = {}) {
  return {ErrorCode::kPrescription, "features", std::move(message), std::move(where),
          std::move(advice)};
}

/// Whether the list of features names a file, and it is not this one.
bool isForAnotherFile(const Model& model, const prescription::Prescription& asked) {
  const std::string& own = asked.features.sha256;
  const std::string& sha = own.empty() ? asked.sha256 : own;
  return !sha.empty() && sha != model.sha256;
}

/// Pairs by the vertices that stand for them after welds, ascending and without repetition.
std::vector<Pair> afterWelds(const Model& model, std::vector<Pair> pairs) {
  const auto standIn = [&model](int v) {
    const MeshVertexId image = model.vertexImage[SurfaceVertexId{v}];
    return image.isValid() ? model.vertexOrigin[image].i : v;
  };
  for (Pair& ends : pairs) ends = sorted(standIn(ends[0]), standIn(ends[1]));
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Pairs of vertices of which some are edges of the mesh.
class PairSet {
 public:
  explicit PairSet(std::vector<Pair> pairs)
      : pairs_(std::move(pairs)), isFound_(pairs_.size(), 0) {}

  /// Whether the pair is in the set, which then knows that it is an edge.
  bool take(const Pair& ends) {
    const auto found = std::lower_bound(pairs_.begin(), pairs_.end(), ends);
    if (found == pairs_.end() || *found != ends) return false;
    isFound_[at(found - pairs_.begin())] = 1;
    return true;
  }
  std::size_t size() const { return pairs_.size(); }
  /// The pairs that were not taken.
  std::vector<Where> rest() const {
    std::vector<Where> where;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      if (!isFound_[i]) where.push_back({Where::Kind::kEdge, pairs_[i][0], pairs_[i][1]});
    return where;
  }

 private:
  std::vector<Pair> pairs_;
  std::vector<char> isFound_;
};

/// Notes on what of the listed and the marked pairs is no edge; fails for a listed pair, and where no mark is an edge.
Status checkFound(const PairSet& listed, const PairSet& marked, Notes& notes) {
  if (std::vector<Where> where = listed.rest(); !where.empty()) {
    const std::string count = counted(where.size(), "feature is no edge", "features are no edges");
    return refusedFeature(count + " of the mesh. Is this the mesh they were made for?",
                          std::move(where));
  }
  std::vector<Where> where = marked.rest();
  if (where.empty()) return Done{};
  const std::size_t pairs = where.size();
  if (pairs == marked.size())
    return refusedFeature("the file marks " + counted(pairs, "pair", "pairs") +
                              " of vertices, and none is an edge of the mesh",
                          std::move(where), {Note("find-creases")});
  notes.push_back(Note("marks-no-edges", {{"pairs", pairs}}, std::move(where)));
  return Done{};
}

/// Says how the vertices of a list for another file were found.
void addMovedNote(const prescription::PrescribedFeatures& features, Notes& notes) {
  const auto& lines = features.lines;
  if (lines.empty() && features.sides.empty()) return;
  const bool arePlaced = std::all_of(lines.begin(), lines.end(),
                                     [](const auto& line) { return !line.positions.empty(); });
  notes.push_back(
      Note("features-other-file", {{"placed", arePlaced && features.sides.empty() ? 1 : 0}}));
}

/// Says where creases were asked for, and no edge of the file is a feature.
void addNoneNote(const Model& model, const prescription::PrescribedFeatures& asked,
                 Request& request) {
  const auto hasFeatures = [](const ComponentRequest& c) { return !c.spec.features.empty(); };
  const auto& components = request.components;
  if (!asked.creaseDegrees || std::any_of(components.begin(), components.end(), hasFeatures))
    return;
  request.notes.push_back(Note(
      "creases-none", {{"degrees", *asked.creaseDegrees}, {"rims", model.topology.loops.size()}}));
}

class FeatureFinder {
 public:
  FeatureFinder(const Model& model, const prescription::Prescription& asked)
      : model_(model), asked_(asked), positions_(model.source().mesh.positions) {
    isMoved_ = isForAnotherFile(model, asked) || !model.hasOwnVertexIds;
    reach_ = kSameFeaturePlace * diagonal(finiteBoxOf(positions_));
  }

  /// All asked edges as pairs of surface vertices, ascending.
  Result<std::vector<Pair>> run() {
    for (const prescription::PrescribedLine& line : asked_.features.lines) {
      int before = -1;
      for (std::size_t i = 0; i < line.vertices.size(); ++i) {
        Result<int> v = vertex(line, i);
        if (!v) return std::move(v).error();
        if (i > 0) pairs_.push_back(sorted(before, *v));
        before = *v;
      }
    }
    if (Status done = addSides(); !done) return std::move(done).error();
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    return std::move(pairs_);
  }

 private:
  Result<int> vertex(const prescription::PrescribedLine& line, std::size_t i) const {
    const int v = line.vertices[i], count = static_cast<int>(positions_.size());
    if (line.positions.empty() && !model_.hasOwnVertexIds)
      return refusedFeature(
          "vertices get new ids when the file is converted to another format: features need "
          "positions (those of hgp-cones have them), or the ids of the new file");
    const bool isThere = v >= 0 && v < count;
    if (isMoved_ && !line.positions.empty()) {
      const Vec3& p = line.positions[i];
      if (isThere && distance(positions_[at(v)], p) <= reach_) return v;
      const auto nearest = std::min_element(
          positions_.begin(), positions_.end(),
          [&](const Vec3& a, const Vec3& b) { return distance(a, p) < distance(b, p); });
      if (nearest == positions_.end() || distance(*nearest, p) > reach_)
        return refusedFeature(
            formatText("no vertex within %.3g of the feature at (%.9g, %.9g, %.9g)", reach_, p[0],
                       p[1], p[2]));
      return static_cast<int>(nearest - positions_.begin());
    }
    if (isThere) return v;
    return refusedFeature(
        formatText("feature at vertex %d: the mesh has vertices 0 to %d", v, count - 1));
  }

  Status addSides() {
    if (asked_.features.sides.empty()) return Done{};
    if (!model_.hasOwnFaceIds)
      return refusedFeature("features refer to triangles, which get new ids in the other format");
    const auto& triangles = model_.source().mesh.triangles;
    for (const auto& [face, side] : asked_.features.sides) {
      if (face < 0 || at(face) >= triangles.size() || side < 0 || side > 2)
        return refusedFeature(formatText("features name side %d of triangle %d; the mesh has %s",
                                         side, face,
                                         counted(triangles.size(), "triangle").c_str()));
      const auto& corners = triangles[at(face)];
      pairs_.push_back(sorted(corners[at(side)], corners[at((side + 1) % 3)]));
    }
    return Done{};
  }

  const Model& model_;
  const prescription::Prescription& asked_;
  const std::vector<Vec3>& positions_;
  bool isMoved_ = false;
  double reach_ = 0.0;
  std::vector<Pair> pairs_;
};

}  // namespace

Status addFeatures(const Model& model, const prescription::Prescription& prescription,
                   Request& request) {
  if (prescription.features.isEmpty()) return Done{};
  Result<std::vector<Pair>> pairs = FeatureFinder(model, prescription).run();
  if (!pairs) return std::move(pairs).error();
  Result<std::vector<Pair>> marked = markedEdges(model, prescription.features.marks);
  if (!marked) return std::move(marked).error();
  PairSet listed(afterWelds(model, std::move(*pairs)));
  PairSet marks(afterWelds(model, std::move(*marked)));
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    const ModelComponent& component = model.components[p];
    const TriMesh& mesh = component.mesh;
    std::vector<EdgeId> features;
    if (prescription.features.creaseDegrees)
      features = findCreases(mesh, *prescription.features.creaseDegrees);
    bool hasFeature = !features.empty();
    for (EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      const Pair ends = sorted(component.vertex[mesh.tail(h)].i, component.vertex[mesh.head(h)].i);
      const bool isListed = listed.take(ends), isMarked = marks.take(ends);
      if (isListed || isMarked) features.push_back(e);
      hasFeature = hasFeature || isListed || isMarked ||
                   (prescription.features.hasRims && mesh.isBoundary(h));
    }
    if (!hasFeature) continue;
    request.components[p].spec.features = std::move(features);
    addRims(mesh, request.components[p].spec);
  }
  if (isForAnotherFile(model, prescription)) addMovedNote(prescription.features, request.notes);
  addNoneNote(model, prescription.features, request);
  return checkFound(listed, marks, request.notes);
}

void addRims(const TriMesh& mesh, HolonomySpec& spec) {
  std::vector<EdgeId>& features = spec.features;
  for (EdgeId e : mesh.edges())
    if (mesh.isBoundary(mesh.halfedge(e))) features.push_back(e);
  std::sort(features.begin(), features.end());
  features.erase(std::unique(features.begin(), features.end()), features.end());
  const auto isInside = [&](const ConePoint& c) { return !mesh.isBoundary(c.vertex); };
  const auto corners = std::stable_partition(spec.cones.begin(), spec.cones.end(), isInside);
  spec.corners.insert(spec.corners.end(), corners, spec.cones.end());
  spec.cones.erase(corners, spec.cones.end());
}

bool isFeaturesOnly(const prescription::Prescription& prescription) {
  return !prescription.features.isEmpty() && !prescription.hasCones && !prescription.field &&
         prescription.boundaries.empty() && prescription.handles.empty() &&
         prescription.totalAngles.empty();
}

bool choosesCones(const SolveOptions& options) {
  return options.coneCount > 0 || options.conesFor != ConesFor::kBalanced ||
         options.alignToCurvature;
}

Status checkFeatures(const std::optional<prescription::Prescription>& prescription,
                     const SolveOptions& options) {
  const bool isRectangle = options.boundary == BoundaryKind::kRectangle;
  if (!isRectangle && (!prescription || prescription->features.isEmpty())) return Done{};
  const auto refuse = [](const char* text) {
    return Failure{ErrorCode::kUsage, "features", text, {}};
  };
  if (options.boundary == BoundaryKind::kConvex)
    return refuse("A convex boundary does not follow features; leave out either.");
  if (options.refines)
    return refuse(
        "Features are edges of this mesh and are not carried over to a refined one; leave out "
        "either.");
  return Done{};
}

prescription::PrescribedFeatures describeFeatures(const Model& model,
                                                  const std::vector<HolonomySpec>& specs) {
  prescription::PrescribedFeatures out;
  for (std::size_t p = 0; p < specs.size(); ++p) {
    const ModelComponent& component = model.components[p];
    const TriMesh& mesh = component.mesh;
    PerEdge<char> isOpen(at(mesh.edgeCount()), 0);
    for (EdgeId e : specs[p].features) isOpen[e] = 1;
    // The next open edge at v, also the one at which the fan of a boundary vertex ends.
    const auto nextAt = [&](VertexId v) {
      for (HalfedgeId h : outgoingHalfedges(mesh, v))
        for (const HalfedgeId side : {h, TriMesh::previous(h)})
          if (isOpen[mesh.edge(side)]) return mesh.edge(side);
      return EdgeId();
    };
    for (EdgeId first : specs[p].features) {
      if (!isOpen[first]) continue;
      prescription::PrescribedLine line;
      VertexId v = mesh.tail(mesh.halfedge(first));
      const auto add = [&] {
        line.vertices.push_back(component.vertex[v].i);
        line.positions.push_back(mesh.position(v));
      };
      add();
      for (EdgeId e = first; e.isValid(); e = nextAt(v)) {
        isOpen[e] = 0;
        const HalfedgeId h = mesh.halfedge(e);
        v = mesh.tail(h) == v ? mesh.head(h) : mesh.tail(h);
        add();
      }
      out.lines.push_back(std::move(line));
    }
  }
  return out;
}

}  // namespace hgp::api

#include "hgp/api/request/request.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/turns.h"
#include "hgp/mesh/finite.h"
#include "hgp/mesh/vectors.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/prescription/cones.h"

namespace hgp::api {
namespace {

// If the mesh has changed, a cone is searched within this fraction of the bounding box's diagonal.
constexpr double kSamePlace = 1e-6;

Failure refusal(const std::string& message, std::vector<Where> where = {}) {
  return {ErrorCode::kPrescription, "prescription", message, std::move(where)};
}

class Resolver {
 public:
  Resolver(const Model& model, const prescription::Prescription& asked)
      : model_(model), asked_(asked) {
    out_.q = asked.q;
    out_.notes = asked.notes;
    local_ = Per<MeshVertexId, Local>(model.mesh.positions.size());
    for (std::size_t p = 0; p < model.components.size(); ++p) {
      const ModelComponent& component = model.components[p];
      for (VertexId v : component.mesh.vertices())
        local_[component.meshVertex[v]] = {static_cast<int>(p), v};
      ComponentRequest request;
      request.spec.q = asked.q;
      request.spec.turning.resize(at(component.loop.size()));
      request.spec.handles.resize(static_cast<std::size_t>(2 * component.topology.genus));
      out_.components.push_back(std::move(request));
    }
  }

  Result<Request> resolve() {
    // Checked first, because the checks below divide by q.
    if (asked_.q < 1 || asked_.q > kLargestOrder) {
      return refusal(formatText("q = %d; it must be 1 to %d", asked_.q, kLargestOrder));
    }
    if (Status done = placeCones(); !done) return done.error();
    if (Status done = placeTurnings(); !done) return done.error();
    if (Status done = placeHandles(); !done) return done.error();
    if (asked_.field && !model_.hasOwnFaceIds) {
      return refusal("a field refers to triangles, which get new ids in the other format");
    }
    if (asked_.field) {
      if (Status done = readField(); !done) return done.error();
    } else {
      leaveEmptyComponentsOpen();
    }
    return std::move(out_);
  }

 private:
  struct Local {
    int component = -1;
    VertexId vertex;
  };

  Result<Local> locate(const prescription::PrescribedCone& cone) {
    const int count = model_.vertexImage.size();
    int v = cone.vertex;
    if (!model_.hasOwnVertexIds && !cone.position) {
      return refusal(
          "vertices get new ids when the file is converted to another format: cones need "
          "positions (those of 'hgp cones' have them), or the ids of the new file");
    }
    const bool isMoved =
        (!asked_.sha256.empty() && asked_.sha256 != model_.sha256) || !model_.hasOwnVertexIds;
    if (isMoved && cone.position) {
      const bool isThere = v >= 0 && v < count && distance(position(v), *cone.position) <= reach();
      if (!isThere) v = nearest(*cone.position);
      if (v < 0) {
        return refusal(formatText("no vertex within %.3g of the cone at (%.9g, %.9g, %.9g)",
                                  reach(), (*cone.position)[0], (*cone.position)[1],
                                  (*cone.position)[2]));
      }
    }
    if (v < 0 || v >= count) {
      return refusal(formatText("cone at vertex %d: the mesh has vertices 0 to %d", v, count - 1));
    }
    MeshVertexId image = model_.vertexImage[SurfaceVertexId{v}];
    // A cone also names a triangle, because another file of this surface, such as the one that hgp wrote, may
    // number vertices differently but usually has the same triangles.
    const MeshVertexId copy =
        cone.triangle < 0 || !image.isValid() ? image : copyIn(cone.triangle, image);
    if (!copy.isValid() && image.isValid() && !isMoved)
      return refusal(
          formatText("cone at vertex %d, which is not a corner of triangle %d", v, cone.triangle),
          {{Where::Kind::kFace, cone.triangle}});
    if (copy.isValid()) image = copy;
    const Local local = image.isValid() ? local_[image] : Local();
    if (local.component < 0) {
      return refusal(formatText("cone at vertex %d, which has no triangles", v),
                     {{Where::Kind::kVertex, v}});
    }
    return local;
  }

  /// The copy of a vertex that is a corner of this triangle of the surface, or none.
  MeshVertexId copyIn(int triangle, MeshVertexId image) const {
    // Binary search, since welds and repairs keep the order of triangles.
    const std::vector<int>& faces = model_.faceOrigin.raw();
    const auto found = std::lower_bound(faces.begin(), faces.end(), triangle);
    if (found == faces.end() || *found != triangle) return {};
    for (int v : model_.mesh.triangles[static_cast<std::size_t>(found - faces.begin())])
      if (model_.vertexOrigin[MeshVertexId{v}] == model_.vertexOrigin[image])
        return MeshVertexId{v};
    return {};
  }

  double reach() {
    if (reach_ < 0) reach_ = kSamePlace * diagonal(finiteBoxOf(model_.source().mesh.positions));
    return reach_;
  }
  const Vec3& position(int v) const { return model_.source().mesh.positions[at(v)]; }
  int nearest(const Vec3& p) {
    int best = -1;
    double bestDistance = reach();
    for (int v = 0; v < model_.vertexImage.size(); ++v) {
      const double d = distance(position(v), p);
      if (d > bestDistance || (d == bestDistance && best >= 0)) continue;
      best = v;
      bestDistance = d;
    }
    return best;
  }

  Status placeCones() {
    for (const prescription::PrescribedCone& cone : asked_.cones) {
      Result<Local> local = locate(cone);
      if (!local) return local.error();
      HolonomySpec& spec = out_.components[static_cast<std::size_t>(local->component)].spec;
      spec.cones.push_back({VertexId(local->vertex), cone.k});
    }
    return Done{};
  }

  /// Finds loops by number, or by a vertex on them if the file gives one.
  Status placeTurnings() {
    for (const prescription::PrescribedTurning& t : asked_.boundaries) {
      int loop = t.loop;
      const int anchored = loopAt(t.anchor);
      if (anchored >= 0) loop = anchored;
      bool isFound = false;
      for (std::size_t p = 0; p < model_.components.size(); ++p) {
        const std::vector<int>& loops = model_.components[p].loop.raw();
        for (std::size_t j = 0; j < loops.size(); ++j) {
          if (loops[j] != loop) continue;
          auto& turning = out_.components[p].spec.turning[j];
          if (turning && *turning != t.l) {
            return refusal(formatText("boundary loop %d is given two turning indices", loop),
                           {{Where::Kind::kLoop, loop}});
          }
          turning = t.l;
          isFound = true;
        }
      }
      if (!isFound) {
        return refusal(formatText("boundary loop %d: the mesh has %s", t.loop,
                                  counted(model_.topology.loops.size(), "loop").c_str()));
      }
    }
    return Done{};
  }

  int loopAt(int surfaceVertex) const {
    if (!model_.vertexImage.has(SurfaceVertexId{surfaceVertex})) return -1;
    const MeshVertexId v = model_.vertexImage[SurfaceVertexId{surfaceVertex}];
    if (!v.isValid()) return -1;
    const Local local = local_[v];
    if (local.component < 0) return -1;
    const ModelComponent& component = model_.components[static_cast<std::size_t>(local.component)];
    for (std::size_t j = 0; j < component.topology.loops.size(); ++j) {
      for (HalfedgeId h : component.topology.loops[j].halfedges) {
        if (component.mesh.tail(h) == local.vertex) return component.loop.raw()[j];
      }
    }
    return -1;
  }

  Status placeHandles() {
    int count = 0;
    for (const ModelComponent& component : model_.components) count += 2 * component.topology.genus;
    for (const prescription::PrescribedHandle& h : asked_.handles) {
      if (h.generator < 0 || h.generator >= count) {
        return refusal(formatText("handle generator %d: the mesh has %d (counted from 0)",
                                  h.generator, count));
      }
      for (std::size_t p = 0; p < model_.components.size(); ++p) {
        const int local = h.generator - model_.components[p].generatorOffset;
        auto& handles = out_.components[p].spec.handles;
        if (local < 0 || local >= static_cast<int>(handles.size())) continue;
        handles[static_cast<std::size_t>(local)] = reduceTurn(h.r, asked_.q);
      }
    }
    return Done{};
  }

  Status readField() {
    FieldData field = *asked_.field;
    const auto& triangles = model_.source().mesh.triangles;
    if (!field.directions.empty() && field.directions.size() != triangles.size()) {
      return refusal(formatText("the field has %s, the mesh %zu",
                                counted(field.directions.size(), "face").c_str(),
                                triangles.size()));
    }
    if (model_.isChanged) {
      return refusal(
          "a field cannot be used on a mesh that was repaired or welded; repair the mesh "
          "and its field together");
    }
    if (Status done = prescription::completeMatchings(field, triangles); !done) return done.error();
    std::vector<std::pair<int, FaceId>> faceOf(triangles.size());  // component and face
    for (std::size_t p = 0; p < model_.components.size(); ++p) {
      const ModelComponent& component = model_.components[p];
      for (FaceId f : component.mesh.faces())
        faceOf[at(component.face[f].i)] = {static_cast<int>(p), f};
    }
    for (std::size_t p = 0; p < model_.components.size(); ++p) {
      const ModelComponent& component = model_.components[p];
      FieldData part;
      part.order = field.order;
      part.hasMatchings = field.hasMatchings;
      if (!field.directions.empty()) {
        for (int f : component.face.raw()) part.directions.push_back(field.directions[at(f)]);
      }
      for (Matching m : field.matchings) {
        const auto [owner, face] = faceOf[at(m.from)];
        if (owner != static_cast<int>(p)) continue;
        m.from = face.i;
        m.to = faceOf[at(m.to)].second.i;
        m.tail = local_[MeshVertexId{m.tail}].vertex.i;
        m.head = local_[MeshVertexId{m.head}].vertex.i;
        part.matchings.push_back(m);
      }
      if (Status done = readComponentField(p, part); !done) return done.error();
      out_.components[p].field = std::move(part);
    }
    return Done{};
  }

  Status readComponentField(std::size_t p, const FieldData& part) {
    const ModelComponent& component = model_.components[p];
    HolonomySpec& spec = out_.components[p].spec;
    const std::vector<ConePoint> expected = asked_.hasCones ? spec.cones : std::vector<ConePoint>();
    Result<CompleteSpec> read = readHolonomy(component.mesh, part, expected);
    if (!read) return toSurfaceIds(model_, component, read.error());
    HolonomySpec found = toSpec(*read);
    if (asked_.hasCones) {
      // Even if the cones do not determine the field's sign convention, the field must have exactly these cones.
      PerVertex<int> k(static_cast<std::size_t>(component.mesh.vertexCount()), found.q);
      for (const ConePoint& c : found.cones) k[c.vertex] = c.k;
      for (const ConePoint& c : spec.cones) {
        if (k[c.vertex] != c.k) {
          return toSurfaceIds(
              model_, component,
              refusal(formatText("the field gives k = %d where the list of cones says %d",
                                 k[c.vertex], c.k),
                      {{Where::Kind::kVertex, c.vertex.i}}));
        }
        k[c.vertex] = found.q;
      }
      for (VertexId v : component.mesh.vertices()) {
        if (k[v] == found.q) continue;
        return toSurfaceIds(
            model_, component,
            refusal(formatText("the field has a cone of k = %d that is not in the list", k[v]),
                    {{Where::Kind::kVertex, v.i}}));
      }
    }
    for (std::size_t j = 0; j < spec.turning.size(); ++j) {
      if (spec.turning[j]) found.turning[j] = spec.turning[j];
    }
    for (std::size_t j = 0; j < spec.handles.size(); ++j) {
      if (spec.handles[j]) found.handles[j] = spec.handles[j];
    }
    spec = std::move(found);
    return Done{};
  }

  /// A component for which nothing is prescribed gets automatic cones if there are no cones at all, or if it is one of
  /// several and has no map without cones.
  void leaveEmptyComponentsOpen() {
    for (std::size_t p = 0; p < out_.components.size(); ++p) {
      ComponentRequest& component = out_.components[p];
      bool isEmpty = component.spec.cones.empty();
      for (const auto& l : component.spec.turning) isEmpty = isEmpty && !l;
      for (const auto& r : component.spec.handles) isEmpty = isEmpty && !r;
      if (!isEmpty) continue;
      if (!asked_.hasCones) {
        component.isAutomatic = true;
      } else if (out_.components.size() > 1 &&
                 !checkPrescription(model_.components[p].mesh, model_.components[p].topology,
                                    component.spec)) {
        component.isAutomatic = true;
        out_.notes.push_back(Note("cones-added", {{"component", p}}));
      }
    }
  }

  const Model& model_;
  const prescription::Prescription& asked_;
  Request out_;
  Per<MeshVertexId, Local> local_;
  double reach_ = -1;
};

}  // namespace

Result<Request> resolveCones(const Model& model, const prescription::Prescription& prescription) {
  if (prescription.totalAngles.empty()) return Resolver(model, prescription).resolve();
  if (prescription.totalAngles.size() != model.source().mesh.positions.size()) {
    return refusal(formatText("%s for a mesh of %zu vertices",
                              counted(prescription.totalAngles.size(), "total angle").c_str(),
                              model.source().mesh.positions.size()));
  }
  Result<TriMesh> mesh = buildTriMesh(model.mesh);
  if (!mesh) return mesh.error();
  Result<prescription::Prescription> reduced = prescription::reduceTotalAngles(
      prescription, *mesh, model.topology, model.vertexOrigin.raw());
  if (!reduced) return reduced.error();
  return Resolver(model, *reduced).resolve();
}

Request automaticRequest(const Model& model, int q) {
  Request request;
  request.q = q;
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    ComponentRequest component;
    component.spec.q = q;
    component.isAutomatic = true;
    request.components.push_back(std::move(component));
  }
  return request;
}

}  // namespace hgp::api

#include "hgp/api/request.h"

#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/turns.h"
#include "hgp/io/cones.h"
#include "hgp/parametrize.h"

namespace hgp::api {
namespace {

// A cone whose mesh has changed is looked for within this part of the diagonal.
constexpr double kSamePlace = 1e-6;

Failure refusal(const std::string& message, std::vector<Where> where = {}) {
  return {ErrorCode::kPrescription, "prescription", message, std::move(where)};
}

class Resolver {
 public:
  Resolver(const Model& model, const io::Prescription& asked) : model_(model), asked_(asked) {
    out_.q = asked.q;
    out_.notes = asked.notes;
    pieceOf_.assign(model.mesh.positions.size(), {-1, -1});
    for (std::size_t p = 0; p < model.pieces.size(); ++p) {
      const Piece& piece = model.pieces[p];
      for (std::size_t v = 0; v < piece.vertexOrigin.size(); ++v) {
        pieceOf_[static_cast<std::size_t>(piece.vertexOrigin[v])] = {static_cast<int>(p),
                                                                     static_cast<int>(v)};
      }
      PieceRequest request;
      request.spec.q = asked.q;
      request.spec.turning.resize(piece.loopOrigin.size());
      request.spec.handles.resize(static_cast<std::size_t>(2 * piece.topology.genus));
      out_.pieces.push_back(std::move(request));
    }
  }

  Result<Request> resolve() {
    // The checks below divide by q.
    if (asked_.q < 1 || asked_.q > kLargestOrder) {
      return refusal(formatText("q = %d; it must be 1 to %d", asked_.q, kLargestOrder));
    }
    if (Status done = placeCones(); !done) return done.error();
    if (Status done = placeTurnings(); !done) return done.error();
    if (Status done = placeHandles(); !done) return done.error();
    if (asked_.field) {
      if (Status done = readField(); !done) return done.error();
    } else {
      leaveEmptyPiecesOpen();
    }
    return std::move(out_);
  }

 private:
  struct Local {
    int piece = -1;
    int vertex = -1;
  };

  Result<Local> locate(const io::PrescribedCone& cone) {
    const int count = static_cast<int>(model_.vertexImage.size());
    int v = cone.vertex;
    const bool isMoved = !asked_.sha256.empty() && asked_.sha256 != model_.sha256;
    if (isMoved && cone.position) {
      const bool isThere = v >= 0 && v < count && distance(v, *cone.position) <= reach();
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
    const int image = model_.vertexImage[static_cast<std::size_t>(v)];
    const Local local = image < 0 ? Local() : pieceOf_[static_cast<std::size_t>(image)];
    if (local.piece < 0) {
      return refusal(formatText("cone at vertex %d, which has no triangles", v),
                     {{Where::Kind::kVertex, v}});
    }
    return local;
  }

  double reach() {
    if (reach_ < 0) reach_ = kSamePlace * diagonal(model_.source().mesh.positions);
    return reach_;
  }
  double distance(int v, const Vec3& p) const {
    const Vec3& q = model_.source().mesh.positions[static_cast<std::size_t>(v)];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  int nearest(const Vec3& p) {
    int best = -1;
    double bestDistance = reach();
    for (int v = 0; v < static_cast<int>(model_.vertexImage.size()); ++v) {
      const double d = distance(v, p);
      if (d > bestDistance || (d == bestDistance && best >= 0)) continue;
      best = v;
      bestDistance = d;
    }
    return best;
  }

  Status placeCones() {
    for (const io::PrescribedCone& cone : asked_.cones) {
      Result<Local> local = locate(cone);
      if (!local) return local.error();
      HolonomySpec& spec = out_.pieces[static_cast<std::size_t>(local->piece)].spec;
      spec.cones.push_back({VertexId(local->vertex), cone.k});
    }
    return Done{};
  }

  /// A loop by number, or by a vertex on it when the file gives one.
  Status placeTurnings() {
    for (const io::PrescribedTurning& t : asked_.boundaries) {
      int loop = t.loop;
      const int anchored = loopAt(t.anchor);
      if (anchored >= 0) loop = anchored;
      bool isFound = false;
      for (std::size_t p = 0; p < model_.pieces.size(); ++p) {
        const std::vector<int>& loops = model_.pieces[p].loopOrigin;
        for (std::size_t j = 0; j < loops.size(); ++j) {
          if (loops[j] != loop) continue;
          auto& turning = out_.pieces[p].spec.turning[j];
          if (turning && *turning != t.l) {
            return refusal(formatText("boundary loop %d is given two turning indices", loop),
                           {{Where::Kind::kLoop, loop}});
          }
          turning = t.l;
          isFound = true;
        }
      }
      if (!isFound) {
        return refusal(formatText("boundary loop %d: the mesh has %zu loops", t.loop,
                                  model_.topology.loops.size()));
      }
    }
    return Done{};
  }

  int loopAt(int surfaceVertex) const {
    if (surfaceVertex < 0 || surfaceVertex >= static_cast<int>(model_.vertexImage.size()))
      return -1;
    const int v = model_.vertexImage[static_cast<std::size_t>(surfaceVertex)];
    if (v < 0) return -1;
    const Local local = pieceOf_[static_cast<std::size_t>(v)];
    if (local.piece < 0) return -1;
    const Piece& piece = model_.pieces[static_cast<std::size_t>(local.piece)];
    for (std::size_t j = 0; j < piece.topology.loops.size(); ++j) {
      for (HalfedgeId h : piece.topology.loops[j].halfedges) {
        if (piece.mesh.tail(h).i == local.vertex) return piece.loopOrigin[j];
      }
    }
    return -1;
  }

  Status placeHandles() {
    int count = 0;
    for (const Piece& piece : model_.pieces) count += 2 * piece.topology.genus;
    for (const io::PrescribedHandle& h : asked_.handles) {
      if (h.generator < 0 || h.generator >= count) {
        return refusal(formatText("handle generator %d: the mesh has %d (counted from 0)",
                                  h.generator, count));
      }
      for (std::size_t p = 0; p < model_.pieces.size(); ++p) {
        const int local = h.generator - model_.pieces[p].generatorOffset;
        auto& handles = out_.pieces[p].spec.handles;
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
      return refusal(formatText("the field has %zu faces, the mesh %zu", field.directions.size(),
                                triangles.size()));
    }
    if (model_.isChanged) {
      return refusal(
          "a field cannot be used on a mesh that was repaired or welded; repair the mesh "
          "and its field together");
    }
    if (Status done = io::completeMatchings(field, triangles); !done) return done.error();
    std::vector<Local> faceOf(triangles.size());
    for (std::size_t p = 0; p < model_.pieces.size(); ++p) {
      const auto& faces = model_.pieces[p].faceOrigin;
      for (std::size_t f = 0; f < faces.size(); ++f) {
        faceOf[static_cast<std::size_t>(faces[f])] = {static_cast<int>(p), static_cast<int>(f)};
      }
    }
    for (std::size_t p = 0; p < model_.pieces.size(); ++p) {
      const Piece& piece = model_.pieces[p];
      FieldData part;
      part.order = field.order;
      part.hasMatchings = field.hasMatchings;
      if (!field.directions.empty()) {
        for (int f : piece.faceOrigin) {
          part.directions.push_back(field.directions[static_cast<std::size_t>(f)]);
        }
      }
      for (Matching m : field.matchings) {
        const Local face = faceOf[static_cast<std::size_t>(m.from)];
        if (face.piece != static_cast<int>(p)) continue;
        m.from = face.vertex;
        m.to = faceOf[static_cast<std::size_t>(m.to)].vertex;
        m.tail = pieceOf_[static_cast<std::size_t>(m.tail)].vertex;
        m.head = pieceOf_[static_cast<std::size_t>(m.head)].vertex;
        part.matchings.push_back(m);
      }
      if (Status done = readPieceField(p, part); !done) return done.error();
      out_.pieces[p].field = std::move(part);
    }
    return Done{};
  }

  Status readPieceField(std::size_t p, const FieldData& part) {
    const Piece& piece = model_.pieces[p];
    HolonomySpec& spec = out_.pieces[p].spec;
    const std::vector<ConePoint> expected = asked_.hasCones ? spec.cones : std::vector<ConePoint>();
    Result<CompleteSpec> read = readHolonomy(piece.mesh, part, expected);
    if (!read) return toSurfaceIds(model_, piece, read.error());
    HolonomySpec found = toSpec(*read);
    if (asked_.hasCones) {
      // A sign convention the cones cannot tell apart must still end in these very cones.
      PerVertex<int> k(static_cast<std::size_t>(piece.mesh.vertexCount()), found.q);
      for (const ConePoint& c : found.cones) k[c.vertex] = c.k;
      for (const ConePoint& c : spec.cones) {
        if (k[c.vertex] != c.k) {
          return toSurfaceIds(
              model_, piece,
              refusal(formatText("the field gives k = %d where the list of cones says %d",
                                 k[c.vertex], c.k),
                      {{Where::Kind::kVertex, c.vertex.i}}));
        }
        k[c.vertex] = found.q;
      }
      for (VertexId v : piece.mesh.vertices()) {
        if (k[v] == found.q) continue;
        return toSurfaceIds(
            model_, piece,
            refusal(formatText("the field has a cone of k = %d that the list of cones lacks", k[v]),
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

  /// Of several pieces one without any wish gets automatic cones, unless none at all will do.
  void leaveEmptyPiecesOpen() {
    for (std::size_t p = 0; p < out_.pieces.size(); ++p) {
      PieceRequest& piece = out_.pieces[p];
      bool isEmpty = piece.spec.cones.empty();
      for (const auto& l : piece.spec.turning) isEmpty = isEmpty && !l;
      for (const auto& r : piece.spec.handles) isEmpty = isEmpty && !r;
      if (!isEmpty) continue;
      if (!asked_.hasCones) {
        piece.isAutomatic = true;
      } else if (out_.pieces.size() > 1 &&
                 !checkPrescription(model_.pieces[p].mesh, model_.pieces[p].topology, piece.spec)) {
        piece.isAutomatic = true;
        out_.notes.push_back(
            formatText("component %zu has no cones in the list; they are chosen "
                       "automatically",
                       p));
      }
    }
  }

  const Model& model_;
  const io::Prescription& asked_;
  Request out_;
  std::vector<Local> pieceOf_;
  double reach_ = -1;
};

}  // namespace

Result<Request> resolve(const Model& model, const io::Prescription& prescription) {
  if (prescription.totalAngles.empty()) return Resolver(model, prescription).resolve();
  if (prescription.totalAngles.size() != model.source().mesh.positions.size()) {
    return refusal(formatText("%zu total angles for a mesh of %zu vertices",
                              prescription.totalAngles.size(),
                              model.source().mesh.positions.size()));
  }
  Result<TriMesh> mesh = buildTriMesh(model.mesh);
  if (!mesh) return mesh.error();
  Result<io::Prescription> reduced =
      io::reduceTotalAngles(prescription, *mesh, model.topology, model.vertexOrigin);
  if (!reduced) return reduced.error();
  return Resolver(model, *reduced).resolve();
}

Request automaticRequest(const Model& model, int q) {
  Request request;
  request.q = q;
  for (std::size_t p = 0; p < model.pieces.size(); ++p) {
    PieceRequest piece;
    piece.spec.q = q;
    piece.isAutomatic = true;
    request.pieces.push_back(std::move(piece));
  }
  return request;
}

}  // namespace hgp::api

#include "hgp/api/request/feature_list.h"

#include <algorithm>

#include "hgp/api/request/feature_request.h"
#include "hgp/base/check.h"
#include "hgp/features/creases.h"
#include "hgp/mesh/vectors.h"
#include "hgp/prescription/cones.h"
#include "hgp/text/text.h"

namespace hgp::api {
namespace {

bool endsIn(const std::string& name, std::string_view end) {
  return name.size() >= end.size() &&
         std::string_view(name).substr(name.size() - end.size()) == end;
}

/// Whether the surface bends away from its outer side at this inner edge.
bool isConvexAt(const TriMesh& mesh, HalfedgeId h) {
  const auto [a, b, c] = mesh.corners(TriMesh::face(h));
  const Vec3 n = cross(subtract(mesh.position(b), mesh.position(a)),
                       subtract(mesh.position(c), mesh.position(a)));
  const VertexId far = mesh.tail(TriMesh::previous(mesh.twin(h)));
  return dot(n, subtract(mesh.position(far), mesh.position(a))) <= 0.0;
}

std::string sharpText(const Model& model, const Request& request) {
  std::string rows;
  std::int64_t count = 0;
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    const ModelComponent& component = model.components[p];
    const TriMesh& mesh = component.mesh;
    for (EdgeId e : request.components[p].spec.features) {
      const HalfedgeId h = mesh.halfedge(e);
      const int from = component.corner[h].i, to = component.corner[TriMesh::next(h)].i;
      const int corner =
          (from % 3 + 1) % 3 == to % 3 ? from : to;  // repairs may have turned it over
      text::appendInt(rows, mesh.isBoundary(h) || isConvexAt(mesh, h));
      rows += ',';
      text::appendInt(rows, corner / 3);
      rows += ',';
      text::appendInt(rows, corner % 3);
      rows += '\n';
      ++count;
    }
  }
  std::string out;
  text::appendInt(out, count);
  return out + "\n" + rows;
}

void appendLine(std::string& out, const std::vector<int>& vertices, int first) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i > 0) out += ' ';
    text::appendInt(out, vertices[i] + first);
  }
  out += '\n';
}

std::string objText(const Model& model, const prescription::PrescribedFeatures& features) {
  std::string out;
  for (const Vec3& p : model.source().mesh.positions) {
    out += 'v';
    for (const double x : p) {
      out += ' ';
      text::appendDouble(out, x);
    }
    out += '\n';
  }
  for (const prescription::PrescribedLine& line : features.lines) {
    out += "l ";
    appendLine(out, line.vertices, 1);
  }
  return out;
}

std::string jsonText(const Model& model, prescription::PrescribedFeatures features) {
  prescription::Prescription list;
  list.sha256 = model.sha256;
  list.vertexCount = static_cast<int>(model.source().mesh.positions.size());
  list.triangleCount = static_cast<int>(model.source().mesh.triangles.size());
  list.features = std::move(features);
  return prescription::writeConesJson(list);
}

}  // namespace

FeatureList listFeatures(const Model& model, const Request& request, const std::string& name) {
  FeatureList out;
  out.notes = request.notes;
  std::vector<HolonomySpec> specs;
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    const TriMesh& mesh = model.components[p].mesh;
    specs.push_back(request.components[p].spec);
    const std::vector<EdgeId>& edges = specs.back().features;
    const auto rims = std::count_if(edges.begin(), edges.end(),
                                    [&](EdgeId e) { return mesh.isBoundary(mesh.halfedge(e)); });
    out.rimEdges += static_cast<int>(rims);
    out.creaseEdges += static_cast<int>(edges.size()) - static_cast<int>(rims);
    out.chains += countRuns(mesh, edges);
  }
  if (endsIn(name, ".sharp")) {
    out.text = sharpText(model, request);
    return out;
  }
  prescription::PrescribedFeatures features = describeFeatures(model, specs);
  if (endsIn(name, ".json")) {
    out.text = jsonText(model, std::move(features));
  } else if (endsIn(name, ".obj")) {
    out.text = objText(model, features);
  } else {
    for (const prescription::PrescribedLine& line : features.lines)
      for (std::size_t i = 1; i < line.vertices.size(); ++i)
        appendLine(out.text, {line.vertices[i - 1], line.vertices[i]}, 0);
  }
  return out;
}

}  // namespace hgp::api

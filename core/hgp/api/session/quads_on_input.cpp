#include "hgp/api/session/quads_on_input.h"

#include <algorithm>

#include "hgp/quads/corner_places.h"

namespace hgp::api {
namespace {

bool isGltf(const io::Document& document) {
  return std::string_view(document.outputFormat()) != "obj";
}

/// The set that the input's textures most likely use: its first, or the one that hgp wrote if there is no other.
std::optional<UvMap> uvOf(const io::Document& document, int surface) {
  const io::Surface& source = document.surfaces()[at(surface)];
  if (source.uvSets.empty()) return document.incompleteUv(surface);
  const auto other = std::find_if(source.uvSets.begin(), source.uvSets.end(),
                                  [&](int set) { return set != source.ownUvSet; });
  return document.existingUv(surface,
                             other == source.uvSets.end() ? source.uvSets.front() : *other);
}

/// The material of most corners; of several, the one that comes first.
int commonTriangle(const std::vector<int>& materials, const std::array<int, 4>& triangles) {
  if (materials.empty()) return triangles[0];
  std::array<int, 4> count{};
  for (std::size_t k = 0; k < 4; ++k)
    for (const int t : triangles) count[k] += materials[at(t)] == materials[at(triangles[k])];
  return triangles[at(std::max_element(count.begin(), count.end()) - count.begin())];
}

}  // namespace

QuadsOnInput::QuadsOnInput(const Model& model)
    : document_(*model.document),
      surface_(model.surface),
      uv_(uvOf(*model.document, model.surface)) {
  Result<io::PlainFile> plain = document_.plain(model.surface);
  if (!plain || plain->surfaces.empty()) return;
  plain_ = std::move(plain->surfaces[0]);
  lost_ = std::move(plain->lost);
}

io::FacePoint QuadsOnInput::onInput(const ModelComponent& component, FaceId f,
                                    const std::array<double, 3>& weight) const {
  io::FacePoint out;
  for (int k = 0; k < 3; ++k) {
    const SurfaceCornerId corner = component.corner[TriMesh::halfedge(f, k)];
    out.triangle = corner.i / 3;
    out.weight[at(corner.i % 3)] = weight[at(k)];
  }
  return out;
}

PerEdge<char> QuadsOnInput::seamsOf(const ModelComponent& component) const {
  const TriMesh& mesh = component.mesh;
  PerEdge<char> out(at(mesh.edgeCount()), 0);
  const auto uvAt = [&](HalfedgeId h) -> std::optional<Vec2> {
    const int corner = component.corner[h].i;
    const int i = uv_->cornerUv[at(corner / 3)][at(corner % 3)];
    return i < 0 ? std::nullopt : std::optional(uv_->uv[at(i)]);
  };
  const auto materialAt = [&](HalfedgeId h) {
    return plain_.triangleMaterial[at(component.corner[h].i / 3)];
  };
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (!twin.isValid()) continue;
    const bool isCut =
        uv_ && (uvAt(h) != uvAt(TriMesh::next(twin)) || uvAt(TriMesh::next(h)) != uvAt(twin));
    const bool isBorder = !plain_.triangleMaterial.empty() && materialAt(h) != materialAt(twin);
    out[e] = isCut || isBorder ? 1 : 0;
  }
  return out;
}

void QuadsOnInput::add(const ModelComponent& component, const QuadMesh& quads) {
  const QuadPlaces places = cornerPlaces(component.mesh, quads);
  const PerEdge<char> seams = seamsOf(component);
  if (std::find(seams.begin(), seams.end(), 1) != seams.end())
    for (const char isAcross : crossesSeams(component.mesh, quads, places, seams))
      acrossSeams_ += isAcross;
  io::PolygonMesh& out = remesh_.polygons;
  const int first = static_cast<int>(out.positions.size());
  out.positions.insert(out.positions.end(), quads.positions.begin(), quads.positions.end());
  remesh_.normals.insert(remesh_.normals.end(), quads.normals.begin(), quads.normals.end());
  for (std::size_t n = 0; n < quads.quads.size(); ++n) {
    std::array<int, 4> triangles{};
    for (std::size_t k = 0; k < 4; ++k) {
      out.cornerVertex.push_back(first + quads.quads[n][k]);
      remesh_.at.push_back(onInput(component, places[n][k].face, places[n][k].weight));
      triangles[k] = remesh_.at.back().triangle;
    }
    out.start.push_back(static_cast<std::uint32_t>(out.cornerVertex.size()));
    remesh_.triangle.push_back(commonTriangle(plain_.triangleMaterial, triangles));
  }
}

QuadsOnInput::File QuadsOnInput::file(std::string_view format, const std::string& generator,
                                      const io::Resolver& resolve) const {
  File out;
  if (acrossSeams_ > 0) out.notes.push_back(Note("quads-across-seams", {{"quads", acrossSeams_}}));
  if (format == "glb" && isGltf(document_)) {
    Result<io::Written> whole = document_.remeshed(surface_, remesh_, resolve);
    if (whole) {
      out.bytes = std::move(whole->files.front().bytes);
      addNotes(out.notes, std::move(whole->notes));
      return out;
    }
    out.notes.push_back(Note("quads-mesh-alone", {{"why", whole.error().message}}));
  }
  const io::PolygonAttributes attributes =
      io::attributesAt(plain_, uv_ ? &*uv_ : nullptr, isGltf(document_), remesh_);
  const io::PolygonMesh& polygons = remesh_.polygons;
  out.bytes = format == "glb"   ? io::polygonsAsGlb(polygons, attributes, generator)
              : format == "ply" ? io::polygonsAsPly(polygons, attributes, generator)
                                : io::polygonsAsObj(polygons, attributes, generator);
  const auto without = std::count(attributes.cornerUv.begin(), attributes.cornerUv.end(), -1);
  if (without > 0)
    out.notes.push_back(
        Note("quads-uv-missing", {{"corners", without}, {"zero", format == "obj" ? 0 : 1}}));
  addNotes(out.notes, notKept(format));
  return out;
}

Notes QuadsOnInput::notKept(std::string_view format) const {
  Notes out;
  const auto has = [](const Note& note, std::initializer_list<const char*> codes) {
    return std::any_of(codes.begin(), codes.end(),
                       [&](const char* code) { return note.code == code; });
  };
  for (const Note& lost : lost_) {
    const bool isOfMaterials = has(lost, {"convert-materials-lost"});
    if (isOfMaterials && format == "ply") {
      out.push_back(Note("quads-no-materials"));
    } else if (isOfMaterials ? isGltf(document_) || format == "glb"
                             : !has(lost, {"convert-uv-lost", "convert-polygons-cut",
                                           "convert-unused-placed"})) {
      out.push_back(lost);
      out.back().values.push_back({"from", document_.format()});
      out.back().values.push_back({"to", std::string(format)});
    }
  }
  return out;
}

}  // namespace hgp::api

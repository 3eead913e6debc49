#include "hgp/api/model/convert_document.h"

#include "hgp/base/check.h"
#include "hgp/io/convert.h"
#include "hgp/io/polygon/polygon_document.h"

namespace hgp::api {

Result<ConvertedDocument> convertDocument(const io::Document& before, const io::FileSet& files,
                                          const LoadOptions& options) {
  ConvertedDocument out;
  Result<io::FileSet> converted =
      io::convertFiles(before, files, options.target, options.surface, options.limits);
  if (!converted) return converted.error();
  out.notes = converted->notes;
  Result<io::DocumentPtr> after = io::openDocument(std::move(*converted), options.limits);
  if (!after) return after.error();
  out.document = std::move(*after);
  const bool isPacked = std::string_view(before.format()) == "gltf" && options.target == "glb";
  if (isPacked) return out;  // only the container has changed; the meshes are the same
  const std::vector<io::Surface>&from = before.surfaces(), &to = out.document->surfaces();
  const bool isOne = from.size() == 1 && to.size() == 1;
  out.hasOwnVertexIds = isOne && from[0].mesh.positions.size() == to[0].mesh.positions.size();
  out.hasOwnFaceIds = out.hasOwnVertexIds && from[0].mesh.triangles == to[0].mesh.triangles;
  return out;
}

Result<io::DocumentPtr> documentOfArrays(MeshData arrays) {
  const int vertices = static_cast<int>(arrays.positions.size());
  if (arrays.triangles.empty()) {
    return Failure{ErrorCode::kMalformed, "read", "there are no triangles", {}};
  }
  io::PolygonFile file;
  for (const auto& t : arrays.triangles) {
    for (int v : t) {
      if (v < 0 || v >= vertices) {
        return Failure{ErrorCode::kMalformed,
                       "read",
                       formatText("a triangle names vertex %d; there are %d", v, vertices),
                       {}};
      }
      file.polygons.cornerVertex.push_back(v);
    }
    file.polygons.start.push_back(static_cast<std::uint32_t>(file.polygons.cornerVertex.size()));
  }
  file.polygons.positions = std::move(arrays.positions);
  return io::PolygonDocument::make("arrays", std::move(file));
}

}  // namespace hgp::api

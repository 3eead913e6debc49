// The quads of all components as new polygons on the input's triangles.  Role: lets documents write quads with the attributes of
// the input.
#pragma once

#include <optional>

#include "hgp/api/model/model.h"
#include "hgp/io/document.h"
#include "hgp/io/remesh.h"
#include "hgp/quads/quad_mesh.h"

namespace hgp::api {

class QuadsOnInput {
 public:
  explicit QuadsOnInput(const Model& model);
  /// Appends the quads of a component.
  void add(const ModelComponent& component, const QuadMesh& quads);

  const io::Remesh& remesh() const { return remesh_; }
  /// Quads of which a side crosses a seam of the input's uv or the border between two of its materials.
  int acrossSeams() const { return acrossSeams_; }

  /// A file with what the input has, as OBJ, PLY or GLB ("obj", "ply", "glb"), and notes on what of it is not kept. A glTF as GLB keeps
  /// everything else of the file, in place of the mesh that was solved.
  /// @param resolve  gives images of a .gltf; may be empty
  struct File {
    io::Bytes bytes;
    Notes notes;
  };
  File file(std::string_view format, const std::string& generator,
            const io::Resolver& resolve) const;

 private:
  PerEdge<char> seamsOf(const ModelComponent& component) const;
  Notes notKept(std::string_view format) const;
  io::FacePoint onInput(const ModelComponent& component, FaceId f,
                        const std::array<double, 3>& weight) const;

  const io::Document& document_;
  int surface_;
  io::PlainSurface plain_;
  Notes lost_;
  std::optional<UvMap> uv_;  ///< of the input
  io::Remesh remesh_;
  int acrossSeams_ = 0;
};

}  // namespace hgp::api

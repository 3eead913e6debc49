// Reverses faces and copies vertices, polygon by polygon.
#include <algorithm>

#include "hgp/io/polygon/polygon_refine.h"

namespace hgp::io {
namespace {

class FaceEditor {
 public:
  FaceEditor(const PolygonMesh& polygons, const TriangleCorners& corners, const FaceEdits& edits)
      : polygons_(polygons), corners_(corners), edits_(edits) {
    out_.polygons.positions = polygons.positions;
    for (const int v : edits.copyOf) {
      out_.polygons.positions.push_back(polygons.positions[static_cast<std::size_t>(v)]);
      out_.parents.push_back({v, v});
    }
  }

  RefinedPolygons edit() {
    for (int p = 0; p < polygons_.polygonCount(); ++p) {
      const std::size_t first = next_;
      while (next_ < edits_.faces.size() &&
             edits_.faces[next_].face < polygons_.firstTriangle(p + 1))
        ++next_;
      if (first == next_) {
        addWhole(p, false, {}, 1);
      } else if (!addTogether(p, first)) {
        addTriangles(p, first);
      }
    }
    return std::move(out_);
  }

 private:
  int cornerOf(int triangle, int k) const {
    return corners_.empty()
               ? 3 * triangle + k
               : corners_[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(k)];
  }
  bool isOutside(int triangle) const {
    return std::binary_search(edits_.outside.begin(), edits_.outside.end(), triangle);
  }
  /// Whether the edit reverses the face.
  static bool isTurned(const EditedFace& e) { return (e.corner[1] - e.corner[0] + 3) % 3 == 2; }

  void addCorner(int corner, int vertex) {
    out_.polygons.cornerVertex.push_back(vertex);
    out_.corners.push_back({corner, corner});
  }
  void endPolygon(int p, char isSame) {
    out_.polygons.start.push_back(static_cast<std::uint32_t>(out_.polygons.cornerVertex.size()));
    out_.polygonOrigin.push_back(p);
    out_.isSame.push_back(isSame);
  }

  /// @param vertices  by corner of the polygon; empty: unchanged
  void addWhole(int p, bool turned, const std::vector<int>& vertices, char isSame) {
    const auto begin = static_cast<int>(polygons_.start[static_cast<std::size_t>(p)]);
    const auto end = static_cast<int>(polygons_.start[static_cast<std::size_t>(p) + 1]);
    for (int i = 0; i < end - begin; ++i) {
      // The first corner stays the first.
      const int local = turned && i > 0 ? end - begin - i : i;
      addCorner(begin + local, vertices.empty()
                                   ? polygons_.cornerVertex[static_cast<std::size_t>(begin + local)]
                                   : vertices[static_cast<std::size_t>(local)]);
    }
    endPolygon(p, isSame);
  }

  /// Adds an edited polygon as a whole; false if its triangles are not all edited alike.
  bool addTogether(int p, std::size_t first) {
    const auto begin = static_cast<int>(polygons_.start[static_cast<std::size_t>(p)]);
    const auto end = static_cast<int>(polygons_.start[static_cast<std::size_t>(p) + 1]);
    std::vector<int> vertices(static_cast<std::size_t>(end - begin), -1);
    const auto agree = [&](int corner, int vertex) {
      int& known = vertices[static_cast<std::size_t>(corner - begin)];
      if (known < 0) known = vertex;
      return known == vertex;
    };
    const bool turned = isTurned(edits_.faces[first]);
    std::size_t e = first;
    for (int t = polygons_.firstTriangle(p); t < polygons_.firstTriangle(p + 1); ++t) {
      if (isOutside(t)) continue;
      const bool isEdited = e < next_ && edits_.faces[e].face == t;
      if (isEdited ? isTurned(edits_.faces[e]) != turned : turned) return false;
      for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const int corner = cornerOf(t, isEdited ? edits_.faces[e].corner[at] : k);
        const int own = polygons_.cornerVertex[static_cast<std::size_t>(corner)];
        if (!agree(corner, isEdited ? edits_.faces[e].vertex[at] : own)) return false;
      }
      e += isEdited;
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (vertices[i] < 0)
        vertices[i] = polygons_.cornerVertex[static_cast<std::size_t>(begin) + i];
    addWhole(p, turned, vertices, 0);
    return true;
  }

  void addTriangles(int p, std::size_t e) {
    for (int t = polygons_.firstTriangle(p); t < polygons_.firstTriangle(p + 1); ++t) {
      const bool isEdited = e < next_ && edits_.faces[e].face == t;
      for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const int corner = cornerOf(t, isEdited ? edits_.faces[e].corner[at] : k);
        addCorner(corner, isEdited ? edits_.faces[e].vertex[at]
                                   : polygons_.cornerVertex[static_cast<std::size_t>(corner)]);
      }
      endPolygon(p, 0);
      e += isEdited;
    }
  }

  const PolygonMesh& polygons_;
  const TriangleCorners& corners_;
  const FaceEdits& edits_;
  std::size_t next_ = 0;  ///< index of the first edited face not yet processed
  RefinedPolygons out_;
};

}  // namespace

RefinedPolygons editFaces(const PolygonMesh& polygons, const TriangleCorners& corners,
                          const FaceEdits& edits) {
  return FaceEditor(polygons, corners, edits).edit();
}

}  // namespace hgp::io

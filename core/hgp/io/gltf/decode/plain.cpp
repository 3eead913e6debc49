#include "hgp/io/gltf/decode/plain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "hgp/base/check.h"
#include "hgp/io/gltf/decode/accessor.h"
#include "hgp/io/gltf/decode/affine.h"
#include "hgp/mesh/vectors.h"

namespace hgp::io {
namespace {

/// Normals are transformed by the cofactor matrix, which is the inverse transpose times the determinant.
Affine cofactors(const Affine& m) {
  return {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]), {}};
}

class GltfFlattener {
 public:
  GltfFlattener(const GltfStore& store, const std::vector<GltfSurface>& parts,
                const std::vector<Surface>& surfaces)
      : store_(store), json_(store.json), parts_(parts), surfaces_(surfaces) {}

  PlainFile run(int surface) {
    for (const int material : json_.children(json_.find(JsonText::kRoot, "materials")))
      materials_.push_back(json_.string(json_.find(material, "name")));
    if (surface >= 0) {
      add(static_cast<std::size_t>(surface), kIdentityPlace, "");
    } else {
      walkScene();
      for (std::size_t p = 0; p < parts_.size(); ++p)
        if (!shown_.contains(static_cast<int>(p))) add(p, kIdentityPlace, "");
    }
    tellLoss();
    return std::move(out_);
  }

 private:
  /// The nodes form a forest (checked when the file was read). Without a scene, every root is visible.
  void walkScene() {
    const std::vector<int> nodes = json_.children(json_.find(JsonText::kRoot, "nodes"));
    const std::vector<int> scenes = json_.children(json_.find(JsonText::kRoot, "scenes"));
    const auto scene =
        static_cast<std::size_t>(json_.integer(json_.find(JsonText::kRoot, "scene")).value_or(0));
    std::vector<std::pair<int, Affine>> open;
    const auto push = [&](int list, const Affine& parent) {
      const std::vector<int> children = json_.children(list);
      for (std::size_t i = children.size(); i-- > 0;) {
        const auto node = json_.integer(children[i]);
        if (node && *node >= 0 && static_cast<std::size_t>(*node) < nodes.size())
          open.emplace_back(nodes[static_cast<std::size_t>(*node)], parent);
      }
    };
    if (scene < scenes.size()) push(json_.find(scenes[scene], "nodes"), kIdentityPlace);
    while (!open.empty()) {
      const auto [node, parent] = open.back();
      open.pop_back();
      const Affine here = product(parent, localPlace(json_, node));
      if (const auto mesh = json_.integer(json_.find(node, "mesh"))) show(*mesh, here, node);
      push(json_.find(node, "children"), here);
    }
  }

  void show(std::int64_t mesh, const Affine& place, int node) {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (parts_[p].mesh != mesh) continue;
      shown_.insert(static_cast<int>(p));
      add(p, place, json_.string(json_.find(node, "name")));
    }
  }

  void add(std::size_t p, const Affine& place, const std::string& name) {
    const GltfSurface& part = parts_[p];
    PlainSurface out;
    out.name = name.empty() ? surfaces_[p].name : name;
    out.mesh = surfaces_[p].mesh;
    addColors(part, out);
    addNormals(part, out);
    addMaterials(part, out);
    const bool isMirrored = determinant(place) < 0;
    for (Vec3& x : out.mesh.positions) x = placed(place, x);
    const Affine normalPlace = cofactors(place);
    for (Vec3& n : out.normals) {
      n = applied(normalPlace, n);
      const double length = norm(n) * (isMirrored ? -1 : 1);
      for (double& c : n) c = length != 0 ? c / length : 0;
    }
    if (isMirrored) {
      for (auto& t : out.mesh.triangles) std::swap(t[1], t[2]);
      for (auto& t : out.cornerNormal) std::swap(t[1], t[2]);
    }
    out_.surfaces.push_back(std::move(out));
  }

  /// The values of an attribute by stored vertex, `width` per vertex; empty if a primitive does not have it.
  std::vector<double> storedNumbers(const GltfSurface& part, const char* semantic,
                                    std::size_t width) const {
    std::vector<double> out;
    for (const GltfPool& pool : part.pools) {
      const int p = pool.primitives.front();
      const GltfPrimitive& primitive = store_.model.meshes[static_cast<std::size_t>(part.mesh)]
                                           .primitives[static_cast<std::size_t>(p)];
      const int accessor = primitive.attribute(semantic);
      if (accessor < 0) return {};
      const GltfAccessor& shape = store_.model.accessors[static_cast<std::size_t>(accessor)];
      const auto have = static_cast<std::size_t>(shape.components());
      const std::vector<double> numbers =
          realNumbers(shape, packedAttribute(store_, part.mesh, p, semantic));
      out.resize(width * static_cast<std::size_t>(pool.firstStored + pool.vertexCount), 1.0);
      for (std::size_t v = 0; v < static_cast<std::size_t>(pool.vertexCount); ++v) {
        for (std::size_t k = 0; k < std::min(width, have); ++k) {
          if (have * v + k < numbers.size())
            out[width * (static_cast<std::size_t>(pool.firstStored) + v) + k] =
                numbers[have * v + k];
        }
      }
    }
    return out;
  }

  void addColors(const GltfSurface& part, PlainSurface& out) const {
    const std::vector<double> numbers = storedNumbers(part, "COLOR_0", 4);
    if (numbers.empty()) return;
    out.colors.assign(out.mesh.positions.size(), {1, 1, 1, 1});
    for (std::size_t s = part.welded.size(); s-- > 0;) {
      if (4 * s + 3 >= numbers.size()) continue;
      for (std::size_t k = 0; k < 4; ++k)
        out.colors[static_cast<std::size_t>(part.welded[s])][k] = numbers[4 * s + k];
    }
  }

  void addNormals(const GltfSurface& part, PlainSurface& out) const {
    const std::vector<double> numbers = storedNumbers(part, "NORMAL", 3);
    if (numbers.empty()) return;
    std::map<Vec3, int> ids;
    std::vector<int> idOf(numbers.size() / 3);
    for (std::size_t s = 0; s < idOf.size(); ++s) {
      const Vec3 n = {numbers[3 * s], numbers[3 * s + 1], numbers[3 * s + 2]};
      const auto [found, isNew] = ids.try_emplace(n, static_cast<int>(out.normals.size()));
      if (isNew) out.normals.push_back(n);
      idOf[s] = found->second;
    }
    out.cornerNormal.assign(part.stored.size(), {});
    for (std::size_t t = 0; t < part.stored.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k)
        out.cornerNormal[t][k] = idOf[static_cast<std::size_t>(part.stored[t][k])];
    }
  }

  void addMaterials(const GltfSurface& part, PlainSurface& out) const {
    if (materials_.empty()) return;
    for (std::size_t m = 0; m < materials_.size(); ++m)
      out.materials.push_back(materials_[m].empty() ? formatText("material_%zu", m)
                                                    : materials_[m]);
    out.triangleMaterial.assign(part.stored.size(), -1);
    for (const GltfRun& run : part.runs) {
      const int material = store_.model.meshes[static_cast<std::size_t>(part.mesh)]
                               .primitives[static_cast<std::size_t>(run.primitive)]
                               .material;
      for (int t = run.firstTriangle; t < run.firstTriangle + run.triangleCount; ++t)
        out.triangleMaterial[static_cast<std::size_t>(t)] = material;
    }
  }

  void tellLoss() {
    const auto has = [&](const char* name) {
      return !json_.children(json_.find(JsonText::kRoot, name)).empty();
    };
    if (has("materials")) out_.lost.push_back(Note("convert-materials-lost"));
    if (has("skins") || has("animations")) out_.lost.push_back(Note("convert-rest-pose"));
    const auto& meshes = store_.model.meshes;
    const bool hasMorphs = std::any_of(meshes.begin(), meshes.end(), [](const GltfMesh& mesh) {
      return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                         [](const GltfPrimitive& p) { return !p.targets.empty(); });
    });
    if (hasMorphs) out_.lost.push_back(Note("convert-morphs-lost"));
  }

  const GltfStore& store_;
  const JsonText& json_;
  const std::vector<GltfSurface>& parts_;
  const std::vector<Surface>& surfaces_;
  std::vector<std::string> materials_;
  std::set<int> shown_;  ///< parts that a node of the scene refers to
  PlainFile out_;
};

}  // namespace

PlainFile plainGltf(const GltfStore& store, const std::vector<GltfSurface>& parts,
                    const std::vector<Surface>& surfaces, int surface) {
  return GltfFlattener(store, parts, surfaces).run(surface);
}

}  // namespace hgp::io

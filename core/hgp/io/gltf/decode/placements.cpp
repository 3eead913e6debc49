#include "hgp/io/gltf/decode/placements.h"

#include <cmath>
#include <map>

#include "hgp/io/gltf/decode/affine.h"

namespace hgp::io {

Affine localPlace(const JsonText& json, int node) {
  const auto numbers = [&](const char* name) {
    std::vector<double> out;
    for (const int child : json.children(json.find(node, name)))
      out.push_back(json.number(child).value_or(0));
    return out;
  };
  const std::vector<double> m = numbers("matrix");
  if (m.size() == 16)
    return {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}}};
  std::vector<double> t = numbers("translation");
  std::vector<double> r = numbers("rotation");
  std::vector<double> s = numbers("scale");
  if (t.size() != 3) t = {0, 0, 0};
  if (r.size() != 4) r = {0, 0, 0, 1};
  if (s.size() != 3) s = {1, 1, 1};
  const double x = r[0], y = r[1], z = r[2], w = r[3];
  Affine out = {{{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                 {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                 {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
                 {t[0], t[1], t[2]}}};
  for (std::size_t k = 0; k < 3; ++k)
    for (double& c : out[k]) c *= s[k];
  return out;
}

namespace {

class NodePlaces {
 public:
  explicit NodePlaces(const JsonText& json)
      : json_(json),
        nodes_(list("nodes")),
        skins_(list("skins")),
        accessors_(list("accessors")),
        parent_(nodes_.size(), -1) {
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      for (const int child : json.children(json.find(nodes_[n], "children")))
        if (const int c = indexIn(child, nodes_); c >= 0)
          parent_[static_cast<std::size_t>(c)] = static_cast<int>(n);
  }

  const std::vector<int>& nodes() const { return nodes_; }

  /// Nodes form a forest (checked when the file was read).
  Affine world(int node) const {
    Affine place = kIdentityPlace;
    for (int n = node; n >= 0; n = parent_[static_cast<std::size_t>(n)])
      place = product(localPlace(json_, nodes_[static_cast<std::size_t>(n)]), place);
    return place;
  }

  /// Where a skinned mesh is in the bind pose, or `own`.
  Affine shown(int node, const Affine& own) const {
    const int skin = indexIn(json_.find(nodes_[static_cast<std::size_t>(node)], "skin"), skins_);
    if (skin < 0) return own;
    const std::vector<int> joints =
        json_.children(json_.find(skins_[static_cast<std::size_t>(skin)], "joints"));
    const int joint = joints.empty() ? -1 : indexIn(joints.front(), nodes_);
    return joint < 0 ? own : world(joint);
  }

  /// How many EXT_mesh_gpu_instancing makes of a node.
  long long copies(int node) const {
    const int extensions = json_.find(nodes_[static_cast<std::size_t>(node)], "extensions");
    const std::vector<int> attributes =
        json_.children(json_.find(json_.find(extensions, "EXT_mesh_gpu_instancing"), "attributes"));
    const int accessor = attributes.empty() ? -1 : indexIn(attributes.front(), accessors_);
    if (accessor < 0) return 1;
    return json_.integer(json_.find(accessors_[static_cast<std::size_t>(accessor)], "count"))
        .value_or(1);
  }

 private:
  std::vector<int> list(const char* name) const {
    return json_.children(json_.find(JsonText::kRoot, name));
  }
  int indexIn(int value, const std::vector<int>& items) const {
    const auto index = value < 0 ? std::nullopt : json_.integer(value);
    const bool isIn = index && *index >= 0 && static_cast<std::size_t>(*index) < items.size();
    return isIn ? static_cast<int>(*index) : -1;
  }

  const JsonText& json_;
  std::vector<int> nodes_, skins_, accessors_, parent_;
};

bool isUsable(const Affine& place) {
  for (const Vec3& column : place)
    for (const double x : column)
      if (!std::isfinite(x)) return false;
  return determinant(place) != 0.0;
}

std::array<double, 16> matrixOf(const Affine& m) {
  return {m[0][0], m[0][1], m[0][2], 0, m[1][0], m[1][1], m[1][2], 0,
          m[2][0], m[2][1], m[2][2], 0, m[3][0], m[3][1], m[3][2], 1};
}

}  // namespace

std::vector<Placements> placementsOf(const GltfStore& store,
                                     const std::vector<GltfSurface>& parts) {
  std::vector<Placements> out(parts.size());
  std::map<std::int64_t, std::size_t> partOf;
  for (std::size_t p = 0; p < parts.size(); ++p) partOf[parts[p].mesh] = p;
  const NodePlaces places(store.json);
  for (std::size_t n = 0; n < places.nodes().size(); ++n) {
    const auto mesh = store.json.integer(store.json.find(places.nodes()[n], "mesh"));
    const auto part = mesh ? partOf.find(*mesh) : partOf.end();
    if (part == partOf.end()) continue;
    Placements& one = out[part->second];
    const auto node = static_cast<int>(n);
    const Affine own = places.world(node);
    one.count += places.copies(node);
    one.isMirrored = one.isMirrored || determinant(own) < 0.0;
    if (isUsable(own)) one.matrices.push_back(matrixOf(places.shown(node, own)));
  }
  return out;
}

}  // namespace hgp::io

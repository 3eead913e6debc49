#include "hgp/io/gltf/decode/weld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/disjoint_sets.h"
#include "hgp/io/gltf/decode/accessor.h"
#include "hgp/io/limits.h"
#include "hgp/io/weld.h"

namespace hgp::io {
namespace {

/// Names in notes for the primitives that are kept as they are: by mode, and without positions.
constexpr std::array kKinds = {"points", "lines", "line loops", "line strips", "without positions"};
constexpr std::size_t kWithoutPositions = 4;

/// A coordinate that is not a number equals itself here: copies of such a vertex are still one vertex.
bool isSamePlace(const Vec3& a, const Vec3& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a[k] != b[k] && !(std::isnan(a[k]) && std::isnan(b[k]))) return false;
  return true;
}

/// Collects the primitives of one mesh, welds their vertices and writes the notes.
class GltfWelder {
 public:
  GltfWelder(const GltfStore& store, int mesh, const Limits& limits)
      : store_(store), mesh_(store.model.meshes[static_cast<std::size_t>(mesh)]), limits_(limits) {
    out_.mesh = mesh;
    out_.surface.meshInFile = mesh;
    out_.surface.name = mesh_.name;
    out_.surface.isWelded = true;
  }

  Result<GltfSurface> run() {
    for (std::size_t p = 0; p < mesh_.primitives.size(); ++p) {
      const Status status = addPrimitive(static_cast<int>(p));
      if (!status) return status.error();
    }
    out_.surface.storedVertexCount = static_cast<int>(positions_.size());
    if (out_.runs.empty()) return std::move(out_);
    if (!weldByExtension()) weldByPosition();
    for (const auto& triangle : out_.stored) {
      auto& welded = out_.surface.mesh.triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        welded[k] = out_.welded[static_cast<std::size_t>(triangle[k])];
      }
    }
    addNotes();
    findUvSets();
    return std::move(out_);
  }

 private:
  const GltfPrimitive& primitive(int p) const {
    return mesh_.primitives[static_cast<std::size_t>(p)];
  }

  Status addPrimitive(int p) {
    const GltfPrimitive& source = primitive(p);
    if (!source.isTriangles()) {
      ++kept_[static_cast<std::size_t>(source.mode)];
      return Done{};
    }
    if (source.attribute("POSITION") < 0) {
      ++kept_[kWithoutPositions];
      return Done{};
    }
    const auto indices = readIndices(store_, out_.mesh, p);
    if (!indices) return indices.error();
    const auto pool = poolOf(p);
    if (!pool) return pool.error();
    const auto triangles = primitiveTriangles(source.mode, *indices);
    const std::size_t raw =
        source.mode == 4 ? indices->size() / 3 : std::max<std::size_t>(indices->size(), 2) - 2;
    if (source.mode != 4) {
      ++(source.mode == 5 ? strips_ : fans_);
      unrolled_ += triangles.size();
      degenerate_ += raw - triangles.size();
    } else if (indices->size() % 3 != 0) {
      ++incomplete_;
    }
    out_.runs.push_back(
        {p, *pool, static_cast<int>(out_.stored.size()), static_cast<int>(triangles.size())});
    const int first = out_.pools[static_cast<std::size_t>(*pool)].firstStored;
    for (const auto& t : triangles) {
      out_.stored.push_back({first + static_cast<int>(t[0]), first + static_cast<int>(t[1]),
                             first + static_cast<int>(t[2])});
    }
    return Done{};
  }

  Result<int> poolOf(int p) {
    const GltfPrimitive& source = primitive(p);
    const std::pair key(source.attribute("POSITION"), source.draco ? source.draco->view : -1);
    const auto known = poolOfKey_.find(key);
    if (known != poolOfKey_.end()) {
      out_.pools[static_cast<std::size_t>(known->second)].primitives.push_back(p);
      return known->second;
    }
    const GltfAccessor& shape = store_.model.accessors[static_cast<std::size_t>(key.first)];
    const std::uint64_t total = positions_.size() + shape.count;
    if (total * sizeof(Vec3) > limits_.maxBytes || total > INT32_MAX / 2) {
      return Failure{ErrorCode::kLimit,
                     "read",
                     formatText("mesh %d has %llu vertices, more than fit into ", out_.mesh,
                                static_cast<unsigned long long>(total)) +
                         byteLimit(limits_.maxBytes),
                     {},
                     {Note("raise-bytes")}};
    }
    const int pool = static_cast<int>(out_.pools.size());
    poolOfKey_[key] = pool;
    out_.pools.push_back({{p}, static_cast<int>(shape.count), static_cast<int>(positions_.size())});
    const std::vector<double> numbers =
        realNumbers(shape, packedAttribute(store_, out_.mesh, p, "POSITION"));
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
      positions_.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    }
    return pool;
  }

  void weldByPosition() {
    Weld weld = weldExact(positions_);
    out_.surface.mesh.positions = std::move(weld.positions);
    out_.welded = std::move(weld.welded);
  }

  /// Welds by EXT_mesh_manifold: index k of the manifold is base[k] without its sparse values and
  /// merged[k] with them. False if the mesh has no such extension or the merges are not usable.
  bool weldByExtension() {
    if (!mesh_.manifold) return false;
    const GltfManifold& manifold = *mesh_.manifold;
    if (manifold.indices < 0 || out_.pools.size() != 1 ||
        manifold.position != primitive(out_.pools[0].primitives[0]).attribute("POSITION")) {
      return ignoreExtension("read-manifold-vertices");
    }
    const GltfAccessor& accessor =
        store_.model.accessors[static_cast<std::size_t>(manifold.indices)];
    if (accessor.components() != 1 || accessor.isNormalized ||
        (accessor.componentType != kGltfUnsignedByte &&
         accessor.componentType != kGltfUnsignedShort &&
         accessor.componentType != kGltfUnsignedInt)) {
      return ignoreExtension("read-manifold-types");
    }
    if (!manifoldStarts(store_, out_.mesh, out_.runs)) {
      return ignoreExtension("read-manifold-indices");
    }
    const std::optional<std::vector<std::uint32_t>> merged = mergedVertices(accessor);
    if (!merged) return false;
    joinAll(*merged);
    note("read-manifold-used");
    out_.isWeldedByExtension = true;
    return true;
  }

  /// For each stored vertex, the one into which the extension merges it, or itself.
  /// Empty if that depends on the corner: after copies are made in writing, the extension could no longer
  /// describe the same merges.
  std::optional<std::vector<std::uint32_t>> mergedVertices(const GltfAccessor& accessor) {
    std::vector<std::uint32_t> merged(positions_.size());
    std::iota(merged.begin(), merged.end(), 0u);
    if (!accessor.sparse) return merged;
    const GltfSparse& sparse = *accessor.sparse;
    const ByteView base = store_.accessorBytes(accessor);
    const ByteView where = store_.viewBytes(sparse.indexView).subspan(sparse.indexOffset);
    const ByteView values = store_.viewBytes(sparse.valueView).subspan(sparse.valueOffset);
    const std::uint64_t stride = store_.accessorStride(accessor);
    const auto baseAt = [&](std::uint64_t at) -> std::uint32_t {
      return base.empty() ? 0 : unsignedAt(base.subspan(at * stride), accessor.componentType, 0);
    };
    std::vector<std::int64_t> unlisted(positions_.size(), 0);  // corners without a sparse value
    for (std::uint64_t k = 0; k < accessor.count; ++k)
      if (const std::uint32_t v = baseAt(k); v < unlisted.size()) ++unlisted[v];
    std::vector<char> isListed(positions_.size(), 0);
    bool isAmbiguous = false;
    for (std::uint64_t k = 0; k < sparse.count; ++k) {
      const std::uint32_t from = baseAt(unsignedAt(where, sparse.indexType, k));
      const std::uint32_t to = unsignedAt(values, accessor.componentType, k);
      if (from >= positions_.size() || to >= positions_.size() ||
          !isSamePlace(positions_[from], positions_[to])) {
        ignoreExtension("read-manifold-apart");
        return std::nullopt;
      }
      --unlisted[from];
      if (isListed[from] && merged[from] != to) isAmbiguous = true;
      isListed[from] = 1;
      merged[from] = to;
    }
    for (std::size_t v = 0; v < merged.size(); ++v)
      isAmbiguous = isAmbiguous || (isListed[v] && merged[v] != v && unlisted[v] != 0);
    if (isAmbiguous) {
      ignoreExtension("read-manifold-corners");
      return std::nullopt;
    }
    return merged;
  }

  void joinAll(const std::vector<std::uint32_t>& merged) {
    DisjointSets sets(static_cast<int>(positions_.size()));
    for (std::size_t v = 0; v < merged.size(); ++v)
      sets.join(static_cast<int>(v), static_cast<int>(merged[v]));
    std::vector<int> id(positions_.size(), -1);
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      int& vertex = id[static_cast<std::size_t>(sets.root(static_cast<int>(v)))];
      if (vertex < 0) {
        vertex = static_cast<int>(out_.surface.mesh.positions.size());
        out_.surface.mesh.positions.push_back(positions_[v]);
      }
      out_.welded.push_back(vertex);
    }
  }

  bool ignoreExtension(const char* code) {
    note(code);
    return false;
  }

  /// One note for all primitives of a kind: some exporters write thousands.
  void addPrimitiveNotes() {
    for (std::size_t kind = 0; kind < kept_.size(); ++kind)
      if (const int count = kept_[kind]; count > 0)
        note("read-primitives-kept", {{"primitives", count}, {"kind", kKinds[kind]}});
    if (strips_ + fans_ > 0)
      note(strips_ > 0 ? "read-strips-unrolled" : "read-fans-unrolled",
           {{"strips", strips_},
            {"fans", fans_},
            {"all", strips_ + fans_},
            {"triangles", unrolled_},
            {"degenerate", degenerate_}});
    if (incomplete_ > 0) note("read-incomplete-triangles", {{"primitives", incomplete_}});
  }

  void addNotes() {
    addPrimitiveNotes();
    bool hasTargets = false, isSkinned = false;
    for (const GltfRun& run : out_.runs) {
      hasTargets = hasTargets || !primitive(run.primitive).targets.empty();
      isSkinned = isSkinned || primitive(run.primitive).attribute("JOINTS_0") >= 0;
    }
    if (hasTargets) note("read-morph-targets");
    if (isSkinned) note("read-skinned");
  }

  /// A uv set is listed if every triangle primitive has it.
  void findUvSets() {
    for (int set = 0; set < 64; ++set) {
      const std::string semantic = "TEXCOORD_" + std::to_string(set);
      const bool isEverywhere = std::all_of(
          out_.runs.begin(), out_.runs.end(),
          [&](const GltfRun& run) { return primitive(run.primitive).attribute(semantic) >= 0; });
      if (!isEverywhere) continue;
      out_.surface.uvSets.push_back(set);
      if (std::all_of(out_.runs.begin(), out_.runs.end(), [&](const GltfRun& run) {
            const int accessor = primitive(run.primitive).attribute(semantic);
            return store_.model.accessors[static_cast<std::size_t>(accessor)].isOwnUv;
          }))
        out_.surface.ownUvSet = set;
    }
  }

  void note(const char* code, std::vector<NoteValue> values = {}) {
    out_.surface.notes.emplace_back(code, std::move(values));
  }

  const GltfStore& store_;
  const GltfMesh& mesh_;
  const Limits& limits_;
  GltfSurface out_;
  std::vector<Vec3> positions_;  ///< stored
  std::map<std::pair<int, int>, int> poolOfKey_;
  std::array<int, kKinds.size()> kept_{};  ///< primitives without triangles, by kind
  int strips_ = 0, fans_ = 0, incomplete_ = 0;
  std::size_t unrolled_ = 0, degenerate_ = 0;  ///< triangles of strips and fans, read and skipped
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> primitiveTriangles(
    int mode, const std::vector<std::uint32_t>& indices) {
  std::vector<std::array<std::uint32_t, 3>> out;
  if (mode == 4) {
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      out.push_back({indices[i], indices[i + 1], indices[i + 2]});
    }
    return out;
  }
  for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
    const std::array<std::uint32_t, 3> t =
        mode == 6    ? std::array{indices[i + 1], indices[i + 2], indices[0]}
        : i % 2 == 0 ? std::array{indices[i], indices[i + 1], indices[i + 2]}
                     : std::array{indices[i], indices[i + 2], indices[i + 1]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) out.push_back(t);
  }
  return out;
}

std::optional<std::vector<std::size_t>> manifoldStarts(const GltfStore& store, int mesh,
                                                       const std::vector<GltfRun>& runs) {
  const auto accessorAt = [&](int index) -> const GltfAccessor& {
    return store.model.accessors[static_cast<std::size_t>(index)];
  };
  const GltfMesh& source = store.model.meshes[static_cast<std::size_t>(mesh)];
  if (!source.manifold || source.manifold->indices < 0) return {};
  const GltfAccessor& whole = accessorAt(source.manifold->indices);
  std::vector<char> isCovered(whole.count, 0);
  std::vector<std::size_t> starts;
  for (const GltfRun& run : runs) {
    const GltfPrimitive& primitive = source.primitives[static_cast<std::size_t>(run.primitive)];
    if (primitive.indices < 0 || primitive.mode != 4) return {};
    const GltfAccessor& own = accessorAt(primitive.indices);
    if (own.view != whole.view || own.componentType != whole.componentType || own.sparse ||
        own.offset < whole.offset) {
      return {};
    }
    const std::size_t start = (own.offset - whole.offset) / whole.componentSize();
    if (start > isCovered.size() || own.count > isCovered.size() - start) return {};
    const auto first = isCovered.begin() + static_cast<std::ptrdiff_t>(start);
    const auto last = first + static_cast<std::ptrdiff_t>(own.count);
    if (std::find(first, last, char(1)) != last) return {};  // two primitives share these indices
    std::fill(first, last, char(1));
    starts.push_back(start);
  }
  if (std::find(isCovered.begin(), isCovered.end(), char(0)) != isCovered.end()) return {};
  return starts;
}

Result<GltfSurface> weldGltfMesh(const GltfStore& store, int mesh, const Limits& limits) {
  return GltfWelder(store, mesh, limits).run();
}

}  // namespace hgp::io

#include "hgp/io/gltf/document.h"

#include <algorithm>
#include <map>

#include "hgp/base/check.h"
#include "hgp/io/gltf/decode/accessor.h"
#include "hgp/io/gltf/decode/decoders.h"
#include "hgp/io/gltf/decode/plain.h"
#include "hgp/io/gltf/pack/pack.h"
#include "hgp/io/gltf/patch/write.h"
#include "hgp/io/round_uv.h"
#include "hgp/io/weld.h"
#include "hgp/prescription/cones.h"

namespace hgp::io {
namespace {

/// Whether a + b is exact in double precision: the error term of Knuth's two-sum is zero.
bool isExactSum(double a, double b) {
  const double sum = a + b, fromB = sum - a;
  return (a - (sum - fromB)) + (b - fromB) == 0.0;
}

/// Whether both were read from the same bytes, so that the indices of one are those of the other.
bool isSameFile(const GltfStore& a, const GltfStore& b) {
  if (&a == &b) return true;
  return a.json.text() == b.json.text() &&
         std::equal(a.buffers.begin(), a.buffers.end(), b.buffers.begin(), b.buffers.end(),
                    [](const auto& x, const auto& y) {
                      return std::equal(x.bytes.begin(), x.bytes.end(), y.bytes.begin(),
                                        y.bytes.end());
                    });
}

}  // namespace

GltfDocument::GltfDocument(std::shared_ptr<const GltfStore> store, std::vector<GltfSurface> parts,
                           std::shared_ptr<const GltfDecoders> decoders)
    : store_(std::move(store)), parts_(std::move(parts)), decoders_(std::move(decoders)) {
  for (GltfSurface& part : parts_) surfaces_.push_back(std::move(part.surface));
}

std::optional<UvMap> GltfDocument::existingUv(int surface, int set) const {
  return readUv(surface, set, 1.0);
}

std::optional<UvMap> GltfDocument::exactUv(int surface, int set) const {
  std::optional<UvMap> map = readUv(surface, set, 0.0);
  if (!map) return map;
  const auto isExact = [](const Vec2& p) { return isExactSum(1.0, p[1]); };
  if (!std::all_of(map->uv.begin(), map->uv.end(), isExact)) return map;
  for (Vec2& p : map->uv) p[1] += 1.0;
  return map;
}

std::optional<UvMap> GltfDocument::readUv(int surface, int set, double top) const {
  const GltfSurface& part = parts_[static_cast<std::size_t>(surface)];
  const std::string semantic = formatText("TEXCOORD_%d", set);
  const auto& primitives = store_->model.meshes[static_cast<std::size_t>(part.mesh)].primitives;
  UvMap map;
  std::map<std::pair<int, int>, int> baseOf;  // pool and accessor → index of their first uv
  for (const GltfRun& run : part.runs) {
    const int accessor = primitives[static_cast<std::size_t>(run.primitive)].attribute(semantic);
    if (accessor < 0) return std::nullopt;
    const GltfPool& pool = part.pools[static_cast<std::size_t>(run.pool)];
    const auto [base, isNew] =
        baseOf.try_emplace({run.pool, accessor}, static_cast<int>(map.uv.size()));
    if (isNew) {
      const std::vector<double> numbers =
          realNumbers(store_->model.accessors[static_cast<std::size_t>(accessor)],
                      packedAttribute(*store_, part.mesh, run.primitive, semantic));
      for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
        map.uv.push_back({numbers[i], top - numbers[i + 1]});
      }
    }
    const int shift = base->second - pool.firstStored;
    for (int t = run.firstTriangle; t < run.firstTriangle + run.triangleCount; ++t) {
      const auto& corners = part.stored[static_cast<std::size_t>(t)];
      map.cornerUv.push_back({corners[0] + shift, corners[1] + shift, corners[2] + shift});
    }
  }
  joinEqualCopies(surfaces_[static_cast<std::size_t>(surface)].mesh, map);
  return map;
}

UvMap GltfDocument::asStored(int surface, const UvMap& map, const std::vector<int>& partOf) const {
  return roundToFloat32(surfaces_[static_cast<std::size_t>(surface)].mesh, map, partOf);
}

Result<std::optional<prescription::Prescription>> GltfDocument::embeddedCones(int surface) const {
  const JsonText& json = store_->json;
  const std::vector<int> meshes = json.children(json.find(JsonText::kRoot, "meshes"));
  const int mesh = meshes[static_cast<std::size_t>(parts_[static_cast<std::size_t>(surface)].mesh)];
  const int cones = json.find(json.find(mesh, "extras"), kGltfConesKey);
  if (!json.isObject(cones)) return std::optional<prescription::Prescription>();
  auto read = prescription::readConesJson(json.raw(cones));
  if (!read) return read.error();
  return std::optional<prescription::Prescription>(std::move(*read));
}

/// A GLB that was asked for as a .gltf is one.
Status GltfDocument::storeApart(Written& written, const WriteOptions& options) const {
  if (options.format != "gltf" || !store_->container.isBinary) return Done{};
  auto apart = glbAsGltf(written.files[0].bytes, options.name);
  if (!apart) return apart.error();
  written.files = std::move(apart->files);
  written.notes.insert(written.notes.end(), apart->notes.begin(), apart->notes.end());
  return Done{};
}

Result<Written> GltfDocument::write(int surface, const UvMap& map,
                                    const WriteOptions& options) const {
  auto written = writeGltf(*store_, parts_[static_cast<std::size_t>(surface)], map, options);
  if (!written) return written;
  if (Status done = storeApart(*written, options); !done) return done.error();
  return written;
}

Result<WrittenMaps> GltfDocument::writeAll(const std::vector<SurfaceUv>& maps,
                                           const WriteOptions& options) const {
  std::vector<GltfMap> list;
  for (const SurfaceUv& one : maps) {
    const auto* of = one.document->asGltf();
    if (of == nullptr || !isSameFile(*of->store_, *store_))
      return Failure{ErrorCode::kUsage, "write", "the maps are not all of one file", {}};
    list.push_back({&of->parts_[static_cast<std::size_t>(one.surface)], one.map, one.cones,
                    one.uvSet, one.pointsMaterials});
  }
  auto written = writeGltfMaps(*store_, list, options);
  if (!written) return written;
  if (Status done = storeApart(*written, options); !done) return done.error();
  return written;
}

Result<PlainFile> GltfDocument::plain(int surface) const {
  return plainGltf(*store_, parts_, surfaces_, surface);
}

Result<DocumentPtr> readGltf(FileSet files, const Limits& limits) {
  const std::shared_ptr<const GltfDecoders> given = files.decoders;
  const GltfDecoders decoders = given ? *given : builtInDecoders();
  auto store = loadGltf(std::move(files), limits, decoders);
  if (!store) return store.error();
  std::vector<GltfSurface> parts;
  for (std::size_t m = 0; m < (*store)->model.meshes.size(); ++m) {
    auto part = weldGltfMesh(**store, static_cast<int>(m), limits);
    if (!part) return part.error();
    if (part->runs.empty()) continue;
    auto& notes = part->surface.notes;
    const auto& ofFile = (*store)->container.notes;
    notes.insert(notes.begin(), ofFile.begin(), ofFile.end());
    parts.push_back(std::move(*part));
  }
  if (parts.empty()) {
    return Failure{ErrorCode::kUnsupported,
                   "read",
                   "the file has no mesh with triangles; points and lines have no surface",
                   {}};
  }
  return DocumentPtr(std::make_unique<GltfDocument>(std::move(*store), std::move(parts), given));
}

Result<DocumentPtr> GltfDocument::repaired(int surface, const FaceEdits& edits) const {
  std::vector<GltfSurface> parts(parts_.size());
  GltfSurface& part = parts[static_cast<std::size_t>(surface)];
  part = parts_[static_cast<std::size_t>(surface)];
  part.surface = surfaces_[static_cast<std::size_t>(surface)];
  const auto before = static_cast<int>(part.surface.mesh.positions.size());
  part.copy.assign(part.stored.size(), {GltfSurface::kUnedited, 0, 0});
  for (const EditedFace& edit : edits.faces) {
    const auto f = static_cast<std::size_t>(edit.face);
    const auto stored = part.stored[f], welded = part.surface.mesh.triangles[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(edit.corner[k]);
      part.stored[f][k] = stored[corner];
      part.surface.mesh.triangles[f][k] = welded[corner];
      part.copy[f][k] = edit.vertex[k] < before ? 0 : edit.vertex[k];
    }
  }
  return DocumentPtr(std::make_unique<GltfDocument>(store_, std::move(parts), decoders_));
}

}  // namespace hgp::io

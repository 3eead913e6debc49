#include "hgp/api/file_maps.h"

#include <set>

#include "hgp/api/session/guard.h"
#include "hgp/api/session/session_state.h"
#include "hgp/io/cone_files.h"
#include "hgp/io/grid_material.h"

namespace hgp::api {

struct FileMaps::Kept {
  std::shared_ptr<const io::Document> file;      ///< as it was read
  std::shared_ptr<const io::Document> document;  ///< with the repairs that are written
  int surface = 0;
  UvMap map;
  std::optional<std::string> cones;
  WriteOptions options;
  double tiles = 0.0;
  bool isCertified = false;
};

FileMaps::FileMaps(WriteOptions options) : options_(std::move(options)) {}
FileMaps::~FileMaps() = default;
FileMaps::FileMaps(FileMaps&&) noexcept = default;
FileMaps& FileMaps::operator=(FileMaps&&) noexcept = default;
bool FileMaps::isEmpty() const { return kept_.empty(); }

Status FileMaps::add(const Session& session) { return add(session, options_); }

Status FileMaps::add(const Session& session, const WriteOptions& own) {
  return guarded([&]() -> Status {
    if (!session.hasResult() || !session.state_->file)
      return Failure{ErrorCode::kUsage, "write", "there is no result on a mesh of a file", {}};
    if (!session.isCertified() && !own.allowUncertified)
      return Failure{ErrorCode::kNoMap, "write", "the map is not certified", {}};
    if (Status possible = session.canWrite(options_.name); !possible) return possible;
    const Session::State& shown = session.state_->shown();
    Kept one;
    one.file = session.state_->file->document;
    one.document = shown.model->document;
    one.surface = shown.model->surface;
    one.map = shown.solved->stored.map;
    one.options = own;
    if (own.embedCones) one.cones = prescription::writeConesJson(shown.solved->prescription, -1);
    if (own.gridTiles) one.tiles = shown.tilesOfGrid(own);
    one.isCertified = session.isCertified();
    kept_.push_back(std::move(one));
    return Done{};
  });
}

Result<WrittenFile> FileMaps::write() const {
  return guarded([&]() -> Result<WrittenFile> {
    if (kept_.empty()) return Failure{ErrorCode::kUsage, "write", "there is no map to write", {}};
    std::vector<io::SurfaceUv> maps;
    std::vector<io::GridMaterial> grids;
    std::set<int> meshes;
    WrittenFile out;
    out.isCertified = true;
    for (const Kept& one : kept_) {
      if (!meshes.insert(one.surface).second)
        return Failure{ErrorCode::kUsage, "write", "two maps are of the same mesh", {}};
      maps.push_back({one.document.get(), one.surface, &one.map, one.cones, one.options.uvSet,
                      one.options.pointsMaterials});
      const io::Surface& surface = one.file->surfaces()[static_cast<std::size_t>(one.surface)];
      if (one.options.gridTiles)
        grids.push_back({one.tiles, surface.meshInFile, one.options.uvSet});
      out.isCertified = out.isCertified && one.isCertified;
    }
    const io::Document& file = *kept_.front().file;
    io::WriteOptions options = ioOptions(options_);
    options.format = extensionOf(options_.name);
    if (!file.canWriteAs(options.format)) options.format.clear();
    Result<io::WrittenMaps> written = file.writeAll(maps, options);
    if (!written) return written.error();
    out.mapNotes = std::move(written->mapNotes);
    static_cast<io::Written&>(out) = std::move(*written);
    if (!grids.empty()) {
      auto files = io::withGridMaterials(std::move(out.files), grids);
      if (!files) return files.error();
      out.files = std::move(*files);
    }
    return out;
  });
}

}  // namespace hgp::api

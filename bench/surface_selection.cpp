#include "surface_selection.h"

#include <algorithm>
#include <filesystem>

#include "files.h"
#include "hgp/api/model/load_model.h"
#include "hgp/base/check.h"
#include "program.h"
#include "surfaces.h"

namespace hgp::bench {
namespace {

namespace fs = std::filesystem;
using Visit = std::function<void(const std::string&, const TriMesh&)>;

bool isWanted(const SurfaceSelection& selection, const std::string& name) {
  return (selection.only.empty() || matchesOneOf(selection.only, name)) &&
         !matchesOneOf(selection.skip, name);
}

void visitFolder(const SurfaceSelection& selection, const Visit& visit) {
  std::vector<std::pair<std::uintmax_t, fs::path>> files;
  for (const auto& entry : fs::recursive_directory_iterator(selection.folder)) {
    const std::string name = entry.path().lexically_relative(selection.folder).generic_string();
    if (entry.is_regular_file() && isWanted(selection, name))
      files.emplace_back(entry.file_size(), entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& [size, file] : files) {
    api::LoadOptions load;
    Result<io::FileSet> set = cli::openFiles(file.string(), "", "", load.limits.maxBytes);
    if (!set) continue;
    const Result<api::Model> model = api::loadModel(std::move(*set), load);
    if (!model || model->unusable) continue;
    const std::string name = file.lexically_relative(selection.folder).generic_string();
    for (std::size_t i = 0; i < model->components.size(); ++i)
      visit(model->components.size() > 1 ? formatText("%s #%zu", name.c_str(), i) : name,
            model->components[i].mesh);
  }
}

void visitGenerated(const SurfaceSelection& selection, const Visit& visit) {
  for (int n = 0; n < selection.generated; ++n) {
    const std::string name = formatText("surface %d", n);
    const std::string seeded =
        formatText("%llu/%s", static_cast<unsigned long long>(selection.seed), name.c_str());
    if (!isWanted(selection, name)) continue;
    const auto mesh = buildTriMesh(stress::randomSurface(seeded, n % 7, n / 7 % 3));
    if (mesh) visit(seeded, *mesh);
  }
}

}  // namespace

void SurfaceSelection::addOptions(CLI::App& app) {
  app.add_option("dir", folder, "folder of meshes");
  app.add_option("--generated", generated, "so many surfaces from a seed instead");
  app.add_option("--seed", seed, "of --generated, and of drawn cones");
  app.add_option("--only", only, "names to take, as a pattern: '*torus*'");
  app.add_option("--skip", skip, "names to leave out");
  app.add_option("--smallest", smallest, "leave out surfaces of fewer triangles");
  app.add_option("--largest", largest, "leave out surfaces of more triangles");
}

bool SurfaceSelection::isUsable() const {
  std::error_code error;
  return generated > 0 || fs::is_directory(folder, error);
}

void eachSurface(const SurfaceSelection& selection, const Visit& visit) {
  const Visit visitFitting = [&](const std::string& name, const TriMesh& mesh) {
    const bool isTooLarge = selection.largest > 0 && mesh.faceCount() > selection.largest;
    if (mesh.faceCount() >= selection.smallest && !isTooLarge) visit(name, mesh);
  };
  if (selection.generated > 0) {
    visitGenerated(selection, visitFitting);
  } else {
    visitFolder(selection, visitFitting);
  }
}

}  // namespace hgp::bench

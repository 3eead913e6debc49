#include "mesh_notes.h"

#include <algorithm>
#include <cstddef>

namespace hgp::cli {
namespace {

/// "mesh 3", "meshes 1, 2", "meshes 0 to 4, 7".
std::string named(const std::vector<int>& meshes) {
  std::string out = meshes.size() == 1 ? "mesh " : "meshes ";
  for (std::size_t i = 0; i < meshes.size();) {
    std::size_t last = i;
    while (last + 1 < meshes.size() && meshes[last + 1] == meshes[last] + 1) ++last;
    if (last == i + 1) last = i;  // two are not a range
    if (i > 0) out += ", ";
    out += std::to_string(meshes[i]);
    if (last > i) out += " to " + std::to_string(meshes[last]);
    i = last + 1;
  }
  return out;
}

}  // namespace

void MeshNotes::add(int mesh, const std::string& note) {
  const auto found =
      std::find_if(notes_.begin(), notes_.end(), [&](const Note& n) { return n.text == note; });
  if (found == notes_.end()) {
    notes_.push_back({note, {mesh}});
  } else if (found->meshes.back() != mesh) {
    found->meshes.push_back(mesh);
  }
}

std::vector<std::string> MeshNotes::lines() const {
  std::vector<std::string> out;
  out.reserve(notes_.size());
  for (const Note& note : notes_) out.push_back(named(note.meshes) + ": " + note.text);
  return out;
}

}  // namespace hgp::cli

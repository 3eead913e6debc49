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

void addOnce(std::vector<int>& meshes, int mesh) {
  if (meshes.empty() || meshes.back() != mesh) meshes.push_back(mesh);
}

}  // namespace

void MeshNotes::add(int mesh, const std::string& code, const std::string& text) {
  const auto found =
      std::find_if(notes_.begin(), notes_.end(), [&](const Kind& n) { return n.code == code; });
  if (found == notes_.end()) {
    notes_.push_back({text, code, {mesh}, {}});
  } else if (found->text == text) {
    addOnce(found->meshes, mesh);
  } else if (found->meshes.back() != mesh) {
    addOnce(found->others, mesh);
  }
}

std::vector<std::string> MeshNotes::lines() const {
  std::vector<std::string> out;
  out.reserve(notes_.size());
  for (const Kind& note : notes_) {
    out.push_back(named(note.meshes) + ": " + note.text);
    if (!note.others.empty()) out.back() += "; likewise, with other numbers, " + named(note.others);
  }
  return out;
}

}  // namespace hgp::cli

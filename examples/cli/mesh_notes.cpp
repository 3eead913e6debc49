#include "mesh_notes.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

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

constexpr std::string_view digits = "0123456789";

/// The end of the number at the start of `text`; 0 without one.
std::size_t numberLength(std::string_view text) {
  if (text.empty() || digits.find(text[0]) == digits.npos) return 0;
  std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
  if (end == text.size() || text[end] != 'e') return end;
  const std::size_t sign = text.find_first_of("+-", end + 1) == end + 1 ? 1 : 0;
  const std::size_t exponent =
      std::min(text.find_first_not_of(digits, end + 1 + sign), text.size());
  return exponent > end + 1 + sign ? exponent : end;
}

/// The text with "#" for every number and for every list of numbers, which "…" may end.
std::string kindOf(std::string_view text) {
  constexpr std::string_view separator = ", ";
  constexpr std::string_view more = ", …";
  std::string out;
  bool isList = false;
  while (!text.empty()) {
    const std::size_t skipped = isList && text.starts_with(separator) ? separator.size() : 0;
    if (const std::size_t length = numberLength(text.substr(skipped)); length > 0) {
      if (skipped == 0) out += '#';
      text.remove_prefix(skipped + length);
      isList = true;
    } else if (isList && text.starts_with(more)) {
      text.remove_prefix(more.size());
    } else {
      out += text[0];
      text.remove_prefix(1);
      isList = false;
    }
  }
  return out;
}

void addOnce(std::vector<int>& meshes, int mesh) {
  if (meshes.empty() || meshes.back() != mesh) meshes.push_back(mesh);
}

}  // namespace

void MeshNotes::add(int mesh, const std::string& note) {
  const std::string kind = kindOf(note);
  const auto found =
      std::find_if(notes_.begin(), notes_.end(), [&](const Note& n) { return n.kind == kind; });
  if (found == notes_.end()) {
    notes_.push_back({note, kind, {mesh}, {}});
  } else if (found->text == note) {
    addOnce(found->meshes, mesh);
  } else if (found->meshes.back() != mesh) {
    addOnce(found->others, mesh);
  }
}

std::vector<std::string> MeshNotes::lines() const {
  std::vector<std::string> out;
  out.reserve(notes_.size());
  for (const Note& note : notes_) {
    out.push_back(named(note.meshes) + ": " + note.text);
    if (!note.others.empty()) out.back() += "; likewise, with other numbers, " + named(note.others);
  }
  return out;
}

}  // namespace hgp::cli

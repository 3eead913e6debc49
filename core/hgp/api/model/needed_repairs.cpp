#include "hgp/api/model/needed_repairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <unordered_map>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/disjoint_sets.h"
#include "hgp/base/portable_math.h"
#include "hgp/io/weld.h"
#include "hgp/mesh/edge_table.h"
#include "hgp/mesh/vectors.h"

namespace hgp::api {
namespace {

int componentCount(const MeshData& mesh, const std::vector<int>* image, bool& isSoup) {
  const auto vertices = static_cast<int>(mesh.positions.size());
  DisjointSets sets(vertices);
  std::vector<char> isUsed(mesh.positions.size(), 0);
  int faces = 0, components = 0;
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> v = t;
    if (std::any_of(v.begin(), v.end(), [&](int i) { return i < 0 || i >= vertices; })) continue;
    if (image) {
      for (int& i : v) i = (*image)[static_cast<std::size_t>(i)];
    }
    ++faces;
    for (int i : v) {
      components += isUsed[static_cast<std::size_t>(i)] == 0;
      isUsed[static_cast<std::size_t>(i)] = 1;
    }
    components -= sets.join(v[0], v[1]);
    components -= sets.join(v[0], v[2]);
  }
  isSoup = faces > 1 && components == faces;
  return components;
}

}  // namespace

FixOptions neededRepairs(const std::vector<Defect>& defects) {
  FixOptions fix;
  for (const Defect& defect : defects) {
    switch (defect.kind) {
      case DefectKind::kInconsistentEdge:
        fix.orient = true;
        break;
      case DefectKind::kNonManifoldEdge:
      case DefectKind::kNonManifoldVertex:
        fix.split = true;
        break;
      case DefectKind::kRepeatedVertex:
      case DefectKind::kZeroArea:
      case DefectKind::kDuplicateFace:
        fix.degenerate = true;
        break;
      default:
        break;
    }
  }
  return fix;
}

Notes adviceAfter(const Notes& advice, const FixOptions& done, bool isAutomatic) {
  const Note* before = findNote(advice, "repair-with");
  if (!before) return advice;
  const NoteValue* named = before->find("fixes");
  const std::string fixes = named ? std::get<std::string>(named->value) : "";
  std::string more;
  const auto add = [&](const char* name, bool isDone) {
    if (isDone || fixes.find(name) == std::string::npos) return;
    if (!more.empty()) more += ',';
    more += name;
  };
  add("orient", done.orient);
  add("split", done.split);
  add("degenerate", done.degenerate);
  if (isAutomatic || more.empty()) return {Note("repair-by-hand")};
  return {Note("repair-with", {{"fixes", more}, {"more", 1}})};
}

WeldFacts weldFacts(const MeshData& mesh) {
  WeldFacts facts;
  const io::Weld weld = io::weldExact(mesh.positions);
  facts.sharing = static_cast<int>(mesh.positions.size() - weld.positions.size());
  facts.componentsBefore = componentCount(mesh, nullptr, facts.isSoup);
  facts.componentsAfter = facts.componentsBefore;
  bool ignored = false;
  if (facts.sharing > 0) facts.componentsAfter = componentCount(mesh, &weld.welded, ignored);
  facts.isSoup = facts.isSoup && facts.componentsAfter < facts.componentsBefore;
  return facts;
}

Notes weldNotes(const WeldFacts& weld, bool isWelded) {
  if (weld.componentsAfter >= weld.componentsBefore) return {};
  return {Note(isWelded ? "weld-soup" : "weld-would-join", {{"vertices", weld.sharing},
                                                            {"before", weld.componentsBefore},
                                                            {"after", weld.componentsAfter}})};
}

}  // namespace hgp::api

#include "hgp/api/option_table.h"

#include <algorithm>
#include <array>

namespace hgp::api {
namespace {

using K = OptionKind;
constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr double kAnyInt = kLargestInt;

// wasm/options.mjs reads these rows: one row is one pair of braces with literals.
constexpr std::array kLoadRows{
    OptionRow{"surface", "--mesh", "mesh", K::kInteger, "", 0, kAnyInt},
    OptionRow{"weld", "--weld", "weld", K::kWordOrNumber, "exact|none", 0, kNoEnd},
    OptionRow{"limits.bytes", "--max-bytes", "max_bytes", K::kInteger, "", 1, kNoEnd},
    OptionRow{"limits.triangles", "--max-triangles", "max_triangles", K::kInteger, "", 1, kNoEnd},
    OptionRow{"fix", "--fix", "fix", K::kWords, "orient|split|degenerate"},
    OptionRow{"strict", "--strict", "strict", K::kFlag},
    OptionRow{"writeRepairs", "--write-repairs", "write_repairs", K::kFlag},
    OptionRow{"target", "", "target", K::kWord, "obj|glb|gltf|ply"},
};

constexpr std::array kSolveRows{
    OptionRow{"q", "--q", "q", K::kInteger, "", 1, 64},
    OptionRow{"count", "--count", "count", K::kInteger, "", 0, kAnyInt},
    OptionRow{"conesFor", "--cones-for", "cones_for", K::kWord,
              "balanced|few|fewer|more|low-distortion"},
    OptionRow{"alignToCurvature", "--align", "align_to_curvature", K::kFlag},
    OptionRow{"boundary", "--boundary", "boundary", K::kWord, "free|convex|rectangle"},
    OptionRow{"maxRounds", "--rounds", "max_rounds", K::kInteger, "", 1, 1000},
    OptionRow{"method", "--method", "method", K::kWord, "auto|harmonic|soft|printed|all-frames"},
    OptionRow{"frames", "--frames", "frames", K::kWord, "auto|file"},
    OptionRow{"improve", "--improve", "improve", K::kWordOrNumber, "isometric|conformal|area", -1,
              1},
    OptionRow{"quality", "--quality", "quality", K::kFlag},
    OptionRow{"keepGoing", "--keep-going", "keep_going", K::kFlag},
    OptionRow{"scale", "--scale", "scale", K::kWord, "solved|unit|fit"},
    OptionRow{"refine", "--refine", "refine", K::kFlag},
    OptionRow{"convexPolygons", "--convex-polygons", "convex_polygons", K::kFlag},
    OptionRow{"grid.cells", "--cells", "cells", K::kNumber, "", 1, 1e15},
    OptionRow{"grid.spacing", "--grid", "grid", K::kNumber, "", 0, kNoEnd, true},
    OptionRow{"grid.mode", "--grid-mode", "grid_mode", K::kWord, "tile|quad"},
    OptionRow{"symmetric", "--symmetric", "symmetric", K::kWord, "auto|X|Y|Z"},
};

constexpr std::array kVerifyRows{
    OptionRow{"q", "--q", "q", K::kInteger, "", 0, 64},
    OptionRow{"uvSet", "--uv-set", "uv_set", K::kInteger, "", -1, 63},
    OptionRow{"tolerance", "--tol", "tolerance", K::kNumber, "", 0, kNoEnd},
};

constexpr std::array kWriteRows{
    OptionRow{"name", "--output", "path", K::kText},
    OptionRow{"format", "", "", K::kWord, "same|glb|gltf|obj|flat-obj|svg"},
    OptionRow{"gridMaterial", "--grid-material", "grid_material", K::kFlagOrNumber, "", 0, kNoEnd},
    OptionRow{"uvSet", "--uv-set", "uv_set", K::kInteger, "", -1, 15},
    OptionRow{"embedCones", "--embed-cones", "embed_cones", K::kFlag},
    OptionRow{"allowUncertified", "--allow-uncertified", "allow_uncertified", K::kFlag},
    OptionRow{"use", "--use", "use", K::kFlag},
};

}  // namespace

template <>
std::span<const OptionRow> optionRows<LoadOptions>() {
  return kLoadRows;
}
template <>
std::span<const OptionRow> optionRows<SolveOptions>() {
  return kSolveRows;
}
template <>
std::span<const OptionRow> optionRows<VerifyOptions>() {
  return kVerifyRows;
}
template <>
std::span<const OptionRow> optionRows<WriteOptions>() {
  return kWriteRows;
}

std::vector<std::string> wordsOf(const OptionRow& row) {
  std::vector<std::string> words;
  std::string_view rest = row.words;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('|'), rest.size());
    words.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return words;
}

std::vector<std::string> wordsOfFlag(std::string_view flag) {
  for (const auto rows : {optionRows<LoadOptions>(), optionRows<SolveOptions>(),
                          optionRows<VerifyOptions>(), optionRows<WriteOptions>()}) {
    for (const OptionRow& row : rows)
      if (flag == row.flag) return wordsOf(row);
  }
  return {};
}

}  // namespace hgp::api

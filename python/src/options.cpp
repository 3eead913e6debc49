#include "options.h"

#include <pybind11/stl.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../../examples/cli/files.h"
#include "failures.h"
#include "hgp/api/session.h"
#include "hgp/base/check.h"

namespace hgp::python {
namespace {

template <class T>
const char* kindOf() {
  if constexpr (std::is_same_v<T, bool>) return "True or False";
  if constexpr (std::is_integral_v<T>) return "an integer";
  if constexpr (std::is_floating_point_v<T>) return "a number";
  return "a string";
}

/// The option as this type; empty if it is absent or None.
template <class T>
std::optional<T> find(const py::dict& options, const char* name) {
  if (!options.contains(name)) return std::nullopt;
  const py::object value = options[name];
  if (value.is_none()) return std::nullopt;
  // A truth value is an integer in Python, and almost never meant as one here.
  const bool isBool = py::isinstance<py::bool_>(value);
  if (isBool == std::is_same_v<T, bool>) {
    try {
      return value.cast<T>();
    } catch (const py::cast_error&) {
      PyErr_Clear();
    }
  }
  const std::string given = py::repr(value);
  throw py::type_error(std::string(name) + " must be " + kindOf<T>() + ", not " + given);
}

template <class T>
T get(const py::dict& options, const char* name, T otherwise) {
  return find<T>(options, name).value_or(otherwise);
}

void refuse(const char* name, const std::string& given, const char* rule) {
  raiseUsage(std::string(name) + " must be " + rule + ", not " + given);
}

/// A number that satisfies `isGood`.
template <class T, class Rule>
std::optional<T> checked(const py::dict& options, const char* name, Rule isGood, const char* rule) {
  const std::optional<T> value = find<T>(options, name);
  if (value && !isGood(*value)) refuse(name, py::cast<std::string>(py::repr(options[name])), rule);
  return value;
}

/// The value that `named` gives to a word.
template <class Named>
auto choice(const py::dict& options, const char* name, Named named, const char* words)
    -> decltype(named(std::string())) {
  const std::optional<std::string> word = find<std::string>(options, name);
  if (!word) return std::nullopt;
  auto value = named(*word);
  if (!value) refuse(name, "'" + *word + "'", words);
  return value;
}

std::optional<int> orderOf(const py::dict& options) {
  return checked<int>(
      options, "q", [](int q) { return q >= 1 && q <= 64; }, "from 1 to 64");
}

bool isPositive(double x) { return std::isfinite(x) && x > 0; }

GridOptions toGrid(const py::dict& options) {
  GridOptions grid;
  const auto cells = checked<double>(
      options, "cells", [](double n) { return std::isfinite(n) && n >= 1; }, "at least 1");
  const auto spacing = checked<double>(options, "grid", isPositive, "a length above 0");
  if (cells && spacing) raiseUsage("cells and grid exclude each other");
  grid.cells = cells.value_or(0.0);
  grid.spacing = spacing.value_or(0.0);
  const auto mode = choice(
      options, "grid_mode",
      [](const std::string& word) {
        return word == "quad"   ? std::optional(GridMode::kQuad)
               : word == "tile" ? std::optional(GridMode::kTile)
                                : std::nullopt;
      },
      "'tile' or 'quad'");
  if (mode && !grid.isAsked()) raiseUsage("grid_mode needs cells or grid");
  grid.mode = mode.value_or(GridMode::kTile);
  return grid;
}

std::optional<ImproveOptions> toImprove(const py::dict& options) {
  if (!options.contains("improve")) return std::nullopt;
  const py::object value = options["improve"];
  if (value.is_none() || value.is(py::bool_(false))) return std::nullopt;
  ImproveOptions improve;
  const bool isWord = py::isinstance<py::str>(value);
  const std::optional<double> balance = isWord
                                            ? api::improveBalance(value.cast<std::string>())
                                            : std::optional(get<double>(options, "improve", 0.0));
  if (!balance || !(*balance >= -1 && *balance <= 1)) {
    refuse("improve", py::cast<std::string>(py::repr(value)),
           "'isometric', 'conformal', 'area' or a number from -1 to 1");
  }
  improve.balance = *balance;
  return improve;
}

io::Prescription read(const std::string& shown, const std::string& name, std::string_view text,
                      std::optional<int> q) {
  Result<io::Prescription> made = api::readPrescription(name, text, q.value_or(4));
  if (!made) {
    Failure failure = made.error();
    failure.message = shown + ": " + failure.message;
    raise(failure);
  }
  if (q && made->q != *q)
    raiseUsage(formatText("q=%d contradicts %s, which has q = %d", *q, shown.c_str(), made->q));
  return std::move(*made);
}

/// The file of this path, as the command line reads it.
std::optional<io::Prescription> fileOf(const py::dict& asked, const char* key,
                                       std::optional<int> q) {
  const std::optional<std::string> path = find<std::string>(asked, key);
  if (!path) return std::nullopt;
  const io::Bytes bytes = must(cli::readFile(*path, io::Limits().maxBytes));
  const bool isPacked = path->size() > 3 && path->compare(path->size() - 3, 3, ".gz") == 0;
  return read(*path, path->substr(0, path->size() - (isPacked ? 3 : 0)),
              {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, q);
}

using Pairs = std::vector<std::pair<int, int>>;

std::optional<Pairs> pairsOf(const py::dict& asked, const char* key) {
  if (!asked.contains(key) || py::object(asked[key]).is_none()) return std::nullopt;
  return py::object(asked[key]).cast<Pairs>();
}

}  // namespace

api::LoadOptions toLoadOptions(const py::dict& options) {
  api::LoadOptions o;
  o.surface = get<int>(options, "surface", o.surface);
  o.weld = get<double>(options, "weld", o.weld);
  o.target = get<std::string>(options, "target", "");
  if (options.contains("fix") && !py::object(options["fix"]).is_none()) {
    o.isStrict = true;  // if repairs are named, even none of them, exactly those are made
    for (const std::string& word : py::object(options["fix"]).cast<std::vector<std::string>>()) {
      if (word == "orient")
        o.fix.orient = true;
      else if (word == "split")
        o.fix.split = true;
      else if (word == "degenerate")
        o.fix.degenerate = true;
      else
        refuse("fix", "'" + word + "'", "a list of 'orient', 'split' and 'degenerate'");
    }
  }
  o.isStrict = o.isStrict || get<bool>(options, "strict", false);
  o.writesRepairs = get<bool>(options, "write_repairs", o.writesRepairs);
  o.limits.maxBytes = get<std::uint64_t>(options, "max_bytes", o.limits.maxBytes);
  o.limits.maxTriangles = get<std::uint64_t>(options, "max_triangles", o.limits.maxTriangles);
  return o;
}

api::SolveOptions toSolveOptions(const py::dict& options) {
  api::SolveOptions o;
  o.q = orderOf(options).value_or(o.q);
  o.coneCount = checked<int>(
                    options, "count", [](int n) { return n >= 0; }, "at least 0")
                    .value_or(o.coneCount);
  o.conesFor = choice(
                   options, "cones_for", [](const std::string& w) { return conesForNamed(w); },
                   "'balanced', 'few' or 'low-distortion'")
                   .value_or(o.conesFor);
  o.alignToCurvature = get<bool>(options, "align_to_curvature", o.alignToCurvature);
  const auto isConvex = choice(
      options, "boundary",
      [](const std::string& word) {
        return word == "free" || word == "convex" ? std::optional(word == "convex") : std::nullopt;
      },
      "'free' or 'convex'");
  if (isConvex.value_or(false)) o.boundary = api::BoundaryKind::kConvex;
  o.maxRounds =
      checked<int>(
          options, "max_rounds", [](int n) { return n >= 1 && n <= 1000; }, "from 1 to 1000")
          .value_or(o.maxRounds);
  o.method = choice(
                 options, "method", [](const std::string& w) { return methodNamed(w); },
                 "'auto', 'harmonic', 'soft', 'printed' or 'all-frames'")
                 .value_or(o.method);
  o.improve = toImprove(options);
  const auto areOfFile = choice(
      options, "frames",
      [](const std::string& word) {
        return word == "auto" || word == "file" ? std::optional(word == "file") : std::nullopt;
      },
      "'auto' or 'file'");
  if (areOfFile.value_or(false)) o.frames = api::FrameSource::kFile;
  o.scale = choice(
                options, "scale",
                [](const std::string& word) {
                  return word == "solved" ? std::optional(api::Scale::kSolved)
                         : word == "unit" ? std::optional(api::Scale::kUnit)
                         : word == "fit"  ? std::optional(api::Scale::kFit)
                                          : std::nullopt;
                },
                "'solved', 'unit' or 'fit'")
                .value_or(o.scale);
  o.keepsGoing = get<bool>(options, "keep_going", o.keepsGoing);
  o.refines = get<bool>(options, "refine", o.refines);
  o.grid = toGrid(options);
  if (o.grid.isAsked() && o.scale != api::Scale::kSolved)
    raiseUsage("scale 'unit' and 'fit' would undo a grid: one cell is one unit of uv");
  return o;
}

api::VerifyOptions toVerifyOptions(const py::dict& options) {
  api::VerifyOptions o;
  o.q = orderOf(options).value_or(0);
  o.uvSet = get<int>(options, "uv_set", o.uvSet);
  o.tolerance = get<double>(options, "tolerance", o.tolerance);
  return o;
}

std::optional<io::Prescription> toPrescription(const py::dict& asked,
                                               std::optional<io::Prescription> embedded) {
  const std::optional<int> q = orderOf(asked);
  std::optional<io::Prescription> out = fileOf(asked, "field", q);
  std::optional<io::Prescription> cones = fileOf(asked, "cones_file", q);
  if (const auto text = find<std::string>(asked, "cones_text"))
    cones = read("cones", "cones.json", *text, q);
  if (cones) {
    if (out) cones = must(api::withField(std::move(*cones), std::move(*out)));
    out = std::move(cones);
  }
  const std::optional<Pairs> pairs = pairsOf(asked, "cones"), turning = pairsOf(asked, "turning"),
                             handles = pairsOf(asked, "handles");
  const bool isTyped = pairs || turning || handles;
  if (!out && !isTyped && embedded && !get<bool>(asked, "ignore_embedded", false) &&
      (!q || *q == embedded->q)) {
    out = std::move(embedded);
    out->notes.emplace_back("cones-of-input");
  }
  if (!out && isTyped) {
    out.emplace();
    out->q = q.value_or(4);
    out->hasCones = true;
  }
  if (!out) return out;
  if (pairs) {
    out->hasCones = true;
    for (const auto& [v, k] : *pairs) out->cones.push_back({v, k, std::nullopt});
  }
  for (const auto& [loop, l] : turning.value_or(Pairs())) out->boundaries.push_back({loop, l, -1});
  for (const auto& [g, r] : handles.value_or(Pairs())) out->handles.push_back({g, r});
  return out;
}

}  // namespace hgp::python

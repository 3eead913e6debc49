#include "options.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "../../examples/cli/files.h"
#include "failures.h"
#include "hgp/api/options_from_json.h"
#include "hgp/api/session.h"
#include "hgp/base/check.h"
#include "hgp/prescription/feature_files.h"

namespace hgp::python {
namespace {

/// The options as JSON with the names of Python, read by the core's table.
template <class Options>
Options optionsOf(const py::dict& options) {
  const py::object text = py::module_::import("hgp._options").attr("json_of")(options);
  Result<Options> made =
      api::optionsFromJson<Options>(text.cast<std::string>(), api::Spelling::kPython);
  if (!made && made.error().stage == "type") throw py::type_error(made.error().message);
  return must(std::move(made));
}

std::optional<std::string> textOf(const py::dict& options, const char* name) {
  if (!options.contains(name)) return std::nullopt;
  return py::object(options[name]).cast<std::optional<std::string>>();
}

bool has(const py::dict& asked, const char* name) {
  return asked.contains(name) && !py::object(asked[name]).is_none();
}

/// The bytes of this file, gzip decompressed, and its name without .gz.
std::pair<io::Bytes, std::string> bytesOf(const std::string& path) {
  const bool isPacked = path.size() > 3 && path.compare(path.size() - 3, 3, ".gz") == 0;
  return {must(cli::readFile(path, io::Limits().maxBytes)),
          path.substr(0, path.size() - (isPacked ? 3 : 0))};
}

std::vector<prescription::FeatureMark> marksOf(const std::vector<std::string>& words) {
  if (words.empty()) return {};
  auto marks = prescription::featureMarksNamed(words);
  if (!marks) {
    const auto isKnown = [](const std::string& word) {
      return prescription::featureMarksNamed({word}).has_value();
    };
    raiseUsage("marked must be of 'lines', 'smoothing', 'materials' and 'normals', not '" +
               *std::find_if_not(words.begin(), words.end(), isKnown) + "'");
  }
  return std::move(*marks);
}

/// A list of features from a file, or from rows of two vertices.
std::optional<prescription::PrescribedFeatures> listOf(const py::dict& asked) {
  std::string shown = "features", name = "features.txt", text;
  if (const auto path = textOf(asked, "features")) {
    shown = *path;
    io::Bytes bytes;
    std::tie(bytes, name) = bytesOf(*path);
    text.assign(bytes.begin(), bytes.end());
  } else if (auto rows = textOf(asked, "features_text")) {
    text = std::move(*rows);
  } else {
    return std::nullopt;
  }
  Result<prescription::PrescribedFeatures> read = api::readFeatures(name, text);
  if (!read) {
    Failure failure = read.error();
    failure.message = shown + ": " + failure.message;
    raise(failure);
  }
  return std::move(*read);
}

void addFeatures(const py::dict& asked, prescription::PrescribedFeatures& features) {
  prescription::PrescribedFeatures given;
  given.hasRims = isSet(asked, "rims");
  if (has(asked, "creases")) given.creaseDegrees = asked["creases"].cast<double>();
  if (has(asked, "marked")) given.marks = marksOf(asked["marked"].cast<std::vector<std::string>>());
  prescription::addFeatures(features, listOf(asked), given);
}

prescription::Prescription read(const std::string& shown, const std::string& name,
                                std::string_view text, std::optional<int> q) {
  Result<prescription::Prescription> made = api::readPrescription(name, text, q.value_or(4));
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
std::optional<prescription::Prescription> fileOf(const py::dict& asked, const char* key,
                                                 std::optional<int> q) {
  const std::optional<std::string> path = textOf(asked, key);
  if (!path) return std::nullopt;
  const auto [bytes, name] = bytesOf(*path);
  return read(*path, name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, q);
}

using Pairs = std::vector<std::pair<int, int>>;

std::optional<Pairs> pairsOf(const py::dict& asked, const char* key) {
  if (!asked.contains(key) || py::object(asked[key]).is_none()) return std::nullopt;
  return py::object(asked[key]).cast<Pairs>();
}

}  // namespace

bool isSet(const py::dict& options, const char* name) {
  return options.contains(name) && options[name].cast<bool>();
}

std::optional<int> orderOf(const py::dict& asked) {
  if (!asked.contains("q") || py::object(asked["q"]).is_none()) return std::nullopt;
  py::dict alone;
  alone["q"] = asked["q"];
  return optionsOf<api::SolveOptions>(alone).q;
}

api::LoadOptions toLoadOptions(const py::dict& options) {
  return optionsOf<api::LoadOptions>(options);
}
api::SolveOptions toSolveOptions(const py::dict& options) {
  return optionsOf<api::SolveOptions>(options);
}
api::VerifyOptions toVerifyOptions(const py::dict& options) {
  return optionsOf<api::VerifyOptions>(options);
}
api::WriteOptions toWriteOptions(const py::dict& options) {
  return optionsOf<api::WriteOptions>(options);
}

prescription::PrescribedFeatures toFeatures(const py::dict& asked) {
  prescription::PrescribedFeatures features;
  addFeatures(asked, features);
  return features;
}

std::optional<prescription::Prescription> toPrescription(
    const py::dict& asked, std::optional<prescription::Prescription> embedded) {
  const std::optional<int> q = orderOf(asked);
  std::optional<prescription::Prescription> out = fileOf(asked, "field", q);
  std::optional<prescription::Prescription> cones = fileOf(asked, "cones_file", q);
  if (const auto text = textOf(asked, "cones_text")) cones = read("cones", "cones.json", *text, q);
  if (cones) {
    if (out) cones = must(api::withField(std::move(*cones), std::move(*out)));
    out = std::move(cones);
  }
  const std::optional<Pairs> pairs = pairsOf(asked, "cones"), turning = pairsOf(asked, "turning"),
                             handles = pairsOf(asked, "handles");
  const bool isTyped = pairs || turning || handles;
  const bool hasFeatures = isSet(asked, "rims") || has(asked, "creases") || has(asked, "marked") ||
                           has(asked, "features") || has(asked, "features_text");
  if (!out && !isTyped && !hasFeatures && embedded && !isSet(asked, "ignore_embedded") &&
      (!q || *q == embedded->q)) {
    out = std::move(embedded);
    out->notes.emplace_back("cones-of-input");
  }
  if (!out && (isTyped || hasFeatures)) {
    out.emplace();
    out->q = q.value_or(4);
    out->hasCones = isTyped;
  }
  if (!out) return out;
  if (pairs) {
    out->hasCones = true;
    for (const auto& [v, k] : *pairs) out->cones.push_back({v, k, std::nullopt});
  }
  for (const auto& [loop, l] : turning.value_or(Pairs())) out->boundaries.push_back({loop, l, -1});
  for (const auto& [g, r] : handles.value_or(Pairs())) out->handles.push_back({g, r});
  addFeatures(asked, out->features);
  return out;
}

}  // namespace hgp::python

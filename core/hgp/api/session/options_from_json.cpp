#include "hgp/api/options_from_json.h"

#include <set>

#include "hgp/api/json/given_options.h"
#include "hgp/api/option_words.h"
#include "hgp/api/session/guard.h"

namespace hgp::api {
namespace {

template <class Options>
Result<GivenOptions> givenOptions(std::string_view json, Spelling spelling) {
  return GivenOptions::read(json, optionRows<Options>(), spelling);
}

FixOptions fixesOf(const OptionJson& words) {
  std::set<std::string> named;
  for (const auto& item : words.items()) {
    if (words.is_array())
      named.insert(item.value().get<std::string>());
    else if (item.value().get<bool>())
      named.insert(item.key());
  }
  FixOptions fix;
  fix.orient = named.count("orient") > 0;
  fix.split = named.count("split") > 0;
  fix.degenerate = named.count("degenerate") > 0;
  return fix;
}

Result<SolveOptions> solveOptions(const GivenOptions& given) {
  SolveOptions o;
  given.read("q", o.q);
  given.read("count", o.coneCount);
  o.conesFor = conesForNamed(given.word("conesFor", "balanced")).value_or(o.conesFor);
  given.read("alignToCurvature", o.alignToCurvature);
  o.boundary = boundaryNamed(given.word("boundary", "free")).value_or(o.boundary);
  given.read("maxRounds", o.maxRounds);
  o.method = methodNamed(given.word("method", "auto")).value_or(o.method);
  o.frames = framesNamed(given.word("frames", "auto")).value_or(o.frames);
  o.scale = scaleNamed(given.word("scale", "solved")).value_or(o.scale);
  if (given.isSet("quality")) o.improve.emplace();
  if (const OptionJson& value = given.at("improve"); !value.is_null()) {
    o.improve.emplace().balance = value.is_string()
                                      ? improveBalance(value.get<std::string>()).value_or(0.0)
                                      : value.get<double>();
  }
  given.read("keepGoing", o.keepsGoing);
  given.read("refine", o.refines);
  given.read("convexPolygons", o.convexPolygons);
  given.read("grid.cells", o.grid.cells);
  given.read("grid.spacing", o.grid.spacing);
  o.grid.mode = gridModeNamed(given.word("grid.mode", "tile")).value_or(o.grid.mode);
  o.choosesCells = given.has("grid.mode") && !o.grid.isAsked();
  o.symmetry = symmetryNamed(given.word("symmetric", "")).value_or(o.symmetry);
  if (given.has("grid.cells") && given.has("grid.spacing"))
    return given.contradiction("grid.cells", "grid.spacing", "exclude each other");
  const char* grid = given.has("grid.cells")     ? "grid.cells"
                     : given.has("grid.spacing") ? "grid.spacing"
                                                 : "grid.mode";
  if ((o.grid.isAsked() || o.choosesCells) && o.scale != Scale::kSolved)
    return given.contradiction("scale", grid,
                               "exclude each other: 'unit' and 'fit' would undo a grid, in which "
                               "one cell is one unit of uv");
  return o;
}

}  // namespace

template <>
Result<LoadOptions> optionsFromJson(std::string_view json, Spelling spelling) {
  return guarded([&]() -> Result<LoadOptions> {
    const Result<GivenOptions> given = givenOptions<LoadOptions>(json, spelling);
    if (!given) return given.error();
    LoadOptions o;
    given->read("surface", o.surface);
    if (const OptionJson& weld = given->at("weld"); !weld.is_null())
      o.weld = weld.is_number() ? weld.get<double>()
                                : weldNamed(weld.get<std::string>()).value_or(o.weld);
    given->read("limits.bytes", o.limits.maxBytes);
    given->read("limits.triangles", o.limits.maxTriangles);
    const bool isNamed = given->has("fix");
    if (isNamed) o.fix = fixesOf(given->at("fix"));
    if (given->isSet("strict") && o.fix.isAny())
      return given->contradiction(
          "strict", "fix", "exclude each other: 'strict' makes no repairs; leave out either");
    o.isStrict = given->isSet("strict") || (isNamed && !o.fix.isAny());
    given->read("writeRepairs", o.writesRepairs);
    given->read("target", o.target);
    return o;
  });
}

template <>
Result<SolveOptions> optionsFromJson(std::string_view json, Spelling spelling) {
  return guarded([&]() -> Result<SolveOptions> {
    const Result<GivenOptions> given = givenOptions<SolveOptions>(json, spelling);
    if (!given) return given.error();
    return solveOptions(*given);
  });
}

template <>
Result<VerifyOptions> optionsFromJson(std::string_view json, Spelling spelling) {
  return guarded([&]() -> Result<VerifyOptions> {
    const Result<GivenOptions> given = givenOptions<VerifyOptions>(json, spelling);
    if (!given) return given.error();
    VerifyOptions o;
    given->read("q", o.q);
    given->read("uvSet", o.uvSet);
    given->read("tolerance", o.tolerance);
    return o;
  });
}

template <>
Result<WriteOptions> optionsFromJson(std::string_view json, Spelling spelling) {
  return guarded([&]() -> Result<WriteOptions> {
    const Result<GivenOptions> given = givenOptions<WriteOptions>(json, spelling);
    if (!given) return given.error();
    WriteOptions o;
    given->read("uvSet", o.uvSet);
    given->read("name", o.name);
    o.format = mapFormatNamed(given->word("format", "same")).value_or(o.format);
    if (const OptionJson& tiles = given->at("gridMaterial"); tiles.is_number())
      o.gridTiles = tiles.get<double>();
    else if (given->isSet("gridMaterial"))
      o.gridTiles = 0.0;
    given->read("embedCones", o.embedCones);
    given->read("allowUncertified", o.allowUncertified);
    if (given->has("use")) o.pointsMaterials = given->isSet("use");
    return o;
  });
}

}  // namespace hgp::api

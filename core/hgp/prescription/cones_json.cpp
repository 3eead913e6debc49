#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "hgp/base/check.h"
#include "hgp/prescription/cones.h"
#include "hgp/text/text.h"

namespace hgp::prescription {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxDepth = 64;
constexpr std::size_t kMaxJson = std::size_t{64} << 20;

/// Reads members and records the first error.
class Members {
 public:
  explicit Members(std::string path) : path_(std::move(path)) {}

  /// Reads an integer; false if it is absent, which is an error only if it is required, or wrong.
  bool integer(const Json& object, const char* key, int& out, bool isRequired) {
    const auto it = object.find(key);
    if (it == object.end()) return isRequired ? wrong(key, "is missing") : false;
    if (!it->is_number_integer()) return wrong(key, "must be an integer");
    const bool isSmall = it->is_number_unsigned() ? it->get<std::uint64_t>() <= INT32_MAX
                                                  : it->get<std::int64_t>() >= INT32_MIN;
    if (!isSmall) return wrong(key, "is out of range");
    out = it->get<int>();
    return true;
  }

  bool position(const Json& object, std::optional<Vec3>& out) {
    const auto it = object.find("position");
    if (it == object.end() || it->is_null()) return false;
    if (!it->is_array() || it->size() != 3) return wrong("position", "must be three numbers");
    Vec3 p{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(*it)[k].is_number()) return wrong("position", "must be three numbers");
      p[k] = (*it)[k].get<double>();
    }
    out = p;
    return true;
  }

  /// A list of objects, or null.
  const Json* list(const Json& object, const char* key) {
    const auto it = object.find(key);
    if (it == object.end() || it->is_null()) return nullptr;
    if (!it->is_array()) {
      wrong(key, "must be a list");
      return nullptr;
    }
    if (it->size() > static_cast<std::size_t>(kMaxCones)) wrong(key, "has too many entries");
    for (const Json& entry : *it) {
      if (!entry.is_object()) wrong(key, "must hold objects");
    }
    return message_.empty() ? &*it : nullptr;
  }

  void enter(const char* key, std::size_t i) { path_ = formatText("/%s/%zu", key, i); }
  bool wrong(const char* key, const char* what) {
    if (message_.empty()) message_ = path_ + "/" + key + " " + what;
    return false;
  }
  bool isFine() const { return message_.empty(); }
  Failure failure() const {
    return {ErrorCode::kMalformed, "cones", "cones JSON: " + message_, {}};
  }

 private:
  std::string path_, message_;
};

void readHeader(const Json& json, Members& m, Prescription& out) {
  if (const auto format = json.find("format"); format != json.end() && *format != "hgp-cones") {
    m.wrong("format", "must be \"hgp-cones\"");
  }
  int version = 1;
  if (m.integer(json, "version", version, false) && version != 1) {
    m.wrong("version", "must be 1; this file is from a newer program");
  }
  m.integer(json, "q", out.q, true);
  const auto mesh = json.find("mesh");
  if (mesh == json.end() || !mesh->is_object()) return;
  m.integer(*mesh, "vertices", out.vertexCount, false);
  m.integer(*mesh, "triangles", out.triangleCount, false);
  const auto sha = mesh->find("sha256");
  if (sha != mesh->end() && sha->is_string()) out.sha256 = sha->get<std::string>();
}

void readLists(const Json& json, Members& m, Prescription& out) {
  if (const Json* cones = m.list(json, "cones")) {
    out.hasCones = true;
    for (std::size_t i = 0; i < cones->size(); ++i) {
      m.enter("cones", i);
      PrescribedCone cone;
      m.integer((*cones)[i], "vertex", cone.vertex, true);
      m.integer((*cones)[i], "k", cone.k, true);
      m.position((*cones)[i], cone.position);
      m.integer((*cones)[i], "triangle", cone.triangle, false);
      out.cones.push_back(cone);
    }
  }
  if (const Json* boundaries = m.list(json, "boundaries")) {
    for (std::size_t i = 0; i < boundaries->size(); ++i) {
      m.enter("boundaries", i);
      PrescribedTurning turning;
      m.integer((*boundaries)[i], "loop", turning.loop, true);
      m.integer((*boundaries)[i], "l", turning.l, true);
      m.integer((*boundaries)[i], "anchor", turning.anchor, false);
      out.boundaries.push_back(turning);
    }
  }
  if (const Json* handles = m.list(json, "handles")) {
    for (std::size_t i = 0; i < handles->size(); ++i) {
      m.enter("handles", i);
      PrescribedHandle handle;
      m.integer((*handles)[i], "generator", handle.generator, true);
      m.integer((*handles)[i], "r", handle.r, true);
      out.handles.push_back(handle);
    }
  }
}

void readLine(const Json& entry, Members& m, PrescribedLine& line) {
  const auto vertices = entry.find("vertices");
  if (vertices == entry.end() || !vertices->is_array() || vertices->size() < 2) {
    m.wrong("vertices", "must be a list of at least two vertices");
    return;
  }
  for (const Json& v : *vertices) {
    if (!v.is_number_integer() || v < 0 || v > INT32_MAX) {
      m.wrong("vertices", "must hold vertices from 0");
      return;
    }
    line.vertices.push_back(v.get<int>());
    if (line.vertices.size() > 1 && line.vertices.back() == line.vertices.rbegin()[1])
      m.wrong("vertices", "names a vertex twice in succession");
  }
  const auto positions = entry.find("positions");
  if (positions == entry.end() || positions->is_null()) return;
  const auto isPoint = [](const Json& p) {
    return p.is_array() && p.size() == 3 && p[0].is_number() && p[1].is_number() &&
           p[2].is_number();
  };
  if (!positions->is_array() || positions->size() != vertices->size() ||
      !std::all_of(positions->begin(), positions->end(), isPoint)) {
    m.wrong("positions", "must be three numbers per vertex");
    return;
  }
  for (const Json& p : *positions) line.positions.push_back(p.get<Vec3>());
}

void readMarks(const Json& list, Members& m, PrescribedFeatures& out) {
  if (!list.is_array()) m.wrong("marked", "must be a list of words");
  for (const Json& word : list) {
    const auto* found = std::find_if(
        std::begin(kFeatureMarks), std::end(kFeatureMarks),
        [&](const char* name) { return word.is_string() && word.get<std::string>() == name; });
    if (found == std::end(kFeatureMarks))
      m.wrong("marked", "must hold \"lines\", \"smoothing\", \"materials\" or \"normals\"");
    else
      out.marks.push_back(static_cast<FeatureMark>(found - std::begin(kFeatureMarks)));
  }
}

void readFeatureLines(const Json& json, Members& m, Prescription& out) {
  const auto features = json.find("features");
  if (features == json.end() || features->is_null()) return;
  if (!features->is_object()) {
    m.wrong("features", "must be an object");
    return;
  }
  const auto rims = features->find("rims");
  if (rims != features->end() && !rims->is_boolean()) m.wrong("rims", "must be true or false");
  out.features.hasRims = rims != features->end() && rims->is_boolean() && rims->get<bool>();
  const auto creases = features->find("creases");
  if (creases != features->end()) {
    const bool isAngle = creases->is_number() && *creases > 0 && *creases < 180;
    if (isAngle)
      out.features.creaseDegrees = creases->get<double>();
    else
      m.wrong("creases", "must be an angle between 0 and 180 degrees");
  }
  const auto marks = features->find("marked");
  if (marks != features->end()) readMarks(*marks, m, out.features);
  const Json* lines = m.list(*features, "lines");
  for (std::size_t i = 0; lines && i < lines->size(); ++i) {
    m.enter("features/lines", i);
    readLine((*lines)[i], m, out.features.lines.emplace_back());
  }
}

void readMatchings(const Json& json, Members& m, Prescription& out) {
  const Json* matchings = m.list(json, "matchings");
  if (!matchings) return;
  out.field.emplace();
  out.field->order = out.q;
  out.field->hasMatchings = true;
  for (std::size_t i = 0; i < matchings->size(); ++i) {
    m.enter("matchings", i);
    Matching matching;
    m.integer((*matchings)[i], "from", matching.from, true);
    m.integer((*matchings)[i], "to", matching.to, false);
    m.integer((*matchings)[i], "tail", matching.tail, true);
    m.integer((*matchings)[i], "head", matching.head, true);
    m.integer((*matchings)[i], "turn", matching.turn, true);
    out.field->matchings.push_back(matching);
  }
}

}  // namespace

Result<Prescription> readConesJson(std::string_view text) {
  if (text.size() > kMaxJson || text::isNestedDeeper(text, kMaxDepth)) {
    return Failure{ErrorCode::kLimit, "cones", "cones JSON: too large or nested too deep", {}};
  }
  const Json json = Json::parse(text.begin(), text.end(), nullptr, false);
  if (json.is_discarded() || !json.is_object()) {
    return Failure{ErrorCode::kMalformed, "cones", "cones JSON: not a JSON object", {}};
  }
  Members members("");
  Prescription out;
  readHeader(json, members, out);
  readLists(json, members, out);
  readMatchings(json, members, out);
  readFeatureLines(json, members, out);
  if (!members.isFine()) return members.failure();
  return out;
}

/// The array of cones as dump(indent) gives it inside the document. Each cone becomes text on its own: as a tree, the cones of
/// ten thousand components take several times their text.
static std::string coneList(const std::vector<PrescribedCone>& cones, int indent) {
  const auto lineOf = [indent](int levels) {
    return indent < 0 ? std::string()
                      : "\n" + std::string(static_cast<std::size_t>(levels * indent), ' ');
  };
  const std::string between = lineOf(2);
  std::string out = "[";
  for (const PrescribedCone& c : cones) {
    Json cone{{"vertex", c.vertex}, {"k", c.k}};
    if (c.position) cone["position"] = *c.position;
    if (c.triangle >= 0) cone["triangle"] = c.triangle;
    if (out.size() > 1) out += ',';
    out += between;
    for (const char letter : cone.dump(indent)) {
      if (letter == '\n')
        out += between;
      else
        out += letter;
    }
  }
  return out + lineOf(1) + "]";
}

std::string writeConesJson(const Prescription& p, int indent) {
  Json json{{"format", "hgp-cones"}, {"version", 1}, {"q", p.q}};
  if (p.vertexCount >= 0 || !p.sha256.empty()) {
    Json& mesh = json["mesh"] = Json::object();
    if (p.vertexCount >= 0) mesh["vertices"] = p.vertexCount;
    if (p.triangleCount >= 0) mesh["triangles"] = p.triangleCount;
    if (!p.sha256.empty()) mesh["sha256"] = p.sha256;
  }
  // A list of features alone leaves the cones open.
  if (p.hasCones || p.features.isEmpty() || !p.cones.empty()) json["cones"] = Json::array();
  if (!p.boundaries.empty()) json["boundaries"] = Json::array();
  for (const PrescribedTurning& t : p.boundaries) {
    Json loop{{"loop", t.loop}, {"l", t.l}};
    if (t.anchor >= 0) loop["anchor"] = t.anchor;
    json["boundaries"].push_back(std::move(loop));
  }
  if (!p.handles.empty()) json["handles"] = Json::array();
  for (const PrescribedHandle& h : p.handles) {
    json["handles"].push_back(Json{{"generator", h.generator}, {"r", h.r}});
  }
  if (!p.features.isEmpty()) {
    Json& features = json["features"] = Json::object();
    if (p.features.hasRims) features["rims"] = true;
    if (p.features.creaseDegrees) features["creases"] = *p.features.creaseDegrees;
    for (const FeatureMark mark : p.features.marks)
      features["marked"].push_back(kFeatureMarks[static_cast<int>(mark)]);
    Json& lines = features["lines"] = Json::array();
    for (const PrescribedLine& line : p.features.lines) {
      Json entry{{"vertices", line.vertices}};
      if (!line.positions.empty()) entry["positions"] = line.positions;
      lines.push_back(std::move(entry));
    }
  }
  if (p.field && p.field->hasMatchings) {
    Json& matchings = json["matchings"] = Json::array();
    for (const Matching& m : p.field->matchings) {
      matchings.push_back(Json{
          {"from", m.from}, {"to", m.to}, {"tail", m.tail}, {"head", m.head}, {"turn", m.turn}});
    }
  }
  std::string text =
      json.dump(indent, ' ', false, Json::error_handler_t::replace) + (indent < 0 ? "" : "\n");
  const std::string empty = indent < 0 ? R"("cones":[])" : R"("cones": [])";
  if (!p.cones.empty())
    text.replace(text.find(empty) + empty.size() - 2, 2, coneList(p.cones, indent));
  return text;
}

}  // namespace hgp::prescription

// Files with one thing wrong: cut off anywhere, and with any word or value taken out or replaced.
#include <cstring>
#include <nlohmann/json.hpp>

#include "hgp/api/options_from_json.h"
#include "hgp/base/check.h"
#include "hgp/prescription/cones.h"
#include "recorded/recorder.h"

namespace hgp::recorded {
namespace {

using Json = nlohmann::json;

/// What became of many files: how many were read, and all of it in one hash.
struct Outcomes {
  int good = 0, bad = 0;
  std::string all;

  void add(const Failure& failure) {
    ++bad;
    all += errorName(failure.code) + failure.message;
    for (const Where& place : failure.where)
      all += formatText("@%lld", static_cast<long long>(place.id));
  }
  void add(const std::string& result) {
    ++good;
    all += result;
  }
  void put(Recorder& r) const {
    r.fact("read", good);
    r.fact("refused", bad);
    r.text("outcomes", all);
  }
};

void load(Outcomes& out, const std::string& name, const std::string& text) {
  io::FileSet files;
  files.name = name;
  files.main.assign(text.begin(), text.end());
  files.resolve = [](const std::string& side) -> Result<io::Bytes> {
    return Failure{ErrorCode::kMalformed, "read", side, {}};
  };
  api::Session session;
  if (const Status done = session.load(std::move(files), {}); !done) return out.add(done.error());
  const Result<api::Verdict> inspected = session.inspect();
  if (!inspected) return out.add(inspected.error());
  Json json = Json::parse(inspected->json);
  json.erase("seconds");
  std::string positions;
  for (double x : session.positions()) positions += formatText(" %.9g", x);
  out.add(positions + (inspected->isGood ? "usable" : "unusable") + json["notes"].dump());
}

const std::vector<std::string>& replacements() {
  static const std::vector<std::string> all = {"",      "-1",       "0",  "x",
                                               "1e999", "99999999", "\"", "3.5"};
  return all;
}

/// Each word of the first `size` characters, replaced by others.
std::vector<std::string> withWords(const std::string& text, std::size_t size) {
  std::vector<std::string> all;
  const auto isWord = [&](std::size_t i) { return std::strchr(" \n\t,", text[i]) == nullptr; };
  for (std::size_t begin = 0; begin < size; ++begin) {
    if (!isWord(begin) || (begin > 0 && isWord(begin - 1))) continue;
    std::size_t end = begin;
    while (end < size && isWord(end)) ++end;
    for (const std::string& word : replacements())
      all.push_back(text.substr(0, begin) + word + text.substr(end));
  }
  return all;
}

std::vector<std::string> cutOff(const std::string& text, std::size_t step) {
  std::vector<std::string> all;
  for (std::size_t size = 0; size < text.size(); size += step) all.push_back(text.substr(0, size));
  return all;
}

void wrong(Recorder& r, const std::string& name, const std::string& text) {
  const bool isBinary = name[0] != 'a';
  const std::size_t header = text.find("end_header");
  Outcomes out;
  const std::size_t words = !isBinary || header == std::string::npos ? text.size() : header;
  for (const std::string& one : withWords(text, name == "b.stl" ? 0 : words)) load(out, name, one);
  for (const std::string& one : cutOff(text, 3)) load(out, name, one);
  out.put(r);
}

std::string withJson(const std::string& glb, const std::string& json) {
  const std::string padded = json + std::string((4 - json.size() % 4) % 4, ' ');
  std::uint32_t was = 0;
  std::memcpy(&was, glb.data() + 12, 4);
  std::string out = glb.substr(0, 8);
  const auto number = [&](std::size_t n) {
    const auto word = static_cast<std::uint32_t>(n);
    out.append(reinterpret_cast<const char*>(&word), 4);
  };
  number(glb.size() - was + padded.size());
  number(padded.size());
  return out + glb.substr(16, 4) + padded + glb.substr(20 + was);
}

/// Every value of the JSON replaced, raised, lowered, and every member taken out.
void wrongJson(Recorder& r, const std::string& glb) {
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, 4);
  const std::string text = glb.substr(20, size);
  const Json json = Json::parse(text);
  Outcomes out;
  const Json flat = json.flatten();
  for (const auto& [path, value] : flat.items()) {
    const Json::json_pointer at(path);
    std::vector<Json> others = {-1,  0, 1, 2, 1e300, "x", Json(), Json::array(), Json::object(),
                                true};
    if (value.is_number_integer())
      for (int step : {-1, 1, 3}) others.push_back(value.get<int>() + step);
    for (const Json& other : others) {
      Json changed = json;
      changed[at] = other;
      load(out, "a.glb", withJson(glb, changed.dump()));
    }
    Json without = json;
    Json& parent = without[at.parent_pointer()];
    if (parent.is_object()) parent.erase(at.back());
    load(out, "a.glb", withJson(glb, without.dump()));
  }
  for (const std::string& one : cutOff(text, 7)) load(out, "a.glb", withJson(glb, one));
  for (const char* end : {"\"\\u12", "\"\\ud800\"", "\"\\u00e9\"", "\"\\", "1.", "-", "1e", "tru",
                          "[1,]", "{\"a\"}", "\"\x01\""})
    load(out, "a.glb",
         withJson(glb, "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(end)));
  for (const std::string& one : cutOff(glb, 11)) load(out, "a.glb", one);
  out.put(r);
}

/// Cones, fields and lists of features in the formats of other programs.
void wrongCones(Recorder& r) {
  const std::vector<std::pair<std::string, std::string>> texts = {
      {"c.cones.json",
       R"({"format":"hgp-cones","version":1,"q":6,"cones":[{"vertex":3,"k":5,"position":[0,0.5,1]},{"vertex":9,"k":7,"triangle":2}],"boundaries":[{"loop":0,"l":2,"anchor":4}],"handles":[{"generator":1,"r":3}],"mesh":{"vertices":30,"triangles":56}})"},
      {"f.cones.json",
       R"({"format":"hgp-cones","version":1,"q":4,"features":{"rims":true,"creases":30,"marked":["lines"],"lines":[{"vertices":[1,2,3]}]}})"},
      {"a.cones", "q 4\ncones 3\n1 3\n5 5\n9 3\nmatchings 2\n0 1 0 2\n1 2 1 3\n"},
      {"a.sing", "4 3\n0 1\n7 -1\n12 1\n"},
      {"a.sings", "2 2\n0 1\n7 -1\n"},
      {"a.curv", "3 1.5707963267948966\n8 -1.5707963267948966\n"},
      {"a_Th_hat", "6.283185307179586\n4.71238898038469\n7.853981633974483\n6.283185307179586\n"},
      {"a.rawfield", "4 2\n1 0 0 0 1 0 -1 0 0 0 -1 0\n0 1 0 -1 0 0 0 -1 0 1 0 0\n"},
      {"a.rosy", "2\n4\n1 0 0\n0 1 0\n"},
      {"a.ffield",
       "target_frame\n2\nk1 k2 k1v_x k1v_y k1v_z k2v_x k2v_y k2v_z\n1 1 1 0 0 0 1 0\n1 1 0 1 0 1 0 "
       "0\n"}};
  for (const auto& [name, text] : texts) {
    Outcomes out;
    std::vector<std::string> all = withWords(text, text.size());
    for (std::string& one : cutOff(text, 1)) all.push_back(std::move(one));
    all.push_back(text);
    for (const std::string& one : all) {
      const auto read = api::readPrescription(name, one, 4);
      if (!read) {
        out.add(read.error());
        continue;
      }
      std::string result = prescription::writeConesJson(*read, -1);
      if (read->field) result += formatText("field %zu", read->field->directions.size());
      for (double angle : read->totalAngles) result += formatText(" %.9g", angle);
      out.add(result);
    }
    r.fact("file", name);
    out.put(r);
  }
  const std::vector<std::pair<std::string, std::string>> lists = {
      {"f.sharp", "3\n1,0,2\n0,5,1\n1,4,0\n"},
      {"f.obj", "v 0 0 0\nl 1 2 3\nl 4 5\n"},
      {"f.txt", "0 1\n# no\n\n4 7 # yes\n"}};
  for (const auto& [name, text] : lists) {
    Outcomes out;
    std::vector<std::string> all = withWords(text, text.size());
    for (std::string& one : cutOff(text, 1)) all.push_back(std::move(one));
    for (const std::string& one : all) {
      const auto read = api::readFeatures(name, one);
      if (!read) {
        out.add(read.error());
        continue;
      }
      std::string result;
      for (const auto& line : read->lines)
        for (int v : line.vertices) result += formatText(" %d", v);
      for (const auto& side : read->sides) result += formatText("|%d %d", side[0], side[1]);
      out.add(result);
    }
    r.fact("file", name);
    out.put(r);
  }
}

template <class Options>
void wrongOptions(Outcomes& out, const Json& good) {
  const Json flat = good.flatten();
  for (const auto& [path, value] : flat.items())
    for (const Json& other : {Json(-1), Json(0), Json(1), Json(2.5), Json(1e300), Json("x"),
                              Json(""), Json(true), Json(), Json::array()}) {
      Json changed = good;
      changed[Json::json_pointer(path)] = other;
      const auto read = api::optionsFromJson<Options>(changed.dump());
      if (read)
        out.add("read ");
      else
        out.add(read.error());
    }
}

void options(Recorder& r) {
  Outcomes out;
  wrongOptions<api::LoadOptions>(out, {{"surface", 1},
                                       {"weld", 0.1},
                                       {"limits", {{"bytes", 1000}, {"triangles", 10}}},
                                       {"fix", {"orient"}},
                                       {"target", "glb"},
                                       {"writeRepairs", true},
                                       {"weeld", 1}});
  wrongOptions<api::SolveOptions>(out, {{"q", 6},
                                        {"count", 3},
                                        {"conesFor", "few"},
                                        {"maxRounds", 3},
                                        {"method", "soft"},
                                        {"improve", 0.5},
                                        {"boundary", "free"},
                                        {"scale", "unit"},
                                        {"frames", "auto"}});
  wrongOptions<api::SolveOptions>(out, {{"grid", {{"cells", 100}, {"mode", "quad"}}},
                                        {"alignToCurvature", true},
                                        {"refine", false}});
  wrongOptions<api::VerifyOptions>(out, {{"q", 6}, {"uvSet", 1}, {"tolerance", 0.1}});
  wrongOptions<api::WriteOptions>(out, {{"name", "a.glb"},
                                        {"format", "glb"},
                                        {"gridMaterial", 3},
                                        {"uvSet", 2},
                                        {"embedCones", true},
                                        {"use", true}});
  out.put(r);
}

}  // namespace

std::vector<Scenario> wrongFiles() {
  std::vector<Scenario> all;
  for (const auto& [name, text] : smallFiles()) {
    const std::string file = name, content = text;
    all.push_back({"wrong " + name, [=](Recorder& r) { wrong(r, file, content); }});
  }
  all.push_back({"wrong glb", [](Recorder& r) { wrongJson(r, smallGlb()); }});
  all.push_back({"wrong cones", wrongCones});
  all.push_back({"wrong options", options});
  return all;
}

}  // namespace hgp::recorded

#include "row_json.h"

#include "row_columns.h"

namespace hgp::stress {
namespace {

using Json = nlohmann::json;

constexpr auto eachColumn = [](auto& r, const auto& visit) {
  visit("name", r.name);
  visit("mesh", r.mesh);
  visit("family", r.family);
  visit("reason", r.reason);
  visit("triangles", r.triangles);
  visit("genus", r.genus);
  visit("boundaryLoops", r.loops);
  visit("q", r.q);
  visit("cones", r.cones);
  visit("rounds", r.rounds);
  visit("flipped", r.flipped);
  visit("automatic", r.isAutomatic);
  visit("handlesGiven", r.areHandlesGiven);
  visit("warned", r.isWarned);
  visit("scaleRange", r.scaleRange);
  visit("seconds", r.seconds);
  visit("meanMu", r.meanMu);
  visit("rmsLogArea", r.rmsLogArea);
  visit("symmetricDirichlet", r.symmetricDirichlet);
  visit("method", r.method);
};

}  // namespace

Json toJson(const Row& row) {
  Json out = bench::columnsOf(row, eachColumn);
  out["verdict"] = verdictName(row.verdict);
  return out;
}

Row rowFromJson(const Json& in) {
  Row row;
  bench::readColumns(in, row, eachColumn);
  for (int v = 0; v <= static_cast<int>(Verdict::kCrashed); ++v)
    if (in.at("verdict") == verdictName(static_cast<Verdict>(v)))
      row.verdict = static_cast<Verdict>(v);
  return row;
}

}  // namespace hgp::stress

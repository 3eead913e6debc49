// Values of JavaScript for hgp/lite.  Role: arrays and options in, certificates out.
#pragma once

#include <emscripten/val.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "hgp/api/session/guard.h"
#include "hgp/cones/choose_cones.h"
#include "hgp/improve/improve_options.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/verify/certificate.h"

namespace hgp::js {

/// The options of both calls; wasm/package/src/lib/lite.ts has checked them.
struct LiteOptions {
  int q = 4, count = 0;
  bool hasCones = false;
  std::vector<std::pair<int, int>> cones;  ///< vertex, k
  ConesFor conesFor = ConesFor::kBalanced;
  std::optional<ImproveOptions> improve;
  double tolerance = 0;
  bool isJoined = false;  ///< vertices at equal positions are one
  bool isFloat = false;   ///< the map is stored in single precision
  Progress progress;
};

inline LiteOptions toLiteOptions(const val& options, const val& onProgress) {
  LiteOptions o;
  o.q = option(options, "q", o.q);
  o.count = option(options, "count", o.count);
  o.conesFor = conesForNamed(option(options, "conesFor", std::string())).value_or(o.conesFor);
  const val cones = option(options, "cones", val::undefined());
  o.hasCones = !cones.isUndefined();
  if (o.hasCones) {
    const std::vector<int> flat = toVector<int>(cones);
    for (std::size_t i = 0; i + 1 < flat.size(); i += 2) o.cones.emplace_back(flat[i], flat[i + 1]);
  }
  const val balance = option(options, "improve", val::undefined());
  if (!balance.isUndefined()) o.improve.emplace().balance = balance.as<double>();
  o.tolerance = option(options, "tolerance", o.tolerance);
  o.isJoined = option(options, "join", o.isJoined);
  o.isFloat = option(options, "float", o.isFloat);
  o.progress = toProgress(onProgress);
  return o;
}

inline MeshData toMeshData(const val& mesh) {
  return {toRows<Vec3>(toVector<double>(mesh["positions"])),
          toRows<std::array<int, 3>>(toVector<int>(mesh["triangles"]))};
}

inline UvMap toUvMap(const val& mesh) {
  UvMap map;
  const std::vector<double> uv = toVector<double>(mesh["uv"]);
  for (std::size_t i = 0; i + 1 < uv.size(); i += 2) map.uv.push_back({uv[i], uv[i + 1]});
  map.cornerUv = toRows<std::array<int, 3>>(toVector<int>(mesh["cornerToUv"]));
  return map;
}

inline val failedLite(const Failure& failure) {
  val error = val::object();
  error.set("code", std::string(errorName(failure.code)));
  error.set("stage", failure.stage);
  error.set("message", failure.message);
  error.set("where", val::array());
  val reply = val::object();
  reply.set("error", val::global("JSON").call<std::string>("stringify", error));
  return reply;
}

template <class Call>
val guardedLite(const Call& call) {
  try {
    return call();
  } catch (...) {
    return failedLite(api::caughtFailure());
  }
}

/// { certified, q, components: [{ certified, triangles, positive, genus, boundaries, cones, reasons }] }
/// @param vertices  per certificate, its vertex → that of the surface
inline val toCertificate(const std::vector<Certificate>& certificates,
                         const std::vector<std::vector<int>>& vertices) {
  val out = val::object(), components = val::array();
  for (std::size_t p = 0; p < certificates.size(); ++p) {
    const Certificate& c = certificates[p];
    val component = val::object(), cones = val::array(), reasons = val::array();
    for (const MeasuredCone& cone : c.angles.cones) {
      val entry = val::object();
      entry.set("vertex", vertices[p][static_cast<std::size_t>(cone.vertex.i)]);
      entry.set("k", cone.measured);
      cones.call<void>("push", entry);
    }
    for (const Reason& reason : c.reasons) {
      val entry = val::object();
      entry.set("rule", std::string(ruleName(reason.rule)));
      entry.set("count", reason.count);
      entry.set("worst", reason.worst);
      reasons.call<void>("push", entry);
    }
    component.set("certified", c.isCertified);
    component.set("triangles", c.faceCount);
    component.set("positive", c.orientation.positive);
    component.set("genus", c.genus);
    component.set("boundaries", c.loopCount);
    component.set("meanMu", c.distortion.meanMu);
    component.set("cones", cones);
    component.set("reasons", reasons);
    components.call<void>("push", component);
  }
  out.set("certified", areCertified(certificates));
  out.set("q", certificates.empty() ? 0 : certificates.front().q);
  out.set("components", components);
  return out;
}

}  // namespace hgp::js

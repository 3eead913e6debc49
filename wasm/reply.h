// The reply of every call: a plain object with its results, or with `error`, the JSON of the failure.
#pragma once

#include <emscripten/val.h>

#include <string>

#include "hgp/api/session.h"
#include "hgp/api/session/guard.h"

namespace hgp::js {

using emscripten::val;

inline val failed(const Failure& failure) {
  val reply = val::object();
  reply.set("error", api::errorJson(failure));
  return reply;
}

inline val replyJson(const std::string& json) {
  val reply = val::object();
  reply.set("json", json);
  return reply;
}

inline val replyVerdict(const Result<api::Verdict>& verdict) {
  return verdict ? replyJson(verdict->json) : failed(verdict.error());
}

inline val replyText(const Result<std::string>& json) {
  return json ? replyJson(*json) : failed(json.error());
}

/// Catches exceptions here as well, because memory may run out while arguments are copied, outside the API boundary.
template <class Call>
val guarded(const Call& call) {
  try {
    return call();
  } catch (...) {
    return failed(api::caughtFailure());
  }
}

}  // namespace hgp::js

// hgp::api::LiveDrag for JavaScript: replies as of every call.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "convert.h"
#include "hgp/api/live_drag.h"
#include "reply.h"

namespace hgp::js {

class Drag {
 public:
  /// From the session's result; the session must outlive every later call but the destructor.
  Status begin(api::Session& session, int vertex) {
    Result<api::LiveDrag> drag = api::LiveDrag::begin(session, vertex);
    if (!drag) return drag.error();
    drag_.emplace(std::move(*drag));
    return Done{};
  }

  val moveTo(int vertex) {
    return guarded([&] {
      const Result<api::LiveView> view = drag_->moveTo(vertex);
      if (!view) return failed(view.error());
      val reply = val::object();
      reply.set("state", std::string(liveStateName(view->state)));
      reply.set("uv", toTypedArray("Float64Array", view->uv));
      reply.set("cornerToUv", toTypedArray("Uint32Array", view->cornerToUv));
      reply.set("logScale", toTypedArray("Float32Array", view->logScale));
      reply.set("notPositive", toTypedArray("Uint32Array", view->notPositive));
      reply.set("reasons", val::array(view->reasons));
      reply.set("cones", view->cones);
      reply.set("wantsPreparation", view->wantsPreparation);
      return reply;
    });
  }

  val prepareHere() { return answerTo(drag_->prepareHere()); }
  /// The reply's `vertex` is that of the position reached, or −1.
  val prepareToward(int vertex) {
    return guarded([&] {
      const Result<int> reached = drag_->prepareToward(vertex);
      if (!reached) return failed(reached.error());
      val reply = val::object();
      reply.set("vertex", *reached);
      return reply;
    });
  }
  val drop() { return answerTo(drag_->drop()); }

 private:
  static val answerTo(const Status& status) {
    return status ? val::object() : failed(status.error());
  }

  std::optional<api::LiveDrag> drag_;
};

}  // namespace hgp::js

// What was written, as objects of JavaScript.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "convert.h"
#include "hgp/api/notes.h"
#include "hgp/api/whole_file.h"

namespace hgp::js {

inline val toWritten(const api::WrittenMap& written) {
  val reply = val::object();
  reply.set("files", toFiles(written.files));
  reply.set("notes", api::notesDocument(written.notes));
  reply.set("xref", toTypedArray("Int32Array", written.xref));
  reply.set("certified", written.isCertified);
  return reply;
}

/// The same with mapNotes: [{mesh, notes}].
inline val toFile(const api::WrittenFile& written, const std::vector<int>& meshes) {
  val reply = toWritten(written), list = val::array();
  for (std::size_t i = 0; i < written.mapNotes.size() && i < meshes.size(); ++i) {
    val one = val::object();
    one.set("mesh", meshes[i]);
    one.set("notes", api::notesDocument(written.mapNotes[i]));
    list.call<void>("push", one);
  }
  reply.set("mapNotes", list);
  return reply;
}

/// {mesh, certified, aligned} with the report, or the error.
inline val toOutcome(const api::MeshOutcome& one) {
  val out = val::object();
  out.set("mesh", one.mesh);
  out.set("certified", one.isCertified);
  out.set("aligned", one.isAligned);
  if (one.failure)
    out.set("error", api::errorJson(*one.failure));
  else
    out.set("report", one.report);
  return out;
}

}  // namespace hgp::js

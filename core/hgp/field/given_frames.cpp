#include "hgp/field/given_frames.h"

#include "hgp/base/check.h"

namespace hgp {
namespace {

Failure contradiction(const std::string& what, std::vector<Where> where = {}) {
  return {ErrorCode::kPrescription, "field",
          formatText("The field does not match the prescription: %s. Prescribe what the field "
                     "has, or use automatic frames.",
                     what.c_str()),
          std::move(where)};
}

/// Every interior vertex must have the prescribed angle index.
Status compareCones(const TriMesh& mesh, const CompleteSpec& has, const HolonomySpec& asked) {
  PerVertex<int> want(static_cast<std::size_t>(mesh.vertexCount()), asked.q), k = want;
  for (const ConePoint& cone : asked.cones) want[cone.vertex] = cone.k;
  for (const ConePoint& cone : has.cones) k[cone.vertex] = cone.k;
  std::vector<Where> where;
  for (VertexId v : mesh.vertices())
    if (k[v] != want[v]) where.push_back({Where::Kind::kVertex, v.i});
  if (where.empty()) return Done{};
  const VertexId v(static_cast<int>(where[0].id));
  const std::string text = formatText("k = %d where k = %d is prescribed (%zu vertices differ)",
                                      k[v], want[v], where.size());
  return contradiction(text, std::move(where));
}

Status compareTurning(const CompleteSpec& has, const HolonomySpec& asked) {
  for (std::size_t j = 0; j < has.turning.size() && j < asked.turning.size(); ++j) {
    if (!asked.turning[j] || *asked.turning[j] == has.turning[j]) continue;
    return contradiction(formatText("a boundary loop has l = %d where l = %d is prescribed",
                                    has.turning[j], *asked.turning[j]),
                         {{Where::Kind::kLoop, static_cast<std::int64_t>(j)}});
  }
  return Done{};
}

Status compareHandles(const CompleteSpec& has, const HolonomySpec& asked) {
  for (std::size_t i = 0; i < has.handles.size() && i < asked.handles.size(); ++i) {
    if (!asked.handles[i]) continue;
    const int r = reduceTurn(*asked.handles[i], asked.q);
    if (r == has.handles[i]) continue;
    return contradiction(
        formatText("handle generator %zu of its component has r = %d where r = %d is prescribed", i,
                   has.handles[i], r));
  }
  return Done{};
}

}  // namespace

Result<ReadField> givenFrames(const TriMesh& mesh, const FieldContext& context,
                              const FieldData& data, const HolonomySpec& asked) {
  if (data.directions.empty())
    return Failure{ErrorCode::kUsage,
                   "field",
                   "This field has matchings but no directions: frames need one direction per "
                   "triangle (.rawfield, .rosy, .ffield). Use automatic frames.",
                   {}};
  if (data.order != asked.q)
    return contradiction(
        formatText("its order is %d, the prescription has q = %d", data.order, asked.q));
  Result<ReadField> read = fieldOfFieldData(mesh, context, data, asked.cones);
  if (!read) return read;
  read->spec = specOfField(mesh, context, read->field);
  if (Status same = compareCones(mesh, read->spec, asked); !same) return std::move(same).error();
  if (Status same = compareTurning(read->spec, asked); !same) return std::move(same).error();
  if (Status same = compareHandles(read->spec, asked); !same) return std::move(same).error();
  return read;
}

}  // namespace hgp

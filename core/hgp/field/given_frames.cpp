#include "hgp/field/given_frames.h"

namespace hgp {
namespace {

Failure contradiction(const std::string& what, std::vector<Where> where = {}) {
  return {ErrorCode::kPrescription, "field",
          "The frames of the field do not realise what is asked: " + what +
              " Ask for what the field has, or take automatic frames.",
          std::move(where)};
}

/// Every interior vertex must have the asked angle index.
Status compareCones(const TriMesh& mesh, const CompleteSpec& has, const HolonomySpec& asked) {
  PerVertex<int> want(static_cast<std::size_t>(mesh.vertexCount()), asked.q), k = want;
  for (const ConePoint& cone : asked.cones) want[cone.vertex] = cone.k;
  for (const ConePoint& cone : has.cones) k[cone.vertex] = cone.k;
  std::vector<Where> where;
  std::string first;
  for (VertexId v : mesh.vertices()) {
    if (k[v] == want[v]) continue;
    if (where.empty())
      first = "they turn to k = " + std::to_string(k[v]) + " where k = " + std::to_string(want[v]) +
              " is asked";
    where.push_back({Where::Kind::kVertex, v.i});
  }
  if (where.empty()) return Done{};
  const std::string count = std::to_string(where.size());
  return contradiction(
      first + (where.size() == 1 ? ", at one vertex." : ", the first of " + count + " vertices."),
      std::move(where));
}

Status compareTurning(const CompleteSpec& has, const HolonomySpec& asked) {
  for (std::size_t j = 0; j < has.turning.size() && j < asked.turning.size(); ++j) {
    if (!asked.turning[j] || *asked.turning[j] == has.turning[j]) continue;
    return contradiction(
        "along a boundary loop they turn by l = " + std::to_string(has.turning[j]) +
            " where l = " + std::to_string(*asked.turning[j]) + " is asked.",
        {{Where::Kind::kLoop, static_cast<std::int64_t>(j)}});
  }
  return Done{};
}

Status compareHandles(const CompleteSpec& has, const HolonomySpec& asked) {
  for (std::size_t i = 0; i < has.handles.size() && i < asked.handles.size(); ++i) {
    if (!asked.handles[i] || reduceTurn(*asked.handles[i], asked.q) == has.handles[i]) continue;
    return contradiction("along handle generator " + std::to_string(i) +
                         " of its component they turn by r = " + std::to_string(has.handles[i]) +
                         " where r = " + std::to_string(reduceTurn(*asked.handles[i], asked.q)) +
                         " is asked.");
  }
  return Done{};
}

}  // namespace

Result<ReadField> givenFrames(const TriMesh& mesh, const FieldContext& context,
                              const FieldData& data, const HolonomySpec& asked) {
  if (data.directions.empty())
    return Failure{ErrorCode::kUsage,
                   "field",
                   "This field has matchings but no directions, so it gives no frames: they need "
                   "one direction per triangle (.rawfield, .rosy, .ffield). Take automatic frames.",
                   {}};
  if (data.order != asked.q)
    return contradiction("its order is " + std::to_string(data.order) +
                         ", the prescription has q = " + std::to_string(asked.q) + ".");
  Result<ReadField> read = fieldOfFieldData(mesh, context, data, asked.cones);
  if (!read) return read;
  read->spec = specOfField(mesh, context, read->field);
  if (Status same = compareCones(mesh, read->spec, asked); !same) return std::move(same).error();
  if (Status same = compareTurning(read->spec, asked); !same) return std::move(same).error();
  if (Status same = compareHandles(read->spec, asked); !same) return std::move(same).error();
  return read;
}

}  // namespace hgp

#include "hgp/mesh/describe_shortage.h"

#include "hgp/base/turns.h"

namespace hgp {
namespace {

/// Number of places that a note names.
constexpr std::size_t kNamed = 8;

/// "5, 6, …".
std::string listed(const std::vector<int>& numbers) {
  std::string out;
  for (std::size_t n = 0; n < numbers.size() && n < kNamed; ++n)
    out += (n > 0 ? ", " : "") + std::to_string(numbers[n]);
  return numbers.size() > kNamed ? out + ", …" : out;
}

}  // namespace

Note noteOn(const AngleQuestion& question, const AngleShortage& shortage) {
  const std::size_t cones = shortage.cones.size(), regular = shortage.regular.size();
  const std::size_t rims = shortage.loops.size(), vertices = cones + regular;
  Note note("angle-shortage");
  std::vector<int> k, turnings;
  const auto add = [&](Where::Kind kind, int id) {
    if (note.where.size() < kNamed) note.where.push_back({kind, id});
  };
  for (const VertexId v : shortage.cones) {
    add(Where::Kind::kVertex, v.i);
    k.push_back(question.k[v]);
  }
  for (const VertexId v : shortage.regular) add(Where::Kind::kVertex, v.i);
  for (const int loop : shortage.loops) {
    note.where.push_back({Where::Kind::kLoop, loop});
    for (const LoopAngle& given : question.loops)
      if (given.index == loop) turnings.push_back(given.turning);
  }
  const int asking = shortage.vertices + static_cast<int>(rims);
  note.values = {{"cones", cones},
                 {"k", listed(k)},
                 {"afterCones", cones > 0 && regular > 0 ? 1 : 0},
                 {"regular", regular},
                 {"vertices", vertices},
                 {"more", vertices > kNamed ? 1 : 0},
                 {"afterVertices", vertices > 0 && rims > 0 ? 1 : 0},
                 {"rims", rims},
                 {"turning", listed(turnings)},
                 {"asking", asking},
                 {"together", asking == 1 ? 0 : 1},
                 {"pi", shortage.asked / kPi},
                 {"triangles", shortage.triangles}};
  return note;
}

}  // namespace hgp

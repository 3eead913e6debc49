#include "hgp/mesh/describe_shortage.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/turns.h"

namespace hgp {
namespace {

/// Number of vertices that a sentence names.
constexpr std::size_t kNamed = 8;

/// "a", "a and b", "a, b and c"; "a, b, … and n others" above kNamed.
std::string listed(const std::vector<std::string>& names) {
  std::string out;
  const std::size_t shown = names.size() > kNamed ? kNamed - 1 : names.size();
  for (std::size_t n = 0; n < shown; ++n) {
    const bool isLast = n + 1 == names.size();
    if (n > 0) out += isLast ? " and " : ", ";
    out += names[n];
  }
  if (shown < names.size()) out += " and " + std::to_string(names.size() - shown) + " others";
  return out;
}

std::string nameOf(const AngleQuestion& question, VertexId v) {
  const int k = question.k[v];
  return k == question.q ? std::to_string(v.i) : formatText("%d (k=%d)", v.i, k);
}

std::string nameOfRim(const AngleQuestion& question, int loop) {
  for (const LoopAngle& given : question.loops)
    if (given.index == loop) return formatText("%d (turning %d)", loop, given.turning);
  return std::to_string(loop);
}

std::string plural(std::size_t n, const char* one, const char* many) { return n == 1 ? one : many; }

/// "the cones 20 (k=5) and 31 (k=6), the vertices 7 and 9 without a cone and the rim 0 (turning −60)".
std::string placesOf(const AngleQuestion& question, const AngleShortage& shortage) {
  std::vector<std::string> cones, regular, rims, parts;
  for (const VertexId v : shortage.cones) cones.push_back(nameOf(question, v));
  for (const VertexId v : shortage.regular) regular.push_back(nameOf(question, v));
  for (const int loop : shortage.loops) rims.push_back(nameOfRim(question, loop));
  if (!cones.empty())
    parts.push_back(plural(cones.size(), "the cone ", "the cones ") + listed(cones));
  if (regular.size() > kNamed)
    parts.push_back(std::to_string(regular.size()) + " vertices without a cone (" +
                    listed(regular) + ")");
  else if (!regular.empty())
    parts.push_back(plural(regular.size(), "the vertex ", "the vertices ") + listed(regular) +
                    " without a cone");
  if (!rims.empty()) parts.push_back(plural(rims.size(), "the rim ", "the rims ") + listed(rims));
  return listed(parts);
}

}  // namespace

std::string describeShortage(const AngleQuestion& question, const AngleShortage& shortage) {
  const bool isOne = shortage.vertices + static_cast<int>(shortage.loops.size()) == 1;
  const char* advice = shortage.loops.empty()
                           ? "Lower k there, move these cones apart"
                           : "Give another turning, move cones away from the rim";
  return formatText(
      "No locally injective map on this mesh has these angles: %s ask%s for %gπ%s, and the %s "
      "around %s cannot give that much: each has π for all its corners, and those elsewhere need "
      "some of it. %s, or split edges there (--refine).",
      placesOf(question, shortage).c_str(), isOne ? "s" : "", shortage.asked / kPi,
      isOne ? "" : " together", counted(shortage.triangles, "triangle").c_str(),
      isOne ? "it" : "them", advice);
}

}  // namespace hgp

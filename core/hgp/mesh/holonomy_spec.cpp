#include "hgp/mesh/holonomy_spec.h"

#include <algorithm>
#include <numeric>

#include "hgp/base/check.h"
#include "hgp/base/turns.h"
#include "hgp/mesh/angle_shortage_memo.h"
#include "hgp/mesh/describe_shortage.h"

namespace hgp {
namespace {

Failure refuse(std::string message, std::vector<Where> where = {}) {
  return {ErrorCode::kPrescription, "prescription", std::move(message), std::move(where)};
}

/// "12 (k=5), 40 (k=9), …"
std::string listCones(const std::vector<ConePoint>& cones) {
  constexpr std::size_t kShown = 5;
  std::string text;
  for (std::size_t n = 0; n < std::min(kShown, cones.size()); ++n)
    text += formatText("%s%d (k=%d)", n ? ", " : "", cones[n].vertex.i, cones[n].k);
  return text + (cones.size() > kShown ? ", …" : "");
}

Failure refuseCones(const std::vector<ConePoint>& cones, const char* rule) {
  std::vector<Where> where;
  where.reserve(cones.size());
  for (const ConePoint& c : cones) where.push_back({Where::Kind::kVertex, c.vertex.i});
  return refuse(formatText("%zu cone%s %s: vertex %s.", cones.size(), cones.size() == 1 ? "" : "s",
                           rule, listCones(cones).c_str()),
                std::move(where));
}

/// Of cones and corners.
template <class Predicate>
std::vector<ConePoint> selectCones(const HolonomySpec& spec, Predicate isSelected) {
  std::vector<ConePoint> found;
  for (const auto* list : {&spec.cones, &spec.corners})
    std::copy_if(list->begin(), list->end(), std::back_inserter(found), isSelected);
  return found;
}

Status checkShape(const TriMesh& mesh, const Topology& topology, const HolonomySpec& spec) {
  if (spec.q < 1 || spec.q > kLargestOrder)
    return refuse(formatText("q = %d; the order must be between 1 and %d.", spec.q, kLargestOrder));
  const auto loops = topology.loops.size();
  if (!spec.turning.empty() && spec.turning.size() != loops)
    return refuse(formatText("%zu turning indices are given; the surface has %zu boundary loops.",
                             spec.turning.size(), loops));
  const auto generators = 2 * static_cast<std::size_t>(topology.genus);
  if (!spec.handles.empty() && spec.handles.size() != generators)
    return refuse(formatText("%zu handle rotations are given; a surface of genus %d has %zu.",
                             spec.handles.size(), topology.genus, generators));

  const auto isMissing = [&](const ConePoint& c) {
    return c.vertex.i < 0 || c.vertex.i >= mesh.vertexCount();
  };
  if (auto bad = selectCones(spec, isMissing); !bad.empty())
    return refuseCones(bad, "at a vertex that does not exist");
  if (auto bad = selectCones(spec, [&](auto& c) { return mesh.isIsolated(c.vertex); });
      !bad.empty())
    return refuseCones(bad, "at a vertex without faces");
  const auto isOutside = [&](const ConePoint& c) { return mesh.isBoundary(c.vertex); };
  std::vector<ConePoint> outside;
  std::copy_if(spec.cones.begin(), spec.cones.end(), std::back_inserter(outside), isOutside);
  if (!outside.empty())
    return refuseCones(outside, "on the boundary, where only a loop's total turning is prescribed");
  std::vector<int> uses(static_cast<std::size_t>(mesh.vertexCount()), 0);
  const auto isRepeated = [&](const ConePoint& c) {
    return ++uses[static_cast<std::size_t>(c.vertex.i)] == 2;
  };
  if (auto bad = selectCones(spec, isRepeated); !bad.empty())
    return refuseCones(bad, "given twice");
  return Done{};
}

Status checkLimits(const TriMesh& mesh, const Topology& topology, const HolonomySpec& spec) {
  if (auto bad = selectCones(spec, [](auto& c) { return c.k < 1; }); !bad.empty())
    return refuseCones(bad, "with k < 1; a cone angle 2πk/q must be positive");
  const auto isTooWide = [&](const ConePoint& c) {
    return 2LL * c.k >= static_cast<long long>(spec.q) * mesh.valence(c.vertex);
  };
  if (auto bad = selectCones(spec, isTooWide); !bad.empty())
    return refuseCones(bad,
                       "with 2k ≥ q·valence; each triangle contributes less than π, so the "
                       "vertex has too few of them");
  for (std::size_t j = 0; j < spec.turning.size(); ++j) {
    if (!spec.turning[j]) continue;
    const TurningRange range = turningRange(mesh, topology.loops[j], spec.q);
    if (*spec.turning[j] < range.lowest || *spec.turning[j] > range.highest)
      return refuse(
          formatText("Turning index %d of boundary loop %zu is out of range: its %zu vertices "
                     "and their triangles allow %lld to %lld.",
                     *spec.turning[j], j, topology.loops[j].halfedges.size(), range.lowest,
                     range.highest),
          {{Where::Kind::kLoop, static_cast<std::int64_t>(j)}});
  }
  return Done{};
}

std::string newCones(long long count, long long k) {
  return count == 1 ? formatText("a new cone of k=%lld", k)
                    : formatText("%lld new cones of k=%lld", count, k);
}

/// New cones of fewer than q that take an excess away: half a turn more each, which six triangles hold with right angles.
std::string wideCones(long long excess, int q) {
  const long long each = std::max(1, q / 2);
  const long long count = excess / each;
  const long long rest = excess % each;
  if (count == 0 || rest == 0) return newCones(std::max(1LL, count), q + (count ? each : rest));
  return newCones(count, q + each) + " and " + newCones(1, q + rest);
}

/// Advice on how to distribute a missing amount, or how to remove an excess.
std::string budgetAdvice(long long missing, int q, bool hasLoops) {
  const long long n = std::abs(missing);
  const char* turn = hasLoops ? (missing > 0 ? ", or raise turning indices by as much"
                                             : ", or lower turning indices by as much")
                              : "";
  if (missing > 0) {
    const std::string example = n < q ? newCones(1, q - n) : newCones(n, q - 1);
    return formatText("%lld missing: lower the k of cones by %lld in total (%s)%s", n, n,
                      q > 1 ? example.c_str() : "q=1 has no cones of positive curvature", turn);
  }
  return formatText("%lld too many: raise the k of cones by %lld in total (%s)%s", n, n,
                    wideCones(n, q).c_str(), turn);
}

/// The range of sums that the turning indices of the open loops can have.
TurningRange openRange(const TriMesh& mesh, const Topology& topology, const HolonomySpec& spec) {
  TurningRange sum;
  for (std::size_t j = 0; j < topology.loops.size(); ++j) {
    if (j < spec.turning.size() && spec.turning[j]) continue;
    const TurningRange range = turningRange(mesh, topology.loops[j], spec.q);
    sum.lowest += range.lowest;
    sum.highest += range.highest;
  }
  return sum;
}

Result<BudgetReport> balance(const TriMesh& mesh, const Topology& topology,
                             const HolonomySpec& spec) {
  const auto m = static_cast<int>(topology.loops.size());
  const int g = topology.genus;
  BudgetReport report;
  report.need = static_cast<long long>(spec.q) * (2 - 2 * g - m);
  report.openLoops = m;
  for (const ConePoint& c : spec.cones) report.have += spec.q - c.k;
  for (const auto& l : spec.turning) {
    if (!l) continue;
    report.have += *l;
    --report.openLoops;
  }
  const long long missing = report.need - report.have;
  const std::string sums =
      formatText("Gauss–Bonnet (Lemma 6.2): Σ = %lld, need %lld (q=%d, g=%d, m=%d); ", report.have,
                 report.need, spec.q, g, m);
  if (report.openLoops == 0) {
    if (missing != 0) return refuse(sums + budgetAdvice(missing, spec.q, m > 0) + ".");
    return report;
  }
  const TurningRange open = openRange(mesh, topology, spec);
  if (missing < open.lowest || missing > open.highest)
    return refuse(sums + formatText("the turning of the %d open boundary loop%s would have to be "
                                    "%lld, and can be %lld to %lld.",
                                    report.openLoops, report.openLoops == 1 ? "" : "s", missing,
                                    open.lowest, open.highest));
  return report;
}

/// q and cones divided by the common divisor of q, k, l and r: the same problem with the smallest
/// rotation group. `areHandlesKnown` is false when an open handle could still enlarge the group.
struct ReducedProblem {
  int divisor = 1;
  int q = 1;
  std::vector<int> k;  ///< of true cones, ascending
  bool areHandlesKnown = true;
  bool isHolonomyTrivial = true;  ///< no known handle rotates
};

ReducedProblem reduceProblem(const Topology& topology, const HolonomySpec& spec) {
  ReducedProblem p;
  p.divisor = spec.q;
  for (const ConePoint& c : spec.cones) p.divisor = std::gcd(p.divisor, c.k);
  for (const auto& l : spec.turning) p.divisor = std::gcd(p.divisor, l.value_or(1));
  for (const auto& r : spec.handles) {
    if (!r) continue;
    p.divisor = std::gcd(p.divisor, *r);
    if (reduceTurn(*r, spec.q) != 0) p.isHolonomyTrivial = false;
  }
  p.areHandlesKnown =
      topology.genus == 0 ||
      (!spec.handles.empty() && std::all_of(spec.handles.begin(), spec.handles.end(),
                                            [](const auto& r) { return r.has_value(); }));
  p.q = spec.q / p.divisor;
  for (const ConePoint& c : spec.cones)
    if (c.k != spec.q) p.k.push_back(c.k / p.divisor);
  std::sort(p.k.begin(), p.k.end());
  return p;
}

std::string reducedText(const ReducedProblem& p) {
  return p.divisor == 1 ? ""
                        : formatText(" (reduced by the common divisor %d to q=%d)", p.divisor, p.q);
}

/// Refuses prescriptions on closed surfaces that satisfy Lemma 6.2 but have no flat metric.
Status checkClosed(const Topology& topology, const HolonomySpec& spec, BudgetReport& report) {
  const ReducedProblem p = reduceProblem(topology, spec);
  const std::string reduced = reducedText(p);
  if (topology.genus == 1 && p.k.empty() && !p.isHolonomyTrivial)
    return refuse(
        "A closed torus without cones is flat, and its handles cannot rotate: every "
        "handle rotation must be 0.");
  if (topology.genus == 1 && p.k == std::vector<int>{p.q - 1, p.q + 1}) {
    const std::string text = formatText(
        "A closed torus with exactly two cones, k=%d and k=%d%s, has no map with all rotations "
        "multiples of 2π/%d",
        p.q - 1, p.q + 1, reduced.c_str(), p.q);
    if (p.divisor == 1 || p.areHandlesKnown) return refuse(text + ": add two more cones.");
    report.warnings.push_back(
        Note("budget-two-cones",
             {{"low", p.q - 1}, {"high", p.q + 1}, {"divisor", p.divisor}, {"q", p.q}}));
  }
  const bool isEmptyStratum = topology.genus == 2 && p.q == 2 &&
                              (p.k == std::vector<int>{3, 5} || p.k == std::vector<int>{6});
  // One cone of k=6 and trivial handles is a translation surface, which exists; it reduces to q = 1.
  const bool isEitherOr = topology.genus == 2 && p.q == 1 && p.k == std::vector<int>{3} &&
                          p.divisor % 2 == 0 && !p.areHandlesKnown;
  const int divisor = p.divisor == 1 ? 0 : p.divisor;
  if (isEmptyStratum)
    report.warnings.push_back(
        Note("budget-empty-stratum",
             {{"divisor", divisor}, {"q", p.q}, {"unless", p.areHandlesKnown ? 0 : divisor}}));
  if (isEitherOr)
    report.warnings.push_back(Note("budget-one-cone", {{"divisor", divisor}, {"q", p.q}}));
  return Done{};
}

void warnPoorVertices(const TriMesh& mesh, const HolonomySpec& spec, BudgetReport& report) {
  const auto isPoor = [&](const ConePoint& c) {
    return turnAngle(c.k, spec.q) > kPoorCornerAngle * mesh.valence(c.vertex);
  };
  const auto poor = selectCones(spec, isPoor);
  if (poor.empty()) return;
  Note note("budget-few-triangles", {{"cones", poor.size()}, {"angle", kPoorCornerAngle}});
  for (const ConePoint& c : poor) note.where.push_back({Where::Kind::kVertex, c.vertex.i});
  report.warnings.push_back(std::move(note));
}

/// Whether the mesh has too few triangles for the angles. This is a warning, because a finer mesh of the surface may
/// have enough.
bool warnShortage(const TriMesh& mesh, const HolonomySpec& spec, AngleShortageMemo& shortages,
                  BudgetReport& report) {
  PerVertex<int> k(static_cast<std::size_t>(mesh.vertexCount()), spec.q);
  for (const ConePoint& cone : spec.cones) k[cone.vertex] = cone.k;
  const std::optional<AngleShortage>& found = shortages.find(mesh, spec.q, k);
  if (!found) return false;
  report.warnings.push_back(noteOn({spec.q, k, {}}, *found));
  return true;
}

}  // namespace

std::optional<Note> proveImpossible(const TriMesh& mesh, const Topology& topology,
                                    const HolonomySpec& spec, const NearAngles& nearAngles) {
  PerVertex<int> k(static_cast<std::size_t>(mesh.vertexCount()), spec.q);
  for (const ConePoint& cone : spec.cones) k[cone.vertex] = cone.k;
  AngleQuestion question{spec.q, k, {}};
  // Σ (q − k) + Σ l = q χ: where one loop is open, its turning is determined by all others.
  const int loops = static_cast<int>(topology.loops.size());
  long long rest = static_cast<long long>(spec.q) * (2 - 2 * topology.genus - loops);
  for (const ConePoint& cone : spec.cones) rest -= spec.q - cone.k;
  std::vector<int> open;
  for (int j = 0; j < loops; ++j) {
    const auto i = static_cast<std::size_t>(j);
    if (i < spec.turning.size() && spec.turning[i]) {
      question.loops.push_back({j, &topology.loops[i], *spec.turning[i]});
      rest -= *spec.turning[i];
    } else {
      open.push_back(j);
    }
  }
  if (open.size() == 1) {
    // Outside this range nothing is left to prove: completing the turning fails.
    const BoundaryLoop& loop = topology.loops[static_cast<std::size_t>(open[0])];
    const TurningRange range = turningRange(mesh, loop, spec.q);
    if (rest >= range.lowest && rest <= range.highest)
      question.loops.push_back({open[0], &loop, static_cast<int>(rest)});
  }
  const std::optional<AngleShortage> found = findAnyAngleShortage(mesh, question, nearAngles);
  if (!found) return {};
  return noteOn(question, *found);
}

HolonomySpec toSpec(const CompleteSpec& spec) {
  HolonomySpec out{spec.q, spec.cones, {}, {}, spec.features, spec.corners};
  out.turning.assign(spec.turning.begin(), spec.turning.end());
  out.handles.assign(spec.handles.begin(), spec.handles.end());
  return out;
}

TurningRange turningRange(const TriMesh& mesh, const BoundaryLoop& loop, int q) {
  long long slack = 0;  // Σ(1 − t_v)
  for (HalfedgeId h : loop.halfedges) slack += 1 - mesh.valence(mesh.tail(h));
  const long long low = q * slack,
                  high = static_cast<long long>(q) * static_cast<long long>(loop.halfedges.size());
  // low < 2l < high in integers; both may be negative or odd.
  const auto floorHalf = [](long long a) { return a >= 0 ? a / 2 : -((1 - a) / 2); };
  return {floorHalf(low) + 1, -(floorHalf(-high) + 1)};
}

Status checkBounds(const TriMesh& mesh, const Topology& topology, const HolonomySpec& spec) {
  Status ok = checkShape(mesh, topology, spec);
  return ok ? checkLimits(mesh, topology, spec) : ok;
}

Result<BudgetReport> checkSums(const TriMesh& mesh, const Topology& topology,
                               const HolonomySpec& spec) {
  HGP_CHECK(topology.componentCount == 1, "one component expected, got %d",
            topology.componentCount);
  if (Status ok = checkBounds(mesh, topology, spec); !ok) return std::move(ok).error();
  const bool isClosed = topology.loops.empty();
  if (isClosed && topology.genus == 0 && spec.q == 1)
    return refuse(
        "A closed surface of genus 0 has no map with q = 1: cones of positive curvature "
        "need angles below 2π. Choose q ≥ 2.");
  Result<BudgetReport> report = balance(mesh, topology, spec);
  if (!report) return report;
  if (isClosed)
    if (Status ok = checkClosed(topology, spec, *report); !ok) return std::move(ok).error();
  return report;
}

Result<BudgetReport> checkPrescription(const TriMesh& mesh, const Topology& topology,
                                       const HolonomySpec& spec, AngleShortageMemo* shortages) {
  Result<BudgetReport> report = checkSums(mesh, topology, spec);
  if (!report) return report;
  AngleShortageMemo none;
  report->isTooCoarse = warnShortage(mesh, spec, shortages != nullptr ? *shortages : none, *report);
  if (!report->isTooCoarse) warnPoorVertices(mesh, spec, *report);
  return report;
}

}  // namespace hgp

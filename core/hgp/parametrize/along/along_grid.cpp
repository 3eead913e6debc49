#include "hgp/parametrize/along/along_grid.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/features/sum_lattice.h"
#include "hgp/grid/grid_measures.h"
#include "hgp/grid/line_choice.h"
#include "hgp/grid/line_gaps.h"
#include "hgp/grid/snap.h"
#include "hgp/parametrize/along/given_values.h"

namespace hgp {
namespace {

/// Densities that are tried, as factors of the map's scale.
constexpr double kLineFactors[] = {1.0, 1.03, 0.97, 1.08, 1.19, 1.4};
/// Finer ones, to name a number of cells that works.
constexpr double kFinerFactors[] = {2.0, 2.83, 4.0, 5.66};
/// Distances up to this many cells are kept.
constexpr double kLineReach = 12.0;
/// Programs per density.
constexpr int kRoundsPerDensity = 6;
/// Multiply-adds that all choices of integers of a run may take, per unit of ParametrizeOptions::maxStepsPerFace.
constexpr double kChoiceWork = 6e7;
/// Work that is left must suffice for so many updates of all integers, or none are chosen.
constexpr double kFewestRoundings = 4.0;
/// Newton steps × triangles that all untangling of a run may take: about a minute.
constexpr double kGridUntangling = 2.4e7;

double areaOf(const TriMesh& mesh, const CutMesh& cut, const std::vector<Complex>& z) {
  double area = 0.0;
  for (FaceId f : mesh.faces()) {
    const HalfedgeId h = TriMesh::halfedge(f, 0);
    const Complex a = z[at(cut.copy[h].i)];
    area += 0.5 * std::imag(std::conj(z[at(cut.copy[TriMesh::next(h)].i)] - a) *
                            (z[at(cut.copy[TriMesh::previous(h)].i)] - a));
  }
  return area;
}

class GridAligner {
 public:
  GridAligner(const TriMesh& mesh, const StraightSetup& setup, const std::vector<Complex>& z,
              const Eigen::VectorXd& x, const ParametrizeOptions& options)
      : mesh_(mesh),
        setup_(setup),
        z_(z),
        x_(x),
        options_(options),
        isQuad_(options.grid.mode == GridMode::kQuad),
        isNode_(nodes()),
        plane_{mesh,    setup.seamless.cut,   setup.aligned.sectors, setup.unknowns, z,
               isNode_, setup.seamless.cones, setup.aligned.index},
        work_(kChoiceWork * options.maxStepsPerFace) {}

  StraightGrid run() {
    const double area = surfaceArea(mesh_);
    mapArea_ = areaOf(mesh_, setup_.seamless.cut, z_);
    const GridOptions& grid = options_.grid;
    const double cells = grid.cells > 0.0 ? grid.cells : area / (grid.spacing * grid.spacing);
    scale_ = std::sqrt(cells / mapArea_);
    GridReport& report = out_.report;
    report.cells = cells;
    report.spacing = std::sqrt(area / cells);
    report.cellsPerCone = cells / std::max<double>(1.0, static_cast<double>(coneCount()));
    if (!goOn(0.05)) return std::move(out_);
    if (!findLattice()) {
      report.reason = Note("features-no-grid");
      return std::move(out_);
    }
    report.integers = static_cast<int>(variables_.size());
    // A rounding takes as many updates of a dense matrix as there are integers, and seldom does the first one suffice.
    const double most = std::floor(portable::pow(work_ / kFewestRoundings, 1.0 / 3.0));
    if (static_cast<double>(variables_.size()) > most) {
      report.reason =
          Note("features-many-integers", {{"integers", report.integers}, {"most", most}});
      return std::move(out_);
    }
    prepareForm();
    makeChoice(scale_);
    frames_ = framesOfMap(setup_.seamless.context->geometry, setup_.seamless.cut, z_);
    for (const double factor : kLineFactors) {
      const double tried = static_cast<double>(report.attempts.size());
      if (!goOn(0.2 + 0.7 * tried / std::size(kLineFactors)) || attempt(factor * scale_)) break;
    }
    if (!out_.attempt && !out_.isCancelled) explain(cells);
    return std::move(out_);
  }

 private:
  void explain(double cells) {
    GridReport& report = out_.report;
    if (isExhausted_) {
      report.reason = Note("features-grid-work", {{"integers", report.integers}, {"cells", cells}});
      return;
    }
    report.reason = Note("features-no-integers", {{"cells", cells}});
    const GridReport asked = report;
    for (const double factor : kFinerFactors) {
      if (!goOn(0.9)) return;
      // As a run that asks for this number begins; what comes out may be another one.
      const double finer = std::round(cells * factor * factor);
      makeChoice(std::sqrt(finer / mapArea_));
      if (!attempt(std::sqrt(finer / mapArea_))) continue;
      if (out_.isCancelled) return;
      if (isExhausted_) break;
      report = asked;
      report.workingCells = finer;
      out_.attempt.reset();
      return;
    }
    report = asked;
  }

  bool goOn(double fraction) {
    out_.isCancelled = !report(options_.progress, {Stage::kAlign, fraction});
    return !out_.isCancelled;
  }
  std::size_t coneCount() const { return setup_.seamless.cones.size(); }

  /// Ends and corners of features.
  PerVertex<char> nodes() const {
    PerVertex<char> isNode(at(mesh_.vertexCount()), 0);
    PerVertex<int> degree(at(mesh_.vertexCount()), 0);
    const Sectors& sectors = setup_.aligned.sectors;
    for (EdgeId e : mesh_.edges()) {
      if (!sectors.isFeature[e]) continue;
      ++degree[mesh_.tail(mesh_.halfedge(e))];
      ++degree[mesh_.head(mesh_.halfedge(e))];
    }
    for (std::size_t s = 0; s < sectors.list.size(); ++s)
      if (setup_.aligned.index[at(mesh_.vertexCount()) + s] != 2)
        isNode[mesh_.tail(sectors.list[s].first)] = 1;
    for (VertexId v : mesh_.vertices())
      if (degree[v] > 0 && degree[v] != 2) isNode[v] = 1;
    return isNode;
  }

  bool addPart(int copy, int part) { return lattice_.add(partOf(setup_.unknowns, copy, part)); }
  bool addBoth(VertexId v) {
    const int copy = setup_.seamless.cut.firstCopy[v].i;
    return addPart(copy, 0) && addPart(copy, 1);
  }

  /// What must be integers: lines, translations, and points.
  bool findLattice() {
    const CutMesh& cut = setup_.seamless.cut;
    for (const StraightEdge& e : setup_.edges)
      if (!addPart(cut.copy[e.h].i, e.heading % 2 == 0 ? 1 : 0)) return false;
    for (const auto& chain : cut.chains) {
      const HalfedgeId left = chain.left.front();
      const int there = cut.copy[TriMesh::next(mesh_.twin(left))].i, here = cut.copy[left].i;
      const Complex R = rotation(setup_.seamless.seams.rotation[left], 4);
      for (const int part : {0, 1}) {
        // there − R here.
        RealSum sum = partOf(setup_.unknowns, there, part);
        const bool isReal = R.real() != 0.0;
        const double sign = isReal ? R.real() : (part == 0 ? -R.imag() : R.imag());
        addTo(sum, partOf(setup_.unknowns, here, isReal ? part : 1 - part), -sign);
        if (!lattice_.add(sum)) return false;
      }
    }
    if (isQuad_)
      for (VertexId v : mesh_.vertices())
        if (isNode_[v] && !addBoth(v)) return false;
    if (isQuad_)
      for (VertexId v : setup_.seamless.cones)
        if (!addBoth(v)) return false;
    if (!lattice_.isComplete()) return false;
    lattice_.reduce();
    variables_ = lattice_.variables();
    return true;
  }

  void prepareForm() {
    B_ = lattice_.basis();  // dense: only where so many integers are within the budget
    const SeamlessSystem system = systemOf(mesh_, setup_.seamless);
    StraightOptions program;
    program.u = setup_.seamless.field.u;
    const auto n = static_cast<Eigen::Index>(variables_.size());
    covariance_ = straightCovariance(straightSystemOf(setup_, system), program, variables_);
    if (covariance_.rows() != n) covariance_ = Eigen::MatrixXd::Identity(n, n);
    covariance_ = B_ * covariance_ * B_.transpose();
    y0_ = Eigen::VectorXd(n);
    for (Eigen::Index i = 0; i < n; ++i) y0_[i] = x_[variables_[at(i)]];
    y0_ = B_ * y0_;
  }

  /// With the demands at a density: lines farther apart than the reach need none.
  void makeChoice(double scale) {
    const auto n = static_cast<Eigen::Index>(variables_.size());
    std::vector<LineDemand> demands;
    for (const LineGap& gap : lineGaps(plane_, kLineReach / scale)) {
      Eigen::VectorXd d = Eigen::VectorXd::Zero(n);
      bool isBound = true;
      for (const auto& [unknown, factor] : gap.sum) {
        const auto found = std::lower_bound(variables_.begin(), variables_.end(), unknown);
        isBound = isBound && found != variables_.end() && *found == unknown;
        if (isBound) d[found - variables_.begin()] = factor;
      }
      if (!isBound) continue;
      const Eigen::VectorXd inIntegers = B_.transpose().triangularView<Eigen::Lower>().solve(d);
      LineDemand demand;
      demand.least = gap.mayVanish ? 0.0 : gap.isOfCone && !isQuad_ ? 0.5 : 1.0;
      for (Eigen::Index j = 0; j < n; ++j)
        if (std::fabs(inIntegers[j]) > 1e-9)
          demand.terms.push_back({static_cast<int>(j), inIntegers[j]});
      demands.push_back(std::move(demand));
    }
    choice_.emplace(covariance_, std::move(demands));
    positive_.reset();
  }

  struct Chosen {
    Eigen::VectorXd y;
    int broken = 0;
  };
  /// Integers near the map at this scale; nothing where that takes more work than is left.
  std::optional<Chosen> choose(double scale) {
    const auto near = [&](const LineChoice& choice) -> std::optional<Chosen> {
      const std::optional<Eigen::VectorXd> y = choice.near(scale * y0_, work_);
      if (!y) return {};
      return Chosen{*y, choice.broken(*y)};
    };
    std::optional<Chosen> chosen = near(*choice_);
    if (!chosen || chosen->broken == 0) return chosen;
    // A corner that lies slightly on the other side of a line in the map may be bound to that side by another demand.
    if (!positive_) positive_ = choice_->positiveAt(y0_);
    return near(*positive_);
  }

  /// One density; true when there is nothing more to do.
  bool attempt(double scale) {
    const double density = scale * scale / (scale_ * scale_);
    const std::optional<Chosen> chosen = choose(scale);
    isExhausted_ = !chosen;
    if (!chosen) {
      out_.report.attempts.push_back({"work limit", density, 0});
      return true;
    }
    GridValues values{scale, {}, frames_, untanglings_};
    const Eigen::VectorXd x = B_.triangularView<Eigen::Upper>().solve(chosen->y);
    for (std::size_t i = 0; i < variables_.size(); ++i)
      values.given.push_back({variables_[i], x[static_cast<Eigen::Index>(i)]});
    holdOrigin(mesh_, setup_, variables_, values.given);
    const int reversed = static_cast<int>(reversedByGiven(mesh_, setup_, values.given).size());
    GridAttempt record{"straight program", density, std::max(chosen->broken, reversed)};
    if (record.turned > 0) {
      record.method = "lines that meet";
      out_.report.attempts.push_back(record);
      return false;
    }
    ParametrizeOptions options = options_;
    options.maxRounds = kRoundsPerDensity;
    std::vector<Round> rounds;
    StraightRun run(mesh_, setup_, options, rounds, &values);
    std::optional<StraightAttempt> solved = run.run();
    if (!solved) {
      out_.isCancelled = true;
      return true;
    }
    untanglings_ -= solved->untangled;
    if (solved->untangled > 0.0) record.method = "untangling";
    record.turned = static_cast<int>(solved->certificate.orientation.notPositive.size());
    const bool isTaken = solved->certificate.isCertified && take(std::move(*solved), values.given);
    if (!isTaken && record.turned == 0) record.method += ", not certified";
    out_.report.attempts.push_back(record);
    return isTaken;
  }

  bool take(StraightAttempt solved, const GivenValues& given) {
    const CompleteSpec& spec = setup_.seamless.field.spec;
    std::optional<UvMap> snapped =
        snapAligned(mesh_, std::move(solved.map), 4, setup_.seamless.cones, spec.features);
    if (!snapped) return false;
    solved.map = std::move(*snapped);
    solved.certificate = certify(mesh_, spec, solved.map);
    if (!solved.certificate.isCertified || !areLinesWhole(solved.map)) return false;
    describeGrid(mesh_, solved.map, coneCount(), out_.report);
    out_.report.isAligned = true;
    out_.attempt = std::move(solved);
    out_.isHeld.assign(at(setup_.unknowns.count), 0);
    for (const auto& [unknown, value] : given) out_.isHeld[at(unknown)] = 1;
    return true;
  }

  bool areLinesWhole(const UvMap& map) const {
    return std::all_of(setup_.edges.begin(), setup_.edges.end(), [&](const StraightEdge& e) {
      const Vec2& p = map.uv[at(setup_.seamless.cut.copy[e.h].i)];
      const double constant = p[e.heading % 2 == 0 ? 1 : 0];
      return constant == std::nearbyint(constant);
    });
  }

  const TriMesh& mesh_;
  const StraightSetup& setup_;
  const std::vector<Complex>& z_;
  const Eigen::VectorXd& x_;
  const ParametrizeOptions& options_;
  const bool isQuad_;
  const PerVertex<char> isNode_;
  const StraightPlane plane_;
  SumLattice lattice_;
  std::vector<int> variables_;  ///< real unknowns that integers determine
  Eigen::MatrixXd B_;
  Eigen::MatrixXd covariance_;  ///< of the integers
  Eigen::VectorXd y0_;
  PerFace<double> frames_;  ///< of the map as solved
  std::optional<LineChoice> choice_, positive_;
  double mapArea_ = 1.0, scale_ = 1.0;
  double work_;  ///< multiply-adds left for choices
  double untanglings_ = kGridUntangling;
  bool isExhausted_ = false;
  StraightGrid out_;
};

}  // namespace

StraightGrid alignAlong(const TriMesh& mesh, const StraightSetup& setup,
                        const std::vector<Complex>& z, const Eigen::VectorXd& x,
                        const ParametrizeOptions& options) {
  return GridAligner(mesh, setup, z, x, options).run();
}

}  // namespace hgp

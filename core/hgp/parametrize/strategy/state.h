// The states of the strategy, each of which poses one program.  Role: data of the loop of [BCW17 §7]
// (loop.cpp); the moves from one state to the next are in moves/.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hgp/optimize/program.h"
#include "hgp/parametrize/parametrization.h"
#include "hgp/parametrize/seamless_setup.h"
#include "hgp/parametrize/strategy/frames_of_metric.h"

namespace hgp {

/// Range of log scale (max u − min u) above which areas differ too much for most uses.
inline constexpr double kHardScaleRange = 15.0;
/// Above this range float64 cannot resolve the areas of the cone metric itself, only those of less conformal maps.
inline constexpr double kHopelessScaleRange = 25.0;
/// Where the range of u is larger, programs are weighted with u compressed to this range, whose areas float64 resolves.
inline constexpr double kWeightedScaleRange = 14.0;
inline constexpr double kNoClamp = 1e9;

/// How a program weighs its rows and what it adds to them.
struct Weighting {
  const char* name;
  double clamp;      ///< bound on |u − median|
  double quality;    ///< δ of the distortion term; harmonic: > 0 where there is no HarmonicBasis
  int growthRounds;  ///< enlargements of the constrained set
  bool isFromMap;    ///< u from log|f_z| of the map before
  bool isExact = false;
  double soft = 0.0;        ///< > 0: weight of soft frame constraints; only what went wrong is hard
  bool isHarmonic = false;  ///< harmonic at every vertex that is neither cone nor boundary
  WeightKind rows = WeightKind::kMeanValue;  ///< weights of the harmonic rows
};

/// What does not change from round to round.
struct Problem {
  const TriMesh& mesh;
  std::shared_ptr<const SeamlessSetup> setup;
  Method method = Method::kAuto;
  std::vector<Weighting> weightings;
  std::vector<FaceId> base;     ///< F_cb
  std::vector<FaceId> soft;     ///< F_cb, with a ring around it where that is cheap
  bool hasGivenFrames = false;  ///< those of a field file, which the map follows
  int harmonicCount = 0;        ///< unknowns of harmonic maps (HarmonicBasis)
  double maxFaceSteps = 0.0;    ///< of the run, see faceStepsOf()
  std::shared_ptr<AngleFrames> angles;
};
Problem problemOf(const TriMesh& mesh, const std::shared_ptr<const SeamlessSetup>& setup,
                  const ParametrizeOptions& options);

/// One program, its map, and the map's certificate.
struct Attempt {
  ProgramResult program;  ///< if !isFeasible() only status and strained are meaningful
  PerVertex<double> u;
  Frames frames;
  UvMap map;
  Certificate certificate;
  std::vector<FaceId> wrong;  ///< not positive, or where an angle is wrong; ascending
  int wrongCount = 0;         ///< triangles, vertices and loops that are wrong
  bool isFeasible() const { return !socp::isWithoutPoint(program.status); }
};

/// Where the frames of a state come from.
enum class FramedBy : unsigned char {
  kConnection,  ///< the trivial connection on S
  kAngles,      ///< framesOfAngles
  kMap          ///< framesOfMap of `from`
};

/// Everything that determines the program of a round.
struct State {
  std::size_t weighting = 0;     ///< index into Problem::weightings
  int growth = 0;                ///< how often the constrained set was enlarged
  std::vector<FaceId> hard;      ///< the constrained set
  std::vector<FaceId> patch;     ///< the triangles that are solved for; empty: all
  bool isWide = false;           ///< patches have more rings
  std::vector<ConePoint> lifts;  ///< frames from the embedded ring of the map `from` (§7.1)
  FramedBy framedBy = FramedBy::kConnection;
  std::shared_ptr<const SeamRotations> frames;  ///< of that kind; null: the connection's
  int corrections = 0;                          ///< how often in a row frames came from the map
  int untangling = -1;                  ///< index of the kind of untangling; −1: a cone program
  int untangled = 0;                    ///< Newton steps spent on that before
  std::shared_ptr<const Attempt> from;  ///< the map that patch, lifts and scale are taken from
  std::shared_ptr<const HarmonicSystem> harmonic;  ///< with weights of the map before; null: of S
  std::shared_ptr<const Frames> directions;        ///< of the map before; null: the field's
};

/// What a round cost: iterations × (triangles + 6 × hard constraints), which is proportional to time within
/// a factor of two for cone programs and for Newton steps of untangling alike.
double faceStepsOf(const Round& round, int faceCount);

/// States with the same hash pose the same program, but for scale from the map before (isFromMap), which is left out.
std::uint64_t hashOf(const State& state);

/// In words, for reports: the weighting and what the moves did to it.
std::string nameOf(const Problem& problem, const State& state);

State firstState(const Problem& problem);

/// A state that starts a weighting: F_cb alone, the connection's frames.
State startOf(const Problem& problem, std::size_t weighting);

/// A kind of untangling: where its frames come from, the numbers of UntangleOptions, and whether the map that it starts
/// from obeys the frames around cones and along the boundary.
struct Untangling {
  FramedBy framedBy;  ///< kAngles is left out where the prescription has no angle structure
  double scaleWeight, epsilonShare;
  bool startsFramed;
};
const std::vector<Untangling>& untanglings();

/// A move: the next state, or nothing where it does not apply; a function of its arguments (Problem::angles is a cache).
using Move = std::optional<State> (*)(const Problem& problem, const State& state,
                                      const std::shared_ptr<const Attempt>& attempt);

}  // namespace hgp

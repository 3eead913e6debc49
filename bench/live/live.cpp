// Random drags of cones: what part of the frames is certified, and what they cost (bench/LIVE.md).
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "edits.h"
#include "files.h"
#include "hgp/api/model/load_model.h"
#include "hgp/base/threads.h"
#include "hgp/parametrize/live_edit.h"
#include "hgp/parametrize/parametrize.h"
#include "process_memory.h"
#include "processor_time.h"
#include "random.h"

namespace hgp::bench {
namespace {

struct Row {
  std::string name;
  int triangles = 0, cones = 0;
  double firstRun = 0.0;
  int frames = 0, certified = 0, fails = 0, reversed = 0, heat = 0, refuted = 0;
  std::vector<double> frame, verdict, prepare;  ///< milliseconds of processor time
};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

template <class Do>
auto timed(double& milliseconds, const Do& what) {
  const double start = processorSeconds();
  auto result = what();
  milliseconds = 1e3 * (processorSeconds() - start);
  return result;
}

/// The next edge of a walk that goes on as straight as the mesh allows, turning a little at random; invalid where it ends.
HalfedgeId onward(const TriMesh& mesh, const CompleteSpec& spec, VertexId cone, VertexId at,
                  HalfedgeId before, stress::Random& random) {
  std::vector<HalfedgeId> around;
  for (HalfedgeId h : outgoingHalfedges(mesh, at)) around.push_back(h);
  const int count = static_cast<int>(around.size());
  int first = random.below(count);
  if (before.isValid()) {
    const auto back = std::find(around.begin(), around.end(), mesh.twin(before));
    first = static_cast<int>(back - around.begin()) + count / 2 + random.below(2);
  }
  for (int i = 0; i < count; ++i) {
    const HalfedgeId h = around[static_cast<std::size_t>((first + i) % count)];
    const VertexId to = mesh.head(h);
    const bool isOther =
        to != cone && std::any_of(spec.cones.begin(), spec.cones.end(),
                                  [&](const ConePoint& c) { return c.vertex == to; });
    if (!mesh.isBoundary(to) && !isOther) return h;
  }
  return {};
}

/// Counts a frame, after another verifier has looked at its map.
void count(const Verifier& verifier, const LiveFrame& frame, double milliseconds, Row& row) {
  ++row.frames;
  row.heat += frame.state == LiveState::kHeat;
  if (frame.state == LiveState::kHeat) return;
  double verdict = 0.0;
  CertifyOptions options;
  options.measuresDistortion = false;  // as in LiveEdit
  const Certificate again =
      timed(verdict, [&] { return verifier.certify(toSpec(frame.spec), frame.map, options); });
  row.verdict.push_back(verdict);
  row.frame.push_back(milliseconds - verdict);
  row.certified += again.isCertified;
  row.fails += !again.isCertified;
  row.reversed += again.orientation.zero + again.orientation.negative;
  row.refuted += again.isCertified != (frame.state == LiveState::kCertified);
}

/// How cones are dragged.
struct Drags {
  ConesFor conesFor = ConesFor::kBalanced;
  int count = 10;  ///< drags per mesh
  int steps = 10;  ///< frames per drag
  int edges = 1;   ///< per frame: with more, a frame may leap out of reach
  unsigned seed = 1;
};

/// A walk over so many edges; false where it ends at once.
bool walk(const TriMesh& mesh, const CompleteSpec& spec, VertexId cone, int edges,
          stress::Random& random, VertexId& at, HalfedgeId& direction) {
  for (int i = 0; i < edges; ++i) {
    const HalfedgeId h = onward(mesh, spec, cone, at, direction, random);
    if (!h.isValid()) return i > 0;
    direction = h;
    at = mesh.head(h);
  }
  return true;
}

void drag(PreparedSurface& surface, const Parametrization& from, VertexId cone, const Drags& how,
          stress::Random& random, Row& row) {
  const TriMesh& mesh = surface.mesh();
  double milliseconds = 0.0;
  Result<LiveEdit> edit =
      timed(milliseconds, [&] { return LiveEdit::begin(surface, from.spec, from.map, cone); });
  row.prepare.push_back(milliseconds);
  const Verifier verifier(mesh);
  const auto prepareHere = [&] {
    const Status done = timed(milliseconds, [&] { return edit->beginHere(); });
    row.prepare.push_back(milliseconds);
    return static_cast<bool>(done);
  };
  VertexId at = cone;
  HalfedgeId direction;
  for (int step = 0; edit && step < how.steps; ++step) {
    if (!walk(mesh, from.spec, cone, how.edges, random, at, direction)) return;
    const auto move = [&] { return timed(milliseconds, [&] { return edit->moveTo(at); }); };
    Result<LiveFrame> frame = move();
    const auto isOut = [&] {
      return frame && frame->state == LiveState::kHeat && frame->wantsAnchor;
    };
    if (isOut() && how.edges == 1 && prepareHere()) frame = move();
    if (!frame) return;
    count(verifier, *frame, milliseconds, row);
    if (frame->state != LiveState::kHeat && frame->wantsAnchor && !prepareHere()) return;
    if (isOut() && !timed(milliseconds, [&] { return edit->beginToward(at); })) return;
  }
}

Result<Row> rowOf(const std::string& file, const Drags& how) {
  api::LoadOptions load;
  Result<io::FileSet> set = cli::openFiles(file, "", "", load.limits.maxBytes);
  if (!set) return set.error();
  const Result<api::Model> model = api::loadModel(std::move(*set), load);
  if (!model) return model.error();
  if (model->unusable) return *model->unusable;
  Row row;
  row.name = file.substr(file.rfind('/') + 1);
  const TriMesh& mesh = model->components[0].mesh;
  row.triangles = mesh.faceCount();
  PreparedSurface surface(mesh);
  const Result<Parametrization> solved = timed(row.firstRun, [&]() -> Result<Parametrization> {
    SuggestOptions suggest;
    suggest.conesFor = how.conesFor;
    const Result<CompleteSpec> spec = suggestCones(surface, suggest);
    if (!spec) return spec.error();
    return parametrize(surface, toSpec(*spec), {});
  });
  if (!solved) return solved.error();
  if (!solved->isCertified || solved->spec.cones.empty())
    return Failure{ErrorCode::kNoMap, "live", "no certified map with cones", {}};
  row.cones = static_cast<int>(solved->spec.cones.size());
  stress::Random random(std::to_string(how.seed) + row.name);
  for (int i = 0; i < how.count; ++i)
    drag(surface, *solved,
         solved->spec.cones[static_cast<std::size_t>(random.below(row.cones))].vertex, how, random,
         row);
  return row;
}

void print(const Row& row) {
  std::printf(
      "| %s | %d | %d | %.0f | %d | %d (%.1f %%) | %d (%d) | %d | %.1f (%.1f) | %.1f | %.0f |\n",
      row.name.c_str(), row.triangles, row.cones, row.firstRun, row.frames, row.certified,
      100.0 * row.certified / std::max(1, row.frames), row.fails, row.reversed, row.heat,
      quantile(row.frame, 0.5), quantile(row.frame, 0.95), quantile(row.verdict, 0.5),
      quantile(row.prepare, 0.5));
  std::fflush(stdout);
}

int printEdits(const std::vector<std::string>& files, int moves, unsigned seed) {
  std::printf(
      "| mesh | triangles | first run, ms | moved cone, ms | part of first | certified | same, ms "
      "| "
      "dropped, ms |\n|---|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const std::string& file : files) {
    const Result<EditRow> row = editsOf(file, moves, seed);
    if (!row) {
      std::fprintf(stderr, "%s: %s\n", file.c_str(), row.error().message.c_str());
      continue;
    }
    const double moved = quantile(row->moved, 0.5);
    std::printf("| %s | %d | %.0f | %.0f | %.2f | %d of %zu | %.3f | %.0f |\n", row->name.c_str(),
                row->triangles, row->first, moved, moved / row->first, row->certified,
                row->moved.size(), quantile(row->again, 0.5), quantile(row->dropped, 0.5));
    std::fflush(stdout);
  }
  return 0;
}

int run(int argc, char** argv) {
  CLI::App app{"Random drags of cones over solved maps, as a table."};
  Drags how;
  std::vector<std::string> files;
  bool isOfEdits = false;
  app.add_flag("--edits", isOfEdits, "instead: cones that are dropped one edge away, solved anew");
  app.add_option("--drags", how.count, "drags per mesh");
  app.add_option("--steps", how.steps, "frames per drag");
  app.add_option("--edges", how.edges, "per frame");
  bool isOfFew = false;
  app.add_flag("--few", isOfFew, "few cones, as the page tries first");
  app.add_option("--seed", how.seed, "of the drags");
  app.add_option("files", files, "meshes")->required();
  CLI11_PARSE(app, argc, argv);
  if (isOfEdits) return printEdits(files, how.count, how.seed);
  if (isOfFew) how.conesFor = ConesFor::kFew;
  std::printf(
      "| mesh | triangles | cones | first run, ms | frames | certified | not (reversed triangles) "
      "| "
      "heat | frame, ms (p95) | verdict, ms | prepare, ms |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  Row all;
  for (const std::string& file : files) {
    const Result<Row> row = rowOf(file, how);
    if (!row) {
      std::fprintf(stderr, "%s: %s\n", file.c_str(), row.error().message.c_str());
      continue;
    }
    print(*row);
    all.frames += row->frames;
    all.certified += row->certified;
    all.refuted += row->refuted;
  }
  std::printf("\n%d of %d frames certified (%.1f %%)\n", all.certified, all.frames,
              100.0 * all.certified / std::max(1, all.frames));
  if (all.refuted == 0) return 0;
  std::fprintf(stderr, "%d frames refuted by the second verifier\n", all.refuted);
  return 1;
}

}  // namespace
}  // namespace hgp::bench

int main(int argc, char** argv) {
  hgp::cli::keepFreedMemory();  // as everything that works on one surface for long keeps it
  hgp::setThreads(1);           // as of the other tables: a second one adds its waiting
  return hgp::bench::run(argc, argv);
}

#include "edits.h"

#include <algorithm>

#include "files.h"
#include "hgp/api/live_drag.h"
#include "processor_time.h"
#include "random.h"

namespace hgp::bench {
namespace {

template <class Do>
double milliseconds(const Do& what) {
  const double start = processorSeconds();
  what();
  return 1e3 * (processorSeconds() - start);
}

/// The prescription with a cone one edge beside where it is, as a drag gives it; empty where no cone can be there.
Result<prescription::Prescription> movedCone(api::Session& session, int cone,
                                             const api::SurfaceFacts& facts, stress::Random& random,
                                             std::vector<double>& dropped) {
  Result<api::LiveDrag> drag = api::LiveDrag::begin(session, cone);
  if (!drag) return drag.error();
  const auto v = static_cast<std::size_t>(cone);
  const auto start = facts.neighbourStart[v];
  const auto count = static_cast<int>(facts.neighbourStart[v + 1] - start);
  const auto to = facts.neighbours[start + static_cast<std::uint32_t>(random.below(count))];
  const Result<api::LiveView> view = drag->moveTo(static_cast<int>(to));
  if (!view) return view.error();
  Status done = Done{};
  const double spent = milliseconds([&] { done = drag->drop(); });
  if (done && session.isCertified()) dropped.push_back(spent);
  return api::readPrescription("cones.json", view->cones, 4);
}

}  // namespace

Result<EditRow> editsOf(const std::string& file, int moves, unsigned seed) {
  api::LoadOptions load;
  Result<io::FileSet> set = cli::openFiles(file, "", "", load.limits.maxBytes);
  if (!set) return set.error();
  api::Session session;
  if (Status done = session.load(std::move(*set), load); !done) return done.error();
  EditRow row;
  row.name = file.substr(file.rfind('/') + 1);
  row.triangles = static_cast<int>(session.triangles().size() / 3);
  Status done = Done{};
  row.first = milliseconds([&] { done = session.parametrize(std::nullopt, {}); });
  if (!done) return done.error();
  const Result<prescription::Prescription> cones =
      api::readPrescription("cones.json", session.conesJson(), 4);
  const Result<api::SurfaceFacts> facts = session.facts();
  if (!cones || !facts || cones->cones.empty())
    return Failure{ErrorCode::kNoMap, "edits", "no cones", {}};
  const api::StoredResult start = session.result();
  stress::Random random(std::to_string(seed) + row.name);
  for (int i = 0; i < moves; ++i) {
    if (!session.use(start)) break;
    const auto n = static_cast<std::size_t>(random.below(static_cast<int>(cones->cones.size())));
    const Result<prescription::Prescription> moved =
        movedCone(session, cones->cones[n].vertex, *facts, random, row.dropped);
    if (!moved) continue;
    row.moved.push_back(milliseconds([&] { done = session.parametrize(*moved, {}); }));
    row.certified += done && session.isCertified();
    row.again.push_back(milliseconds([&] { done = session.parametrize(*moved, {}); }));
  }
  return row;
}

}  // namespace hgp::bench

// Results that stay usable while others are computed.
#include "hgp/api/session/session_state.h"
#include "hgp/api/sha256.h"
#include "hgp/linalg/kernels/dense_kernels.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp::api {
namespace {

template <class T>
std::string hashOf(const std::vector<T>& values) {
  return sha256(reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T));
}

}  // namespace

const std::string& Session::State::surfaceHash() {
  if (!hash.empty() || !model) return hash;
  const MeshData& source = model->source().mesh;
  hash = model->document->format();
  hash += hashOf(source.positions) + hashOf(source.triangles) + hashOf(model->mesh.positions) +
          hashOf(model->mesh.triangles) + hashOf(model->cornerOrigin.raw());
  return hash;
}

void Session::State::clearResult() {
  solved.reset();
  finer.reset();
  certificate.clear();
}

Status Session::State::solveOrFind(const std::optional<prescription::Prescription>& prescription,
                                   const SolveOptions& options) {
  clearResult();
  RunKey key{prescription, options, linalg::areBaselineKernelsUsed()};
  if (const std::shared_ptr<Solved>* kept = runs.find(key)) {
    if (!report(options.progress, {Stage::kSolve, 0.0})) return cancelled(Stage::kSolve);
    solved = *kept;
    return Done{};
  }
  Status done = solve(prescription, options);
  if (done && solved && !finer) runs.add(std::move(key), triangles.size() / 3, solved);
  return done;
}

StoredResult Session::result() const {
  if (!hasResult()) return {};
  StoredResult result;
  result.data_ = std::make_shared<const StoredResult::Data>(
      StoredResult::Data{state_->surfaceHash(), state_->solved, state_->finer});
  return result;
}

bool Session::use(const StoredResult& result) {
  if (!result.data_ || result.data_->surface != state_->surfaceHash()) return false;
  state_->solved = result.data_->solved;
  state_->finer = result.data_->finer;
  state_->certificate.clear();
  return true;
}

}  // namespace hgp::api

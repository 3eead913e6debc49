// Results that stay usable while others are computed.
#include "hgp/api/session_state.h"
#include "hgp/api/sha256.h"

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
  return true;
}

}  // namespace hgp::api

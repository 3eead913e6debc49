// Keeps earlier results, which can still be written.
#include <algorithm>
#include <utility>

#include "hgp/api/session_state.h"
#include "hgp/api/sha256.h"

namespace hgp::api {
namespace {

constexpr std::size_t kMaxOfASurface = 2;
constexpr std::size_t kMaxTriangles =
    500'000;  // in total; more would take memory from the next solve

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

void Session::State::putAside() {
  if (solved && !finer && !keptAs.empty() && triangles.size() / 3 <= kMaxTriangles)
    aside.push_back({keptAs, surfaceHash(), triangles.size() / 3, std::move(*solved)});
  keptAs.clear();
  solved.reset();
  finer.reset();
  std::size_t ofThisSurface = 0, size = 0;
  for (std::size_t i = aside.size(); i-- > 0;) {
    if (aside[i].surface == hash) ++ofThisSurface;
    size += aside[i].size;
    const bool isTooMany = aside[i].surface == hash && ofThisSurface > kMaxOfASurface;
    if (!isTooMany && size <= kMaxTriangles) continue;
    size -= aside[i].size;
    aside.erase(aside.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void Session::keep(const std::string& name) {
  if (hasResult() && !state_->finer) state_->keptAs = name;
}

bool Session::recall(const std::string& name) {
  if (name.empty()) return false;
  if (state_->keptAs == name) return hasResult();
  const auto isIt = [&](const State::Kept& one) {
    return one.name == name && one.surface == state_->surfaceHash();
  };
  const auto found = std::find_if(state_->aside.begin(), state_->aside.end(), isIt);
  if (found == state_->aside.end()) return false;
  State::Solved result = std::move(found->result);
  state_->aside.erase(found);
  state_->putAside();
  state_->solved = std::move(result);
  state_->keptAs = name;
  return true;
}

}  // namespace hgp::api

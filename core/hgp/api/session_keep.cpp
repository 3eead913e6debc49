// Results that were made before the last one, and can be written still.
#include <algorithm>
#include <utility>

#include "hgp/api/session_state.h"

namespace hgp::api {
namespace {

constexpr std::size_t kMostAside = 2;
constexpr std::size_t kMostTriangles = 500'000;  // beyond, memory is for the next solve

}  // namespace

void Session::State::putAside() {
  const bool isWorth = solved && !finer && !keptAs.empty();
  if (isWorth && triangles.size() / 3 <= kMostTriangles) {
    aside.emplace_back(keptAs, std::move(*solved));
    if (aside.size() > kMostAside) aside.erase(aside.begin());
  }
  keptAs.clear();
  solved.reset();
  finer.reset();
}

void Session::keep(const std::string& name) {
  if (hasResult() && !state_->finer) state_->keptAs = name;
}

bool Session::recall(const std::string& name) {
  if (name.empty()) return false;
  if (state_->keptAs == name) return hasResult();
  const auto isIt = [&](const auto& one) { return one.first == name; };
  const auto found = std::find_if(state_->aside.begin(), state_->aside.end(), isIt);
  if (found == state_->aside.end()) return false;
  State::Solved result = std::move(found->second);
  state_->aside.erase(found);
  state_->putAside();
  state_->solved = std::move(result);
  state_->keptAs = name;
  return true;
}

}  // namespace hgp::api

#include "hgp/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <utility>

#include "hgp/base/observed_work.h"

namespace hgp {
namespace {

/// Work of fewer nanoseconds is not worth waking a thread for.
constexpr double kMinShared = 2e5;
/// Subtrees per thread, so that all are busy until few are left.
constexpr double kSubtreesPerThread = 8.0;

/// A piece of work for who observes it.
class Piece {
 public:
  explicit Piece(int piece, int next = -1)
      : observer_(ObservedWork::here()), piece_(piece), next_(next) {
    if (observer_) observer_->pieceBegins(piece_);
  }
  ~Piece() {
    if (observer_) observer_->pieceEnds(piece_, next_);
  }
  Piece(const Piece&) = delete;
  Piece& operator=(const Piece&) = delete;

 private:
  WorkObserver* observer_;
  int piece_, next_;
};

void share(int most, const std::function<void(int slot)>& work) {
  WorkObserver* const observer = ObservedWork::here();
  if (observer == nullptr) return parallelShare(most, work);
  observer->workBegins();
  work(0);
  observer->workEnds();
}

void lower(std::atomic<int>& value, int to) {
  int now = value.load();
  while (to < now && !value.compare_exchange_weak(now, to)) {
  }
}

}  // namespace

void parallelBlocks(int count, int block, const std::function<void(int begin, int end)>& body) {
  if (count <= 0) return;
  const int blocks = (count - 1) / block + 1;
  const int most = std::min(blocks, threadCount());
  if (most <= 1) return body(0, count);
  std::atomic<int> next{0};
  std::mutex mutex;
  int failed = blocks;
  std::exception_ptr error;
  share(most, [&](int) {
    for (int b = next++; b < blocks; b = next++) try {
        const Piece piece(b);
        body(b * block, b == blocks - 1 ? count : (b + 1) * block);
      } catch (...) {
        next = blocks;  // blocks before this one were begun before it
        const std::lock_guard lock(mutex);
        if (b < failed) error = std::current_exception();
        failed = std::min(failed, b);
      }
  });
  if (error) std::rethrow_exception(error);
}

void parallelInvoke(const std::vector<std::function<void()>>& works) {
  parallelFor(static_cast<int>(works.size()), 1,
              [&](int i) { works[static_cast<std::size_t>(i)](); });
}

InOrder::InOrder(std::vector<int> order, int count, std::function<void(int)> take)
    : order_(std::move(order)),
      take_(std::move(take)),
      isFinished_(static_cast<std::size_t>(count), 0) {}

void InOrder::finish(int member) {
  const std::lock_guard lock(mutex_);
  isFinished_[member] = 1;
  for (; next_ < order_.size() && isFinished_[order_[next_]]; ++next_) take_(order_[next_]);
}

ForestWork::ForestWork(const std::vector<int>& parent, const std::vector<double>& cost)
    : isVisited_(parent.size()) {
  double total = 0.0;
  for (std::size_t t = 0; t < parent.size(); ++t) {
    isVisited_[t] = cost[t] >= 0.0;
    if (isVisited_[t]) total += cost[t];
  }
  slots_ = total < kMinShared ? 1 : threadCount();
  if (slots() > 1) makeItems(parent, cost, total / (kSubtreesPerThread * slots_));
}

void ForestWork::makeItems(const std::vector<int>& parent, const std::vector<double>& cost,
                           double most) {
  const int count = static_cast<int>(parent.size());
  std::vector<double> below(cost);  // of the subtree
  std::vector<int> first(parent.size()), itemOf(parent.size(), -1);
  for (int t = 0; t < count; ++t) first[t] = t;
  for (int t = 0; t < count; ++t) {
    below[t] = std::max(below[t], 0.0);
    if (parent[t] >= 0) first[parent[t]] = std::min(first[parent[t]], first[t]);
  }
  for (int t = 0; t < count; ++t)
    if (parent[t] >= 0) below[parent[t]] += below[t];
  for (int t = 0; t < count; ++t) {
    const bool isSmall = below[t] <= most;
    if (isSmall && parent[t] >= 0 && below[parent[t]] <= most) continue;  // within a larger one
    if (!isSmall && !isVisited_[t]) continue;
    itemOf[t] = static_cast<int>(items_.size());
    items_.push_back({isSmall ? first[t] : t, t + 1, -1, 0});
  }
  for (int t = 0; t < count; ++t) {
    if (itemOf[t] < 0 || parent[t] < 0) continue;
    const int up = itemOf[parent[t]];  // −1 where the parent is not visited
    items_[itemOf[t]].parent = up;
    if (up >= 0) ++items_[up].children;
  }
}

void ForestWork::climbItems(const std::function<void(int item, int slot)>& visit) const {
  std::vector<int> leaves;
  std::vector<std::atomic<int>> waiting(items_.size());
  for (std::size_t i = 0; i < items_.size(); ++i) {
    waiting[i] = items_[i].children;
    if (items_[i].children == 0) leaves.push_back(static_cast<int>(i));
  }
  std::atomic<std::size_t> next{0};
  // Whoever visits the last child goes on to the parent, so that nobody waits.
  share(slots_, [&](int slot) {
    for (std::size_t n = next++; n < leaves.size(); n = next++)
      for (int i = leaves[n]; i >= 0;) try {
          const int up = items_[i].parent;
          {
            const Piece piece(i, up);
            visit(i, slot);
          }
          i = up >= 0 && --waiting[up] == 0 ? up : -1;
        } catch (...) {
          next = leaves.size();
          throw;
        }
  });
}

int ForestWork::climb(const std::function<bool(int node, int slot)>& visit) const {
  const int count = static_cast<int>(isVisited_.size());
  std::atomic<int> bad{count};
  const auto visitAll = [&](int begin, int end, int slot) {
    for (int t = begin; t < end && t < bad; ++t)
      if (isVisited_[t] && !visit(t, slot)) lower(bad, t);
  };
  if (slots() == 1)
    visitAll(0, count, 0);
  else
    climbItems([&](int i, int slot) { visitAll(items_[i].begin, items_[i].end, slot); });
  return bad == count ? -1 : bad.load();
}

void ForestWork::descend(const std::function<void(int node, int slot)>& visit) const {
  const auto visitAll = [&](int begin, int end, int slot) {
    for (int t = end - 1; t >= begin; --t)
      if (isVisited_[t]) visit(t, slot);
  };
  if (slots() == 1) return visitAll(0, static_cast<int>(isVisited_.size()), 0);
  std::vector<int> subtrees;
  for (int i = static_cast<int>(items_.size()) - 1; i >= 0; --i) {
    if (items_[i].end - items_[i].begin == 1)
      visitAll(items_[i].begin, items_[i].end, 0);  // above the subtrees, a small part of the work
    else
      subtrees.push_back(i);
  }
  std::atomic<std::size_t> next{0};
  share(slots_, [&](int slot) {
    for (std::size_t n = next++; n < subtrees.size(); n = next++) {
      const Piece piece(static_cast<int>(n));
      visitAll(items_[subtrees[n]].begin, items_[subtrees[n]].end, slot);
    }
  });
}

}  // namespace hgp

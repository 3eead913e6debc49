// Work that several threads do together.  Role: the only header through which the core uses threads; for sources, not for
// headers that many files include.
//
// Results do not depend on the number of threads: a piece of work writes only what is its own, and whoever adds up does
// so in the order of the pieces. Any of these may be called inside another one. An exception ends the work and is thrown
// to the caller.
#pragma once

#include <functional>
#include <mutex>
#include <vector>

namespace hgp {

/// The number of threads that work started here can have: that of the ThreadScope, or 1.
#ifdef HGP_NO_THREADS
constexpr int threadCount() { return 1; }
#else
int threadCount();
#endif

/// Calls work(slot) in up to `most` threads at a time, each with its own slot in [0, most), and returns when all calls
/// have returned. Slot 0 is the caller's; calls for others may be missing, so that each must be able to do all the work.
void parallelShare(int most, const std::function<void(int slot)>& work);

/// Calls body(begin, end) for the blocks [0, block), [block, 2 block) … of [0, count), in any order. A block should take
/// ten microseconds or more. Of several exceptions that of the first block is thrown.
void parallelBlocks(int count, int block, const std::function<void(int begin, int end)>& body);

/// Calls body(i) for every i in [0, count), in blocks.
template <class Body>
void parallelFor(int count, int block, const Body& body) {
  parallelBlocks(count, block, [&body](int begin, int end) {
    for (int i = begin; i < end; ++i) body(i);
  });
}

/// Calls all of them, which use nothing that another one writes.
void parallelInvoke(const std::vector<std::function<void()>>& works);

/// Takes the results of work that is finished in any order in a fixed one, and each as soon as those before it are taken.
class InOrder {
 public:
  /// @param take  called with the members of `order`, one after another
  /// @param count  members are in [0, count)
  InOrder(std::vector<int> order, int count, std::function<void(int)> take);
  /// To be called once for every member, by any thread.
  void finish(int member);

 private:
  std::vector<int> order_;
  std::function<void(int)> take_;
  std::mutex mutex_;
  std::vector<char> isFinished_;
  std::size_t next_ = 0;
};

/// Visits the nodes of a forest, children before parents. The nodes are in postorder (parent[t] > t, or −1), so that a
/// subtree is a range of nodes that ends with its root.
class ForestWork {
 public:
  /// @param cost  nanoseconds of each node, roughly; nodes of negative cost are not visited
  ForestWork(const std::vector<int>& parent, const std::vector<double>& cost);

  /// Calls visit(t, slot) for every node after it has returned for all its children; at any time calls have different
  /// slots in [0, slots()). Where it returns false, nodes after t are not visited, but all before it still are.
  /// @return the first node for which it returned false, −1 if there is none
  int climb(const std::function<bool(int node, int slot)>& visit) const;
  /// Calls visit(t, slot) for every node after it has returned for its parent.
  void descend(const std::function<void(int node, int slot)>& visit) const;

  int slots() const { return threadCount() == 1 ? 1 : slots_; }

  /// A subtree that one thread visits as a whole, or a single node above such subtrees.
  struct Item {
    int begin = 0, end = 0;  ///< nodes
    int parent = -1;         ///< item, −1: none
    int children = 0;        ///< number of items below it
  };
  /// Empty where slots() is 1.
  const std::vector<Item>& items() const { return items_; }
  /// As climb, for whole items.
  void climbItems(const std::function<void(int item, int slot)>& visit) const;
  bool isVisited(int node) const { return isVisited_[static_cast<std::size_t>(node)] != 0; }

 private:
  void makeItems(const std::vector<int>& parent, const std::vector<double>& cost, double most);

  std::vector<char> isVisited_;
  std::vector<Item> items_;  // in the order of their nodes
  int slots_ = 1;
};

}  // namespace hgp

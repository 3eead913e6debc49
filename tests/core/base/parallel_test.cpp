#include "hgp/base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "hgp/base/observed_work.h"
#include "hgp/base/threads.h"

namespace hgp {
namespace {

const int kThreads[] = {1, 2, 4, 16};

/// Takes about as long as the forest is told.
double busy(int steps) {
  double x = 1.0;
  for (int i = 0; i < steps; ++i) x = std::sqrt(x + i);
  return x;
}

TEST(Threads, AScopeSetsTheNumberOnItsThreadAndTheOuterOneReturns) {
  EXPECT_FALSE(ThreadScope::isOpen());
  EXPECT_EQ(threadCount(), 1);
  {
    const ThreadScope outer(3);
    const int here = availableThreads() > 1 || threadCount() == 3 ? 3 : 1;
    EXPECT_EQ(threadCount(), here);
    {
      const ThreadScope inner(1);
      EXPECT_EQ(threadCount(), 1);
    }
    EXPECT_EQ(threadCount(), here);
    EXPECT_TRUE(ThreadScope::isOpen());
  }
  EXPECT_FALSE(ThreadScope::isOpen());
}

TEST(Threads, TheNumberIsFromOneToTheMost) {
  EXPECT_GE(availableThreads(), 1);
  EXPECT_LE(availableThreads(), kMaxThreads);
  {
    const ThreadScope all(0);
    EXPECT_EQ(threadCount(), availableThreads());
  }
  const ThreadScope many(1000);
  EXPECT_LE(threadCount(), kMaxThreads);
}

TEST(Threads, TheDefaultIsThatOfTheProcess) {
  EXPECT_EQ(defaultThreads(), 0);
  setThreads(3);
  EXPECT_EQ(defaultThreads(), 3);
  EXPECT_EQ(threadCount(), 1);  // without a scope
  setThreads(0);
}

TEST(Parallel, EveryIndexIsVisitedOnce) {
  for (const int threads : kThreads) {
    const ThreadScope scope(threads);
    for (const int count : {0, 1, 7, 64, 1000, 4097})
      for (const int block : {1, 5, 64, 5000}) {
        std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
        parallelFor(count, block, [&](int i) { ++visits[static_cast<std::size_t>(i)]; });
        for (const auto& v : visits) ASSERT_EQ(v.load(), 1) << threads << ' ' << count;
      }
  }
}

TEST(Parallel, WorkWithinWorkIsDoneOnce) {
  for (const int threads : kThreads) {
    const ThreadScope scope(threads);
    std::vector<std::atomic<int>> visits(8 * 300);
    parallelFor(8, 1, [&](int a) {
      parallelFor(300, 10, [&](int b) {
        busy(50);
        ++visits[static_cast<std::size_t>(300 * a + b)];
      });
    });
    for (const auto& v : visits) ASSERT_EQ(v.load(), 1);
  }
}

TEST(Parallel, SlotsAreDifferentAtAnyTime) {
  for (const int threads : kThreads) {
    const ThreadScope scope(threads);
    std::vector<std::atomic<int>> users(16);
    std::atomic<bool> isShared{false};
    for (int round = 0; round < 20; ++round)
      parallelShare(8, [&](int slot) {
        ASSERT_LT(slot, 8);
        if (users[static_cast<std::size_t>(slot)]++ != 0) isShared = true;
        busy(300);
        --users[static_cast<std::size_t>(slot)];
      });
    EXPECT_FALSE(isShared);
  }
}

TEST(Parallel, TheFirstExceptionReachesTheCaller) {
  for (const int threads : kThreads) {
    const ThreadScope scope(threads);
    for (int round = 0; round < 20; ++round) {
      std::string what;
      try {
        parallelFor(1000, 1, [&](int i) {
          if (i >= 40 && i % 3 == 1) throw std::runtime_error(std::to_string(i));
        });
      } catch (const std::runtime_error& e) {
        what = e.what();
      }
      ASSERT_EQ(what, "40");
    }
    int sum = 0;  // and the threads still work
    parallelInvoke({[&] { sum = 1; }, [] {}});
    EXPECT_EQ(sum, 1);
  }
}

#ifndef HGP_NO_THREADS  // what needs threads of its own, or pieces that are counted
TEST(Parallel, ThreadsOfTheCallerMayHaveScopesOfTheirOwn) {
  std::vector<std::thread> callers;
  std::atomic<int> sum{0};
  for (int c = 0; c < 4; ++c)
    callers.emplace_back([&] {
      const ThreadScope scope(3);
      for (int round = 0; round < 20; ++round) parallelFor(100, 1, [&](int) { ++sum; });
    });
  for (std::thread& t : callers) t.join();
  EXPECT_EQ(sum, 4 * 20 * 100);
}

TEST(Parallel, ObservedWorkIsDoneByOneThreadPieceByPiece) {
  struct Counter : WorkObserver {
    void workBegins() override { ++works, ++open; }
    void workEnds() override { --open; }
    void pieceBegins(int) override { ++pieces, ++open; }
    void pieceEnds(int, int) override { --open; }
    int works = 0, pieces = 0, open = 0;
  } counter;
  const ThreadScope scope(4);
  int sum = 0;
  {
    const ObservedWork observed(counter);
    const auto here = std::this_thread::get_id();
    parallelFor(10, 5, [&](int) {
      parallelFor(3, 1, [&](int) { sum += std::this_thread::get_id() == here; });
    });
  }
  EXPECT_EQ(sum, 30);
  EXPECT_EQ(counter.works, 1 + 10);
  EXPECT_EQ(counter.pieces, 2 + 30);
  EXPECT_EQ(counter.open, 0);
  parallelFor(10, 1, [](int) {});
  EXPECT_EQ(counter.works, 11);  // no longer observed
}
#endif

TEST(Parallel, ResultsAreTakenInOrder) {
  for (const int threads : kThreads) {
    const ThreadScope scope(threads);
    std::vector<int> order(200), taken;
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(7));
    InOrder results(order, 200, [&](int i) { taken.push_back(i); });
    parallelFor(200, 1, [&](int i) {
      busy(i);
      results.finish(i);
    });
    EXPECT_EQ(taken, order);
  }
}

/// A forest in postorder with random shape; some costs are negative.
struct Forest {
  std::vector<int> parent;
  std::vector<double> cost;
};
Forest randomForest(int count, unsigned seed) {
  std::mt19937 random(seed);
  Forest forest;
  std::vector<int> roots;
  for (int t = 0; t < count; ++t) {
    forest.parent.push_back(-1);
    forest.cost.push_back(random() % 9 == 0 ? -1.0 : 100.0 * static_cast<double>(random() % 2000));
    const std::size_t taken = std::min<std::size_t>(roots.size(), random() % 3);
    for (std::size_t i = 0; i < taken; ++i) {
      forest.parent[static_cast<std::size_t>(roots.back())] = t;
      roots.pop_back();
    }
    roots.push_back(t);
  }
  return forest;
}

TEST(ForestWork, ChildrenAreVisitedBeforeParentsOrAfter) {
  for (const int threads : kThreads) {
    const ThreadScope scope(threads);
    for (unsigned seed = 0; seed < 10; ++seed) {
      const Forest forest = randomForest(400, seed);
      const ForestWork work(forest.parent, forest.cost);
      for (const bool isUp : {true, false}) {
        std::vector<std::atomic<int>> visits(400);
        std::atomic<bool> isEarly{false};
        const auto visit = [&](int t, int slot) {
          ASSERT_LT(slot, work.slots());
          busy(100);
          for (int c = 0; c < 400; ++c) {
            const bool isChild = forest.parent[static_cast<std::size_t>(c)] == t &&
                                 forest.cost[static_cast<std::size_t>(c)] >= 0;
            if (isChild && (visits[static_cast<std::size_t>(c)] == 1) != isUp) isEarly = true;
          }
          ++visits[static_cast<std::size_t>(t)];
        };
        if (isUp) {
          const auto good = [&](int t, int slot) {
            visit(t, slot);
            return true;
          };
          EXPECT_EQ(work.climb(good), -1);
        } else {
          work.descend(visit);
        }
        EXPECT_FALSE(isEarly);
        for (std::size_t t = 0; t < 400; ++t)
          ASSERT_EQ(visits[t], forest.cost[t] >= 0 ? 1 : 0) << threads << ' ' << seed << ' ' << t;
      }
    }
  }
}

TEST(ForestWork, TheFirstFailureIsThatOfOneThread) {
  const auto fails = [](int t) { return t % 50 == 37 || t == 311; };
  for (const int threads : kThreads) {
    const ThreadScope scope(threads);
    for (unsigned seed = 0; seed < 20; ++seed) {
      Forest forest = randomForest(400, seed);
      for (double& cost : forest.cost) cost = 1000.0;
      for (std::size_t t = 0; t < 137; ++t)
        if (fails(static_cast<int>(t))) forest.cost[t] = -1.0;
      const ForestWork work(forest.parent, forest.cost);
      EXPECT_EQ(work.climb([&](int t, int) {
        busy(50);
        return !fails(t);
      }),
                137);
    }
  }
}

}  // namespace
}  // namespace hgp

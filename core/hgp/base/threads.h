// How many threads the calls of the library may use.  Role: the one setting of a program that includes it.
#pragma once

#include <memory>

namespace hgp {

inline constexpr int kMaxThreads = 16;

/// The processors that this process may run on, from 1 to kMaxThreads; 1 in builds without threads (HGP_THREADS=OFF,
/// WebAssembly).
int availableThreads();

/// For the whole process: the number of threads of calls of hgp::api (and so of hgp/eigen.h) that are in no ThreadScope.
/// @param threads  as of ThreadScope; without a call it is 0
void setThreads(int threads);
int defaultThreads();

/// While it exists, calls of the library that are made by the thread that constructed it are computed by up to so many
/// threads, of which that one is the first; their results are bit by bit the same for every number. The others are
/// started when they are first needed and have ended when the destructor returns: no thread of the library outlives the
/// scope, and none calls a function of the program, such as a Progress.
///
///   const hgp::ThreadScope scope(4);
///   session.parametrize(…);
///
/// Without one, every call of hgp::api has a scope of its own, of defaultThreads(); the other functions of hgp::core
/// then use the calling thread alone. A scope inside another one, on the same thread, takes its
/// place for as long as it exists. Programs that call the library from many threads of their own want setThreads(1).
class ThreadScope {
 public:
  /// @param threads  1 … kMaxThreads, more counts as kMaxThreads; 0 or less: availableThreads()
  explicit ThreadScope(int threads);
  ~ThreadScope();
  ThreadScope(const ThreadScope&) = delete;
  ThreadScope& operator=(const ThreadScope&) = delete;

  /// Whether the calling thread is within a scope.
  static bool isOpen();

  class Team;  // of parallel.cpp

 private:
  std::unique_ptr<Team> team_;
  Team* outer_;
};

}  // namespace hgp

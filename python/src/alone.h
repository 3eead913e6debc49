// One call at a time on one object, without the GIL.  Role: how the threads of Python use the core.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "failures.h"
#include "hgp/api/session.h"

namespace hgp::python {

namespace py = pybind11;

/// A lock that is never waited for while the GIL is held, because its holder may need the GIL to report progress.
class Alone {
 public:
  /// Runs `work` without the GIL and without other calls on the same object. @pre the GIL is held
  template <class Work>
  auto run(Work work) -> decltype(work()) {
    if (owner_ == std::this_thread::get_id())
      raiseUsage("a progress function cannot call the mesh that it reports on");
    const py::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    const Owner owner(owner_);
    return work();
  }

 private:
  using Id = std::atomic<std::thread::id>;
  struct Owner {
    explicit Owner(Id& held) : id(held) { id = std::this_thread::get_id(); }
    ~Owner() { id = std::thread::id(); }
    Owner(const Owner&) = delete;
    Owner& operator=(const Owner&) = delete;
    Id& id;
  };

  std::mutex mutex_;
  Id owner_{std::thread::id()};
};

/// While it lives, the whole process computes with or without processor-specific instructions, as asked; waits until
/// no call that asks for the other is running. @pre the GIL is not held
class Arithmetic {
 public:
  explicit Arithmetic(bool isReproducible) {
    State& s = state();
    std::unique_lock lock(s.mutex);
    ++depth();
    s.changed.wait(lock, [&] { return s.running == 0 || s.isReproducible == isReproducible; });
    if (s.running++ == 0) {
      s.isReproducible = isReproducible;
      api::setReproducible(isReproducible);
    }
  }
  ~Arithmetic() {
    State& s = state();
    --depth();
    {
      const std::lock_guard lock(s.mutex);
      --s.running;
    }
    s.changed.notify_all();
  }
  /// Raises UsageError where waiting would never end: inside a progress function of a call that asks for the other.
  /// @pre the GIL is held
  static void check(bool isReproducible) {
    const State& s = state();
    if (depth() > 0 && s.isReproducible != isReproducible)
      raiseUsage(
          "inside a progress function, `reproducible` must be that of the call it reports on");
  }
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;

 private:
  struct State {
    std::mutex mutex;
    std::condition_variable changed;
    int running = 0;
    bool isReproducible = false;
  };
  /// Calls of this thread that are running.
  static int& depth() {
    static thread_local int count = 0;
    return count;
  }
  static State& state() {
    static State only;
    return only;
  }
};

}  // namespace hgp::python

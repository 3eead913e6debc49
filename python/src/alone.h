// One call at a time on one object, without the GIL.  Role: how the threads of Python use the core.
#pragma once

#include <pybind11/pybind11.h>

#include <condition_variable>
#include <mutex>

#include "hgp/api/session.h"

namespace hgp::python {

namespace py = pybind11;

/// A lock that is never waited for while the GIL is held, because its holder may need the GIL to report progress.
class Alone {
 public:
  /// Runs `work` without the GIL and without other calls on the same object. @pre the GIL is held
  template <class Work>
  auto run(Work work) -> decltype(work()) {
    const py::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    return work();
  }

 private:
  std::mutex mutex_;
};

/// While it lives, the whole process computes with or without processor-specific instructions, as asked; waits until
/// no call that asks for the other is running. @pre the GIL is not held
class Arithmetic {
 public:
  explicit Arithmetic(bool isReproducible) {
    State& s = state();
    std::unique_lock lock(s.mutex);
    s.changed.wait(lock, [&] { return s.running == 0 || s.isReproducible == isReproducible; });
    if (s.running++ == 0) {
      s.isReproducible = isReproducible;
      api::setReproducible(isReproducible);
    }
  }
  ~Arithmetic() {
    State& s = state();
    {
      const std::lock_guard lock(s.mutex);
      --s.running;
    }
    s.changed.notify_all();
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
  static State& state() {
    static State only;
    return only;
  }
};

}  // namespace hgp::python

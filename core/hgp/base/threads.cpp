#include "hgp/base/threads.h"

#include <algorithm>
#include <atomic>

#include "hgp/base/parallel.h"

#ifndef HGP_NO_THREADS
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#endif

namespace hgp {

#ifdef HGP_NO_THREADS

class ThreadScope::Team {
 public:
  explicit Team(int /*limit*/) {}
  static int limit() { return 1; }
  static void share(int /*most*/, const std::function<void(int)>& work) { work(0); }
};

int availableThreads() { return 1; }

#else

int availableThreads() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxThreads);
}

/// The threads of one scope. Work is offered in a list; idle threads take part in the latest.
class ThreadScope::Team {
 public:
  explicit Team(int limit) : limit_(limit) {}
  ~Team() {
    {
      const std::lock_guard lock(mutex_);
      isOver_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int limit() const { return limit_; }

  void share(int most, const std::function<void(int)>& work) {
    Offer offer(work, std::min(most, limit_));
    if (offer.places <= 1) return work(0);
    std::unique_lock lock(mutex_);
    startThreads(offer.places - 1);
    offers_.push_back(&offer);
    lock.unlock();
    changed_.notify_all();
    takePart(offer, 0);
    lock.lock();
    std::erase(offers_, &offer);
    // What remains may offer parts of its own work.
    while (offer.running > 0) {
      if (Offer* other = openOffer())
        join(*other, lock);
      else
        changed_.wait(lock);
    }
    lock.unlock();
    if (offer.error) std::rethrow_exception(offer.error);
  }

 private:
  struct Offer {
    Offer(const std::function<void(int)>& itsWork, int itsPlaces)
        : work(itsWork), places(itsPlaces) {}
    const std::function<void(int)>& work;
    int places;     // slots
    int taken = 1;  // of them
    int running = 0;
    std::exception_ptr error;
  };

  Offer* openOffer() const {
    for (auto it = offers_.rbegin(); it != offers_.rend(); ++it)
      if ((*it)->taken < (*it)->places) return *it;
    return nullptr;
  }

  void takePart(Offer& offer, int slot) {
    try {
      offer.work(slot);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!offer.error) offer.error = std::current_exception();
    }
  }

  /// Takes a place in the offer; the lock is released meanwhile.
  void join(Offer& offer, std::unique_lock<std::mutex>& lock) {
    const int slot = offer.taken++;
    ++offer.running;
    lock.unlock();
    takePart(offer, slot);
    lock.lock();
    if (--offer.running == 0) changed_.notify_all();
  }

  void startThreads(int count) {
    try {
      while (static_cast<int>(threads_.size()) < count) threads_.emplace_back([this] { help(); });
    } catch (const std::system_error&) {
      limit_ = static_cast<int>(threads_.size()) + 1;  // the system has no more
    }
  }

  void help();

  int limit_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::thread> threads_;
  std::vector<Offer*> offers_;
  bool isOver_ = false;
};

#endif

namespace {

std::atomic<int> threadsWithoutScope{0};

// The team of the calling thread.
ThreadScope::Team*& teamHere() {
  thread_local ThreadScope::Team* team = nullptr;
  return team;
}

}  // namespace

#ifndef HGP_NO_THREADS
void ThreadScope::Team::help() {
  teamHere() = this;
  std::unique_lock lock(mutex_);
  while (!isOver_) {
    if (Offer* offer = openOffer())
      join(*offer, lock);
    else
      changed_.wait(lock);
  }
}
#endif

void setThreads(int threads) { threadsWithoutScope = threads; }
int defaultThreads() { return threadsWithoutScope; }

ThreadScope::ThreadScope(int threads)
    : team_(std::make_unique<Team>(threads <= 0 ? availableThreads()
                                                : std::min(threads, kMaxThreads))),
      outer_(teamHere()) {
  teamHere() = team_.get();
}

ThreadScope::~ThreadScope() { teamHere() = outer_; }

bool ThreadScope::isOpen() { return teamHere() != nullptr; }

#ifndef HGP_NO_THREADS
int threadCount() { return teamHere() == nullptr ? 1 : teamHere()->limit(); }
#endif

void parallelShare(int most, const std::function<void(int slot)>& work) {
  if (most <= 1 || teamHere() == nullptr) return work(0);
  teamHere()->share(most, work);
}

}  // namespace hgp

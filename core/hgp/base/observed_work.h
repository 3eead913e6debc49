// Shared work that is observed instead of being shared.  Role: what bench/threads measures on one processor.
#pragma once

namespace hgp {

/// Is told when shared work and its pieces begin and end; pieces may have shared work within.
class WorkObserver {
 public:
  virtual ~WorkObserver() = default;
  virtual void workBegins() = 0;
  virtual void workEnds() = 0;
  virtual void pieceBegins(int piece) = 0;
  /// @param next  the piece of the same work that waits for this one, −1: none
  virtual void pieceEnds(int piece, int next) = 0;
};

/// While it exists, work that is shared on this thread is cut into pieces as for the threads of its ThreadScope, but all
/// done by this thread.
class ObservedWork {
 public:
  explicit ObservedWork(WorkObserver& observer);
  ~ObservedWork();
  ObservedWork(const ObservedWork&) = delete;
  ObservedWork& operator=(const ObservedWork&) = delete;

  /// Null where nothing is observed.
  static WorkObserver* here();
};

}  // namespace hgp

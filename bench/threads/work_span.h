// Work and span of shared work.  Role: what bench/threads predicts for other numbers of threads.
#pragma once

#include <array>
#include <vector>

#include "hgp/base/observed_work.h"

namespace hgp::bench {

/// Work is the processor time of all pieces, span that of the longest chain of pieces of which each waits for the one before.
struct WorkSpan {
  double work = 0.0, span = 0.0;
};

/// Measures one run. What is not shared is one piece; shared work within a piece adds to that piece.
class WorkSpanMeter : public WorkObserver {
 public:
  WorkSpanMeter();
  void workBegins() override;
  void workEnds() override;
  void pieceBegins(int piece) override;
  void pieceEnds(int piece, int next) override;

  /// To be called at the end of the run.
  WorkSpan total();
  /// Seconds with so many threads: at least max(W/P, S) and at most W/P + (1 − 1/P) S, summed over the shared works.
  std::array<double, 2> seconds(int threads) const;

 private:
  struct Open {
    WorkSpan sum;
    std::vector<double> waited;  ///< of a work: what each piece waited for
  };
  void tick();

  std::vector<Open> open_{1};     // the run, then in turn a work and a piece of it
  std::vector<WorkSpan> shared_;  // the works that are in no piece
  double last_;
};

}  // namespace hgp::bench

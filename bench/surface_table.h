// A table that grows by a surface at a time.  Role: each in a process of its own, printed when it is known.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "surface_rows.h"

namespace hgp::bench {

class SurfaceTable {
 public:
  /// @param lines  Markdown of a row; @param cpuSeconds  that a row may take
  SurfaceTable(const std::string& head, std::string (*lines)(const SurfaceRow&), double cpuSeconds);

  /// What work() returns, or `blank` with the reason why there is nothing. Rows without maps and without a
  /// reason are left out.
  void add(SurfaceRow blank, const std::function<SurfaceRow()>& work);

  const std::vector<SurfaceRow>& rows() const { return rows_; }
  const std::string& text() const { return text_; }

 private:
  std::string (*lines_)(const SurfaceRow&);
  double cpuSeconds_;
  std::string text_;
  std::vector<SurfaceRow> rows_;
};

}  // namespace hgp::bench

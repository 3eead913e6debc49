// A table to which one surface is added at a time.  Role: measures each in a separate process and prints its rows
// immediately.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "surface_rows.h"

namespace hgp::bench {

class SurfaceTable {
 public:
  /// @param lines  Markdown of a row; @param cpuSeconds  limit for a row
  SurfaceTable(const std::string& head, std::string (*lines)(const SurfaceRow&), double cpuSeconds);

  /// Adds the result of work() or, if it fails, `blank` with the reason. Rows without maps and without a
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

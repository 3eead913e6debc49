// The rows of a PLY body with the position of every property.  Role: reads attributes besides the geometry, and
// lets patches keep every other byte.
#pragma once

#include <string_view>
#include <vector>

#include "hgp/io/polygon/ply_header.h"
#include "hgp/text/text.h"

namespace hgp::io {

/// One row: property p has the bytes [begin[p], end[p]) of the body and the numbers with indices first[p] …
/// first[p + 1] − 1 (for a list, without its length).
struct PlyRow {
  std::vector<std::size_t> begin, end, first;
  std::vector<double> numbers;
};

/// @pre the body has been read once without an error
class PlyRowReader {
 public:
  PlyRowReader(std::string_view body, PlyEncoding encoding)
      : body_(body), words_(body), encoding_(encoding) {}
  /// The next row of this element; false where the body ends.
  bool next(const PlyElement& element, PlyRow& row);

 private:
  bool take(PlyType type, double& out);

  std::string_view body_;
  text::WordReader words_;
  PlyEncoding encoding_;
  std::size_t begin_ = 0, end_ = 0;  ///< of the value read last
};

}  // namespace hgp::io

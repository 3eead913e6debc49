// Text PLY whose rows have more values than the header declares.  Role: such files are read line by line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hgp/io/polygon/ply_header.h"

namespace hgp::io {

struct PlyTrimmed {
  std::string text;  ///< the whole file
  int lines = 0;     ///< that were cut
};

/// The text with every row cut after the values that the header declares. Empty unless every row is a line of its own
/// and one of the first lines of the elements is too long.
std::optional<PlyTrimmed> trimmedPly(std::string_view text, const PlyHeader& header);

}  // namespace hgp::io

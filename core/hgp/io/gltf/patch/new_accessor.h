// An accessor of the patched file.  Role: the unit in which GltfWriter plans new data.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "hgp/io/written.h"

namespace hgp::io {

/// New contents of an accessor: of the old one, in place, if nothing else reads it, and of a new one otherwise.
struct GltfNewAccessor {
  int index = -1;    ///< of the accessor in the written file
  int node = -1;     ///< the old accessor, edited in place; −1: a new one
  std::string base;  ///< text from which a new one is made; "{}" if there is no old one
  std::map<std::string, std::string> members;  ///< members to set in it
  Bytes data;
  int target = 0;  ///< of the view: 34962 vertices, 34963 indices, 0 neither
  std::uint64_t stride = 0;
  int oldView = -1;
  int sharedWith = -1;  ///< index in the plan of the accessor whose data contain this one's
  std::uint64_t sharedOffset = 0;
  int sparseIndices = -1, sparseValues = -1;  ///< indices in the plan
};

}  // namespace hgp::io

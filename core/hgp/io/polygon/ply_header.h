// The header of a PLY file: which numbers follow and how they are stored.  Role: used by ply.cpp, ply_document.cpp
// and ply_edit.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hgp/base/result.h"

namespace hgp::io {

enum class PlyEncoding { kText, kLittle, kBig };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };
/// What a property is used for.
enum class PlyRole {
  kNone,
  kX,
  kY,
  kZ,
  kU,
  kV,
  kCorners,
  kUvList,
  kNormalX,
  kNormalY,
  kNormalZ,
  kRed,
  kGreen,
  kBlue,
  kAlpha
};
enum class PlyLineEnd { kNew, kOld };  ///< "\n" or "\r\n"; "\r" alone

struct PlyProperty {
  std::string name;
  PlyRole role = PlyRole::kNone;
  PlyType type = PlyType::kFloat32;
  bool isList = false;
  PlyType countType = PlyType::kUint8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kText;
  std::vector<PlyElement> elements;
  std::size_t bodyOffset = 0;
  PlyLineEnd lineEnd = PlyLineEnd::kNew;
  int lineCount = 0;     ///< lines before the body
  int unknownLines = 0;  ///< with other keywords, skipped: comments that are not marked as such
};

Result<PlyHeader> readPlyHeader(std::string_view text);
std::size_t plySize(PlyType type);
/// The value of little-endian bytes.
double plyNumber(PlyType type, const unsigned char* bytes);

}  // namespace hgp::io

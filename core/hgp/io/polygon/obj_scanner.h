// Reads the lines of an OBJ text.  Role: scanObj(); one scanner for the whole text, or one for each of its pieces.
#pragma once

#include <string>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/io/polygon/not_finite.h"
#include "hgp/io/polygon/obj_text.h"
#include "hgp/text/text.h"

namespace hgp::io {

class ObjScanner {
 public:
  ObjScanner(std::string_view text, std::uint64_t maxTriangles)
      : text_(text), maxTriangles_(maxTriangles), eol_(text::lineEndOf(text)) {}

  Result<ObjText> scan();

 private:
  // The whole text (obj_scan.cpp).
  std::size_t endOfLine(std::size_t position) const;
  bool scanPieces(std::size_t begin);
  void take(const ObjScanner& next);
  bool checkRanges();
  void addNotes();

  // Its lines (obj_scanner.cpp); these return false where a line is malformed, which failure_ then says.
  bool scanLines(std::size_t begin, std::size_t end);
  void reserve(std::size_t bytes);
  bool takeLine();
  const char* lineEnd(const char* p) const;
  std::size_t nextLine(const char* end) const;
  static bool isContinued(const char* begin, const char* end);
  bool takeStatement(const char* p, const char* end, const char* original);
  bool takeComment(const char* p, const char* end, const char* original);
  bool takeVertex(const char* p, const char* end);
  bool takeUv(const char* p, const char* end, const TextSpan& span);
  void addUvLines(const TextSpan& span);
  bool takeIndex(const char*& p, const char* end, std::size_t count, int& out);
  bool takeUvIndex(const char*& p, const char* end, int& out);
  bool takeFace(const char* p, const char* end, const TextSpan& span);
  bool skipFace(std::size_t first, const TextSpan& span);
  bool fail(const std::string& message);

  std::string_view text_;
  std::uint64_t maxTriangles_;
  char eol_;
  ObjText out_;
  Failure failure_;
  std::string joined_;
  std::vector<NotFiniteVertex> notFinite_;
  std::size_t position_ = 0;
  std::size_t lineBegin_ = 0;
  std::uint64_t triangles_ = 0;
  bool hasUv_ = false;
  bool hasCommands_ = false;
  bool isRelative_ = false;  ///< an index counts backwards
  int skippedFaces_ = 0, missingUv_ = 0;
};

}  // namespace hgp::io

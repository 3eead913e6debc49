#include "hgp/io/polygon/ply_lines.h"

#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// The lines of a PLY body that are rows.
class RowLines {
 public:
  RowLines(std::string_view text, std::size_t from)
      : text_(text), end_(text::lineEndOf(text)), next_(from) {}

  /// Moves to the next row; false at the end.
  bool next() {
    while (next_ < text_.size()) {
      begin_ = next_;
      next_ = std::min(text_.find(end_, begin_), text_.size() - 1) + 1;
      const std::string_view line = text_.substr(begin_, next_ - begin_);
      const std::string_view first = text::WordReader(line).next();
      if (!first.empty() && first != "comment" && first != "obj_info") return true;
    }
    return false;
  }
  std::string_view line() const { return text_.substr(begin_, next_ - begin_); }
  std::size_t begin() const { return begin_; }

 private:
  std::string_view text_;
  char end_;
  std::size_t begin_ = 0, next_;
};

/// The length of the part of a line that has the declared values; nullopt if it has fewer. `isLonger`: it has more.
std::optional<std::size_t> usedLength(std::string_view line, const PlyElement& element,
                                      bool& isLonger) {
  text::WordReader words(line);
  std::string_view last;
  for (const PlyProperty& property : element.properties) {
    double count = 1;
    if (property.isList) {
      if (!words.nextDouble(count) || count < 0) return std::nullopt;
      last = words.word();
    }
    for (double i = 0; i < count; ++i) {
      last = words.next();
      if (last.empty()) return std::nullopt;
    }
  }
  isLonger = !words.next().empty();
  return static_cast<std::size_t>(last.data() + last.size() - line.data());
}

bool isAnyFirstRowLonger(std::string_view text, const PlyHeader& header) {
  RowLines lines(text, header.bodyOffset);
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!lines.next()) return false;
      bool isLonger = false;
      if (i == 0 && usedLength(lines.line(), element, isLonger) && isLonger) return true;
    }
  }
  return false;
}

}  // namespace

std::optional<PlyTrimmed> trimmedPly(std::string_view text, const PlyHeader& header) {
  if (header.encoding != PlyEncoding::kText || !isAnyFirstRowLonger(text, header))
    return std::nullopt;
  PlyTrimmed out;
  out.text.reserve(text.size());
  std::size_t done = 0;
  RowLines lines(text, header.bodyOffset);
  for (const PlyElement& element : header.elements) {
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      bool isLonger = false;
      if (!lines.next()) return std::nullopt;
      const auto length = usedLength(lines.line(), element, isLonger);
      if (!length) return std::nullopt;
      if (!isLonger) continue;
      out.text += text.substr(done, lines.begin() + *length - done);
      done = lines.begin() + lines.line().find_last_not_of("\r\n") + 1;
      ++out.lines;
    }
  }
  out.text += text.substr(done);
  return out;
}

}  // namespace hgp::io

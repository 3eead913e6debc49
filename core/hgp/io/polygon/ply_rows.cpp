#include "hgp/io/polygon/ply_rows.h"

namespace hgp::io {

bool PlyRowReader::take(PlyType type, double& out) {
  if (encoding_ == PlyEncoding::kText) {
    std::string_view word = words_.next();
    while (word == "comment" || word == "obj_info") {
      words_.restOfLine();
      word = words_.next();
    }
    const char* p = word.data();
    if (word.empty() || !text::readAnyDouble(p, p + word.size(), out)) return false;
    begin_ = static_cast<std::size_t>(word.data() - body_.data());
    end_ = begin_ + word.size();
    return true;
  }
  const std::size_t size = plySize(type);
  if (body_.size() - end_ < size) return false;
  unsigned char raw[8] = {};
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t from = encoding_ == PlyEncoding::kLittle ? i : size - 1 - i;
    raw[i] = static_cast<unsigned char>(body_[end_ + from]);
  }
  begin_ = end_;
  end_ += size;
  out = plyNumber(type, raw);
  return true;
}

bool PlyRowReader::next(const PlyElement& element, PlyRow& row) {
  row.begin.clear();
  row.end.clear();
  row.numbers.clear();
  row.first.assign(1, 0);
  for (const PlyProperty& property : element.properties) {
    double x = 0;
    if (!take(property.isList ? property.countType : property.type, x)) return false;
    row.begin.push_back(begin_);
    if (property.isList) {
      const auto length = static_cast<std::size_t>(x > 0 ? x : 0);
      for (std::size_t i = 0; i < length; ++i) {
        if (!take(property.type, x)) return false;
        row.numbers.push_back(x);
      }
    } else {
      row.numbers.push_back(x);
    }
    row.end.push_back(end_);
    row.first.push_back(row.numbers.size());
  }
  return true;
}

}  // namespace hgp::io

#include "hgp/api/json/spliced_text.h"

#include <algorithm>

#include "hgp/base/check.h"

namespace hgp::api {
namespace {

constexpr std::string_view kIndent = "  ";  // of one level, as in textOf()

/// The document, indented by more levels, without its last line end.
void appendIndented(std::string_view document, std::size_t levels, std::string& out) {
  if (document.ends_with('\n')) document.remove_suffix(1);
  while (!document.empty()) {
    const std::size_t end = std::min(document.find('\n'), document.size() - 1) + 1;
    out += document.substr(0, end);
    document.remove_prefix(end);
    for (std::size_t i = 0; i < levels && !document.empty(); ++i) out += kIndent;
  }
}

std::size_t indentedSize(const std::string& document, std::size_t levels) {
  const auto lines = static_cast<std::size_t>(std::count(document.begin(), document.end(), '\n'));
  return document.size() + levels * kIndent.size() * lines;
}

/// A little more for numbers that are longer than the first ones.
std::size_t withRoom(std::size_t size) { return size + size / 16; }

}  // namespace

void SplicedDocument::appendTo(std::string& out, std::size_t levels) const {
  const std::string whole = textOf(json);
  std::vector<std::size_t> at(members.size());
  for (std::size_t i = members.size(), before = whole.size(); i-- > 0; before = at[i]) {
    at[i] = whole.rfind("\"" + members[i].mark + "\"", before);
    HGP_CHECK(at[i] != std::string::npos, "a member is not where it is to be written");
  }
  const std::string_view text = whole;
  std::size_t from = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    appendIndented(text.substr(from, at[i] - from), levels, out);
    members[i].append(out, levels);
    from = at[i] + members[i].mark.size() + 2;
  }
  appendIndented(text.substr(from), levels, out);
}

std::size_t SplicedDocument::size() const {
  std::size_t size = 4096;
  for (const SplicedMember& member : members) size += member.size;
  return size;
}

std::string SplicedDocument::text() const {
  std::string out;
  out.reserve(size());
  appendTo(out, 0);
  out += '\n';
  return out;
}

SplicedMember documentMember(std::string mark, SplicedDocument document) {
  const std::size_t size = withRoom(withRoom(document.size()));  // indented once more
  return {std::move(mark), size, [document = std::move(document)](std::string& out, std::size_t n) {
            document.appendTo(out, n + 1);
          }};
}

SplicedMember textMember(std::string mark, const std::string& document) {
  return {std::move(mark), indentedSize(document, 1),
          [&document](std::string& out, std::size_t n) { appendIndented(document, n + 1, out); }};
}

SplicedMember arrayMember(std::string mark, std::size_t count,
                          std::function<Json(std::size_t)> element) {
  const std::size_t first = count == 0 ? 0 : indentedSize(textOf(element(0)), 2);
  const auto append = [count, element = std::move(element)](std::string& out, std::size_t levels) {
    std::string line = "\n";
    for (std::size_t i = 0; i < levels + 1; ++i) line += kIndent;
    out += '[';
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) out += ',';
      (out += line) += kIndent;
      appendIndented(textOf(element(i)), levels + 2, out);
    }
    if (count > 0) out += line;
    out += ']';
  };
  return {std::move(mark), withRoom(count * first), append};
}

std::string lastDocument(std::string_view text, std::string_view key) {
  const std::string start = "\n  \"" + std::string(key) + "\": ";
  const std::size_t at = text.rfind(start);
  if (at == std::string_view::npos) return {};
  text.remove_prefix(at + start.size());
  if (text.ends_with("\n}\n")) text.remove_suffix(3);
  std::string out;
  out.reserve(text.size() + 1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    out += text[i];
    if (text[i] == '\n') i += kIndent.size();
  }
  out += '\n';
  return out;
}

}  // namespace hgp::api

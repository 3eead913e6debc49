#include "hgp/io/gltf/patch/splice.h"

#include <algorithm>

#include "hgp/base/stable_order.h"

namespace hgp::io {
namespace {

/// Offset of a child in the text, at its key if it has one.
std::size_t childBegin(const JsonNode& node) {
  return node.keyEnd > node.keyBegin ? node.keyBegin : node.begin;
}

}  // namespace

void JsonPatch::set(int object, std::string_view key, std::string raw) {
  const int member = json_.find(object, key);
  if (member >= 0) {
    replaced_[member] = std::move(raw);
  } else {
    members_[object][std::string(key)] = std::move(raw);
  }
}

void JsonPatch::remove(int node) {
  // Edits recorded inside the removed value must not be applied.
  int last = node;
  while (last + 1 < json_.size() && json_.node(last + 1).begin < json_.node(node).end) ++last;
  const auto forget = [&](auto& edits) {
    edits.erase(edits.lower_bound(node), edits.upper_bound(last));
  };
  forget(replaced_);
  forget(removed_);
  forget(appended_);
  forget(members_);
  removed_.insert(node);
}

int JsonPatch::append(int array, std::string raw) {
  std::vector<std::string>& list = appended_[array];
  list.push_back(std::move(raw));
  return json_.node(array).count + static_cast<int>(list.size()) - 1;
}

bool JsonPatch::isEmptied(int container) const {
  if (appended_.count(container) > 0 || members_.count(container) > 0) return false;
  const std::vector<int> children = json_.children(container);
  return std::all_of(children.begin(), children.end(),
                     [&](int c) { return removed_.count(c) > 0; });
}

void JsonPatch::addRemovals(int container, std::vector<Edit>& edits) const {
  const std::vector<int> children = json_.children(container);
  std::size_t first = 0;
  while (first < children.size() && removed_.count(children[first]) > 0) ++first;
  if (first > 0) {
    const std::size_t end = first < children.size() ? childBegin(json_.node(children[first]))
                                                    : json_.node(children.back()).end;
    edits.push_back({childBegin(json_.node(children[0])), end, ""});
  }
  for (std::size_t i = first; i < children.size(); ++i) {
    if (removed_.count(children[i]) == 0) continue;
    edits.push_back({json_.node(children[i - 1]).end, json_.node(children[i]).end, ""});
  }
}

/// The text of new children, written after the old ones, each preceded by the same whitespace as the
/// container's first child, so that the layout in lines is kept.
std::string JsonPatch::joined(int container, const std::vector<std::string>& items) const {
  std::string blanks;
  bool needsComma = false;
  const std::vector<int> children = json_.children(container);
  if (!children.empty()) {
    const std::size_t begin = json_.node(container).begin + 1;
    blanks = json_.text().substr(begin, childBegin(json_.node(children[0])) - begin);
    needsComma = std::any_of(children.begin(), children.end(),
                             [&](int c) { return removed_.count(c) == 0; });
  }
  std::string out;
  for (const std::string& item : items) {
    if (needsComma) out += "," + blanks;
    out += item;
    needsComma = true;
  }
  return out;
}

std::string JsonPatch::text() const {
  std::vector<Edit> edits;
  std::set<int> containers;
  for (int node : removed_) containers.insert(json_.node(node).parent);
  for (int container : containers) addRemovals(container, edits);
  for (const auto& [node, raw] : replaced_) {
    edits.push_back({json_.node(node).begin, json_.node(node).end, raw});
  }
  const auto insert = [&](int container, const std::vector<std::string>& items) {
    const std::vector<int> children = json_.children(container);
    const std::size_t at =
        children.empty() ? json_.node(container).begin + 1 : json_.node(children.back()).end;
    edits.push_back({at, at, joined(container, items)});
  };
  for (const auto& [array, items] : appended_) insert(array, items);
  for (const auto& [object, members] : members_) {
    std::vector<std::string> items;
    for (const auto& [key, raw] : members) items.push_back(quoteJson(key) + ":" + raw);
    insert(object, items);
  }
  // An insertion comes after an edit that ends where it begins.
  sortStably(edits, [](const Edit& a, const Edit& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
  });
  std::string out;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    out.append(json_.text(), at, edit.begin - at);
    out += edit.text;
    at = edit.end;
  }
  out.append(json_.text(), at);
  return out;
}

}  // namespace hgp::io

// Edits of a JSON text that leave every other byte as it is.  Role: numbers nobody touched keep
// their spelling, keys their order, lines their indentation.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/io/gltf/gltf_json.h"

namespace hgp::io {

/// Edits are recorded against the original nodes and applied at once by text(). Values that are
/// replaced or removed must not be edited inside as well.
class JsonPatch {
 public:
  explicit JsonPatch(const JsonText& json) : json_(json) {}

  /// Another value in the same place.
  void replace(int node, std::string raw) { replaced_[node] = std::move(raw); }
  /// Replaces a member, or adds it behind the others.
  void set(int object, std::string_view key, std::string raw);
  /// Takes a member or element away, with its comma.
  void remove(int node);
  /// Adds an element; returns the index it will have (elements must then not be removed).
  int append(int array, std::string raw);
  bool isEmptied(int container) const;

  std::string text() const;

 private:
  struct Edit {
    std::size_t begin, end;
    std::string text;
  };
  void addRemovals(int container, std::vector<Edit>& edits) const;
  std::string joined(int container, const std::vector<std::string>& items) const;

  const JsonText& json_;
  std::map<int, std::string> replaced_;
  std::set<int> removed_;
  std::map<int, std::vector<std::string>> appended_;           ///< elements by array
  std::map<int, std::map<std::string, std::string>> members_;  ///< new members by object
};

}  // namespace hgp::io

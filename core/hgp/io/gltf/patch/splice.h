// Edits of a JSON text that leave every other byte unchanged.  Role: untouched numbers keep
// their spelling, keys their order and lines their indentation.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/io/gltf/json/json.h"

namespace hgp::io {

/// Edits refer to the original nodes and are all applied by text(). A value that is replaced or removed must
/// not also be edited inside.
class JsonPatch {
 public:
  explicit JsonPatch(const JsonText& json) : json_(json) {}

  /// Replaces the value, keeping its key and position.
  void replace(int node, std::string raw) { replaced_[node] = std::move(raw); }
  /// Replaces a member, or adds it after the others.
  void set(int object, std::string_view key, std::string raw);
  /// Removes a member or element, with its comma.
  void remove(int node);
  /// Adds an element and returns the index that it will have. @pre no element of `array` is removed
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

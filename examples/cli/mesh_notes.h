// Notes on the meshes of a file.  Role: what holds for many of them is printed once.
#pragma once

#include <string>
#include <vector>

namespace hgp::cli {

/// Notes with one code are of one kind, and a kind is one line.
class MeshNotes {
 public:
  void add(int mesh, const std::string& code, const std::string& text);
  /// In the order of their first mesh: "mesh 3: 2 edges …", "meshes 0 to 4, 7: …", and for other numbers
  /// "mesh 3: 2 edges …; likewise, with other numbers, meshes 5, 6".
  std::vector<std::string> lines() const;

 private:
  struct Kind {
    std::string text;
    std::string code;
    std::vector<int> meshes;  ///< with these numbers; ascending
    std::vector<int> others;  ///< with others; ascending
  };
  std::vector<Kind> notes_;
};

}  // namespace hgp::cli

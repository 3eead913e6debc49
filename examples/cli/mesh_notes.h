// Notes on the meshes of a file.  Role: what is said of many of them is said once.
#pragma once

#include <string>
#include <vector>

namespace hgp::cli {

class MeshNotes {
 public:
  void add(int mesh, const std::string& note);
  /// In the order of their first mesh: "mesh 3: …", "meshes 0 to 4, 7: …".
  std::vector<std::string> lines() const;

 private:
  struct Note {
    std::string text;
    std::vector<int> meshes;  ///< ascending
  };
  std::vector<Note> notes_;
};

}  // namespace hgp::cli

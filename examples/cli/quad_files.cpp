#include "quad_files.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

#include "hgp/base/counted.h"
#include "text_report.h"

namespace hgp::cli {

std::string objBeside(const std::string& output) {
  const std::filesystem::path path(output);
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension != ".glb") return "";
  return (path.parent_path() / (path.stem().string() + "-quads.obj")).string();
}

void reportQuads(const std::string& output, const api::QuadFile& quads) {
  std::fprintf(stderr, "  wrote %s: %d vertices, %s%s\n", printable(output).c_str(), quads.vertices,
               counted(quads.quads, "quad").c_str(),
               quads.clipped > 0 ? "; cells that the boundary cuts are left out" : "");
  if (const std::string beside = objBeside(output); !beside.empty()) {
    std::fprintf(stderr, "  wrote %s: the same as quads, which glTF does not have\n",
                 printable(beside).c_str());
  }
  if (quads.cuts > 0) {
    std::fprintf(stderr,
                 "  note: %s of quads %s cut lengthwise: otherwise more than one edge would join "
                 "%s, around "
                 "handles and cones one or two cells apart\n",
                 counted(quads.cuts, "strip").c_str(), quads.cuts == 1 ? "is" : "are",
                 counted(quads.multipleEdges, "pair of vertices", "pairs of vertices").c_str());
  }
  if (quads.replaced > 0) {
    std::fprintf(
        stderr,
        "  note: %s replaced by a vertex of valence 3, beside vertices of valence 3 and 5: "
        "otherwise "
        "more than one edge would join %s, around handles and cones one or two cells apart\n",
        counted(quads.replaced, "edge is", "edges are").c_str(),
        counted(quads.multipleEdges, "pair of vertices", "pairs of vertices").c_str());
  }
  if (quads.foldedInSpace > 0) {
    std::fprintf(stderr,
                 "  note: %s folded in space, where the surface bends more than a cell can follow; "
                 "more cells lower that\n",
                 counted(quads.foldedInSpace, "quad is", "quads are").c_str());
  }
  if (quads.halvings > 0) {
    std::fprintf(stderr,
                 "  note: every cell is cut into %d quads: otherwise more than one edge would join "
                 "%s, around handles and cones one or two cells apart\n",
                 1 << (2 * quads.halvings),
                 counted(quads.multipleEdges, "pair of vertices", "pairs of vertices").c_str());
  }
  if (quads.foldedQuads > 0) {
    std::fprintf(stderr,
                 "  note: %s at cones of k = 1; two edges of such a quad are one, which many "
                 "programs misread\n",
                 counted(quads.foldedQuads, "quad meets itself", "quads meet themselves").c_str());
  }
  for (const Note& note : quads.notes)
    std::fprintf(stderr, "  note: %s\n", printable(phrase(note)).c_str());
}

}  // namespace hgp::cli

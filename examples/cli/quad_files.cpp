#include "quad_files.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

#include "hgp/base/counted.h"
#include "side_files.h"
#include "text_report.h"

namespace hgp::cli {
namespace {

/// Adds the quads themselves, and the materials that they name, to a GLB, whose faces are triangles.
Status addObj(const api::Session& session, const io::Resolver& resolve, const Arguments& asked,
              std::vector<io::OutputFile>& files) {
  const std::string name = objBeside(asked.output);
  if (name.empty()) return Done{};
  Result<api::QuadFile> quads = session.quads(name, resolve);
  if (!quads) return quads.error();
  const std::string inFolder = std::filesystem::path(name).filename().string();
  std::vector<io::OutputFile> more{{inFolder, std::move(quads->bytes)}};
  Arguments plain = asked;
  plain.isCompressed = plain.isEmbedded = false;
  Notes notes;  // those on the GLB hold for both
  if (Status done = finishFiles(more, notes, resolve, plain); !done) return done;
  for (io::OutputFile& file : more)
    if (std::none_of(files.begin(), files.end(),
                     [&](const io::OutputFile& other) { return other.name == file.name; }))
      files.push_back(std::move(file));
  return Done{};
}

}  // namespace

Result<QuadFiles> makeQuadFiles(const api::Session& session, const io::Resolver& resolve,
                                const Arguments& asked) {
  Result<api::QuadFile> quads = session.quads(asked.output, resolve);
  if (!quads) return quads.error();
  QuadFiles out;
  out.files.push_back({asked.output, std::move(quads->bytes)});
  out.quads = std::move(*quads);
  Status done = finishFiles(out.files, out.quads.notes, resolve, asked);
  if (done) done = addObj(session, resolve, asked, out.files);
  if (!done) return done.error();
  return out;
}

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
  const auto say = [](const std::string& text) {
    std::fprintf(stderr, "  note: %s\n", printable(text).c_str());
  };
  const std::string otherwise =
      ": otherwise more than one edge would join " +
      counted(quads.multipleEdges, "pair of vertices", "pairs of vertices") +
      ", around handles and cones one or two cells apart";
  if (quads.cuts > 0)
    say(counted(quads.cuts, "strip of quads is", "strips of quads are") + " cut lengthwise" +
        otherwise);
  if (quads.replaced > 0)
    say(counted(quads.replaced, "edge is", "edges are") +
        " replaced by a vertex of valence 3, beside vertices of valence 3 and 5" + otherwise);
  if (quads.foldedInSpace > 0)
    say(counted(quads.foldedInSpace, "quad is", "quads are") +
        " folded in space, where the surface bends more than a cell can follow; more cells lower "
        "that");
  if (quads.halvings > 0)
    say("every cell is cut into " + std::to_string(1 << (2 * quads.halvings)) + " quads" +
        otherwise);
  if (quads.foldedQuads > 0)
    say(counted(quads.foldedQuads, "quad meets itself", "quads meet themselves") +
        " at cones of k = 1; two edges of such a quad are one, which many programs misread");
  for (const Note& note : quads.notes) say(phrase(note));
}

}  // namespace hgp::cli

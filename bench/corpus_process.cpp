#include "corpus_process.h"

#include "child_process.h"
#include "corpus_table.h"

namespace hgp::bench {

CorpusRow runMeshApart(const std::string& file, const std::string& name,
                       const CorpusOptions& options) {
  const auto work = [&] { return toJson(runMesh(file, name, options)); };
  const Result<std::string> text = runInChild(work, {2 * options.timeLimit, 0.0});
  if (text) return rowFromJson(*text);
  CorpusRow failed;
  failed.name = name;
  failed.reason = text.error().message;
  return failed;
}

}  // namespace hgp::bench

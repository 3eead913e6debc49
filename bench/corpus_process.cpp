#include "corpus_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>

#include "corpus_table.h"
#include "hgp/base/check.h"

namespace hgp::bench {
namespace {

[[noreturn]] void work(int out, const std::string& file, const std::string& name,
                       const CorpusOptions& options) {
  if (options.timeLimit > 0) alarm(static_cast<unsigned>(std::ceil(2 * options.timeLimit)));
  CorpusRow row;
  try {
    row = runMesh(file, name, options);
  } catch (const std::exception& error) {
    row.name = name;
    row.reason = error.what();
  }
  const std::string text = toJson(row);
  const bool isSent = write(out, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  _exit(isSent ? 0 : 1);
}

std::string readAll(int in) {
  std::string text;
  char component[4096];
  for (ssize_t n = 0; (n = read(in, component, sizeof component)) > 0;) {
    text.append(component, static_cast<std::size_t>(n));
  }
  return text;
}

}  // namespace

CorpusRow runMeshApart(const std::string& file, const std::string& name,
                       const CorpusOptions& options) {
  CorpusRow failed;
  failed.name = name;
  int ends[2];
  std::fflush(nullptr);  // or the child would print what is still buffered
  if (pipe(ends) != 0) {
    failed.reason = std::strerror(errno);
    return failed;
  }
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    work(ends[1], file, name, options);
  }
  close(ends[1]);
  const std::string text = child < 0 ? "" : readAll(ends[0]);
  close(ends[0]);
  int status = 0;
  if (child > 0) waitpid(child, &status, 0);
  if (child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return rowFromJson(text);
  failed.reason = child < 0 ? "no process could be started"
                  : WIFSIGNALED(status)
                      ? formatText("killed by %s", strsignal(WTERMSIG(status)))
                      : formatText("the process ended with %d", WEXITSTATUS(status));
  return failed;
}

}  // namespace hgp::bench

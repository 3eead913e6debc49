#include "child_process.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>

#include "hgp/base/check.h"
#include "hgp/base/threads.h"
#include "process_memory.h"

namespace hgp::bench {
namespace {

constexpr int kException = 71;

bool send(int out, const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t n = write(out, text.data() + sent, text.size() - sent);
    if (n <= 0) return false;
    sent += static_cast<std::size_t>(n);
  }
  return true;
}

[[noreturn]] void beChild(int out, const std::function<std::string()>& work,
                          const ChildLimits& limits) {
  // Not in the parent, whose freed memory the child would copy, page by page, when it writes there.
  cli::keepFreedMemory();
  setThreads(1);  // figures are processor times, to which a second thread adds its waiting
  if (limits.wallSeconds > 0) alarm(static_cast<unsigned>(std::ceil(limits.wallSeconds)));
  if (limits.cpuSeconds > 0) {
    const auto seconds = static_cast<rlim_t>(std::ceil(limits.cpuSeconds));
    const rlimit limit{seconds, seconds + 1};
    setrlimit(RLIMIT_CPU, &limit);
  }
  try {
    _exit(send(out, work()) ? 0 : 1);
  } catch (const std::exception& error) {
    _exit(send(out, error.what()) ? kException : 1);
  }
}

std::string readAll(int in) {
  std::string text;
  char part[4096];
  for (ssize_t n = 0; (n = read(in, part, sizeof part)) > 0;)
    text.append(part, static_cast<std::size_t>(n));
  return text;
}

Failure failure(std::string message) {
  return {ErrorCode::kInternal, "bench", std::move(message), {}};
}

}  // namespace

Result<std::string> runInChild(const std::function<std::string()>& work,
                               const ChildLimits& limits) {
  int ends[2];
  std::fflush(nullptr);  // otherwise the child would also print buffered output
  if (pipe(ends) != 0) return failure(std::strerror(errno));
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    beChild(ends[1], work, limits);
  }
  close(ends[1]);
  std::string text = child < 0 ? "" : readAll(ends[0]);
  close(ends[0]);
  if (child < 0) return failure("no process could be started");
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return text;
  if (WIFSIGNALED(status)) return failure(formatText("killed by %s", strsignal(WTERMSIG(status))));
  if (WEXITSTATUS(status) == kException) return failure(text);
  return failure(formatText("the process ended with %d", WEXITSTATUS(status)));
}

}  // namespace hgp::bench

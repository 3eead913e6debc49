// bin/threads MESH…: work and span of whole runs, and what they say of other numbers of threads (bench/THREADS.md).
//
// Everything is done by one thread and measured in its processor time, cut into the pieces that sixteen threads would
// share, so that other programs on the machine matter little.
#include "hgp/base/threads.h"

#include <cstdio>
#include <exception>

#include "files.h"
#include "hgp/api/session.h"
#include "hgp/base/check.h"
#include "process_memory.h"
#include "work_span.h"

namespace hgp::bench {
namespace {

constexpr int kPieces = kMaxThreads;

template <class T>
T wanted(Result<T> result) {
  HGP_CHECK(result, "%s", result.error().message.c_str());
  return std::move(*result);
}

void row(const char* name) {
  WorkSpanMeter meter;
  std::size_t triangles = 0;
  {
    const ThreadScope threads(kPieces);
    const ObservedWork observed(meter);
    api::Session session;
    wanted(session.load(wanted(cli::openFiles(name, "", "", io::Limits().maxBytes)), {}));
    wanted(session.parametrize({}, {}));
    triangles = session.triangles().size() / 3;
    api::WriteOptions write;
    write.name = "out.obj";
    write.allowUncertified = true;
    wanted(session.write(write));
  }
  const auto [work, span] = meter.total();
  std::printf("| %s | %zu | %.3f | %.3f |", name, triangles, work, span);
  for (const int threads : {2, 4, 8, 16}) {
    const auto [least, most] = meter.seconds(threads);
    std::printf(" %.2f – %.2f |", work / most, work / least);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace hgp::bench

int main(int count, char** words) {
  hgp::cli::keepFreedMemory();
  std::printf(
      "| mesh | triangles | work s | span s | P = 2 | 4 | 8 | 16 "
      "|\n|---|--:|--:|--:|--:|--:|--:|--:|\n");
  try {
    for (int i = 1; i < count; ++i) hgp::bench::row(words[i]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

#include "terminal.h"

#include <cstring>

#if __has_include(<unistd.h>) && !defined(HGP_PORTABLE)
#define HGP_HAS_POSIX
#include <unistd.h>
#endif
#ifdef _WIN32
#include <fcntl.h>
#include <io.h>

#include <cstdio>
#endif

namespace hgp::cli {

#ifdef HGP_HAS_POSIX
bool isTerminal(Stream stream) { return isatty(static_cast<int>(stream)) == 1; }

void sayInSignalHandler(const char* text) {
  const auto ignored = write(STDERR_FILENO, text, std::strlen(text));
  (void)ignored;
}
#else
bool isTerminal(Stream) { return false; }

void sayInSignalHandler(const char*) {}
#endif

void useBinaryStreams() {
#ifdef _WIN32
  _setmode(_fileno(stdin), _O_BINARY);
  _setmode(_fileno(stdout), _O_BINARY);
  _setmode(_fileno(stderr), _O_BINARY);
#endif
}

}  // namespace hgp::cli

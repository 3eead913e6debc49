// The command line of HGP.  Role: examples/cli is also the smallest complete use of hgp::api.
#include <cstdio>
#include <exception>
#include <new>

#include "commands.h"
#include "half_file.h"
#include "plain_math.h"
#include "process_memory.h"
#include "terminal.h"

int main(int count, char** words) {
  hgp::cli::keepFreedMemory();
  try {
    hgp::cli::handleInterrupts();
    hgp::cli::useBinaryStreams();
    const hgp::cli::Parsed parsed = hgp::cli::parseArguments(count, words);
    const bool isReproducible = parsed.arguments && parsed.arguments->isReproducible;
    if (isReproducible && !hgp::cli::restartWithPlainMath(words)) {
      std::fprintf(stderr,
                   "hgp: --reproducible: the C library cannot be told to use the same functions on "
                   "every processor; results may differ in their last digits\n");
    }
    return parsed.arguments ? hgp::cli::runCommand(*parsed.arguments) : parsed.exitCode;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "hgp: out of memory\n");
    return 8;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hgp: internal error: %s\n", error.what());
    return 70;
  }
}

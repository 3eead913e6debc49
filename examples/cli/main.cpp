// The command line of HGP.  Role: examples/cli also shows a complete use of hgp::api.
#include <cstdio>
#include <exception>
#include <new>

#include "commands.h"
#include "half_file.h"
#include "process_memory.h"
#include "terminal.h"

int main(int count, char** words) {
  hgp::cli::keepFreedMemory();
  try {
    hgp::cli::handleInterrupts();
    hgp::cli::useBinaryStreams();
    const hgp::cli::Parsed parsed = hgp::cli::parseArguments(count, words);
    return parsed.arguments ? hgp::cli::runCommand(*parsed.arguments) : parsed.exitCode;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "hgp: out of memory\n");
    return 8;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hgp: internal error: %s\n", error.what());
    return 70;
  }
}

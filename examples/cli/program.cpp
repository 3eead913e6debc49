#include "program.h"

#include <cstdio>
#include <exception>
#include <new>

#include "commands.h"
#include "half_file.h"
#include "process_memory.h"
#include "terminal.h"

namespace hgp::cli {

int runProgram(int count, char** words) {
  keepFreedMemory();
  try {
    handleInterrupts();
    useBinaryStreams();
    const Parsed parsed = parseArguments(count, words);
    return parsed.arguments ? runCommand(*parsed.arguments) : parsed.exitCode;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "hgp: out of memory\n");
    return 8;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hgp: internal error: %s\n", error.what());
    return 70;
  }
}

}  // namespace hgp::cli

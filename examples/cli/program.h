// The whole command line as a function.  Role: `main` of the program `hgp`, and of `python3 -m hgp`.
#pragma once

namespace hgp::cli {

/// Runs one command with the words of `main` and returns the exit code. It changes how the process handles signals,
/// standard streams and freed memory, so the process should end soon.
int runProgram(int count, char** words);

}  // namespace hgp::cli

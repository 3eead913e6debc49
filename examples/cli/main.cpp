// The command line of HGP.  Role: examples/cli also shows a complete use of hgp::api.
#include "program.h"

int main(int count, char** words) { return hgp::cli::runProgram(count, words); }

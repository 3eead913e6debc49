// What ISO C++ has no word for.  Role: every POSIX call of the command line; with
// HGP_PORTABLE, and where there is no POSIX, the alternatives beside them.
#pragma once

namespace hgp::cli {

enum class Stream { kOutput = 1, kError = 2 };

/// Without POSIX never: no colour, plain lines of progress.
bool isTerminal(Stream stream);

/// To standard error, from a signal handler. Without POSIX nothing is said, since no function of the
/// standard library may be called there.
void sayInSignalHandler(const char* text);

/// Windows would write "\r\n" and end its reading at a 0x1a.
void useBinaryStreams();

}  // namespace hgp::cli

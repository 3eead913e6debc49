// Functions that ISO C++ lacks.  Role: all POSIX calls of the command line, with alternatives for HGP_PORTABLE and for
// systems without POSIX.
#pragma once

namespace hgp::cli {

enum class Stream { kOutput = 1, kError = 2 };

/// Whether a stream is a terminal. Always false without POSIX: no colours, and progress as plain lines.
bool isTerminal(Stream stream);

/// Writes to standard error from a signal handler. Without POSIX it does nothing, since no function of the
/// standard library may be called there.
void sayInSignalHandler(const char* text);

/// Switches the standard streams to binary mode: in text mode Windows writes "\r\n" and stops reading at 0x1a.
void useBinaryStreams();

}  // namespace hgp::cli

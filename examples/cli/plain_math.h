// The same sine on every processor.  Role: what --reproducible needs besides the kernels.
#pragma once

namespace hgp::cli {

/// The C library picks its sin, exp … by the processor, and those with fused multiply-add round otherwise. It can
/// be told at the start of a program only: starts it again where that has not been done. Returns false where
/// it cannot (no glibc, no /proc), and does not return otherwise unless it had been done.
bool restartWithPlainMath(char** words);

}  // namespace hgp::cli

// Catches exceptions at the API boundary, and gives its calls threads.  Role: the only place where HGP_CHECK, failed
// allocations and the libraries' own exceptions become a Failure.
#pragma once

#include <exception>
#include <new>
#include <optional>
#include <stdexcept>

#include "hgp/base/check.h"
#include "hgp/base/result.h"
#include "hgp/base/threads.h"

namespace hgp::api {

/// The Failure that corresponds to the exception being handled.
inline Failure caughtFailure() {
  try {
    throw;
  } catch (const InternalError& e) {
    return {ErrorCode::kInternal, "internal", e.what(), {}};
  } catch (const std::bad_alloc&) {
    return {ErrorCode::kLimit, "memory", "out of memory", {}};
  } catch (const std::length_error&) {
    return {ErrorCode::kLimit, "memory", "out of memory", {}};
  } catch (const std::exception& e) {
    return {ErrorCode::kInternal, "internal", e.what(), {}};
  } catch (...) {
    return {ErrorCode::kInternal, "internal", "an unknown exception", {}};
  }
}

/// Runs `work`, which returns a Result, and converts exceptions to a Failure. Without a ThreadScope of the caller, it has
/// one of its own.
template <class Work>
auto guarded(Work work) -> decltype(work()) {
  try {
#ifndef HGP_NO_THREADS
    std::optional<ThreadScope> threads;
    if (!ThreadScope::isOpen()) threads.emplace(defaultThreads());
#endif
    return work();
  } catch (...) {
    return caughtFailure();
  }
}

}  // namespace hgp::api

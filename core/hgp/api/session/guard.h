// Catches exceptions at the API boundary.  Role: the only place where HGP_CHECK, failed allocations and the
// libraries' own exceptions become a Failure.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>

#include "hgp/base/check.h"
#include "hgp/base/result.h"

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

/// Runs `work`, which returns a Result, and converts exceptions to a Failure.
template <class Work>
auto guarded(Work work) -> decltype(work()) {
  try {
    return work();
  } catch (...) {
    return caughtFailure();
  }
}

}  // namespace hgp::api

// Results that a caller must check.  Role: the error model of every module (docs/architecture.md, Errors).
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hgp/base/note.h"

namespace hgp {

/// What went wrong, for programs. The command line maps these to exit codes (docs/cli.md).
enum class ErrorCode {
  kUsage,         ///< wrong or contradictory options or arguments                  exit 2
  kMalformed,     ///< bytes that are not what they claim to be                     exit 3
  kUnsupported,   ///< readable, but not an oriented manifold mesh that can be used exit 4
  kPrescription,  ///< cones, turning or holonomy that no map can have              exit 5
  kNoMap,         ///< no certified map was found                                   exit 6
  kWriteFailed,   ///< the result could not be stored                               exit 7
  kLimit,         ///< memory or a stated limit                                     exit 8
  kInternal,      ///< a bug in hgp                                                 exit 70
  kCancelled,     ///< the caller cancelled                                         exit 130
};

/// Short stable name used in JSON ("malformed", "unsupported", …).
const char* errorName(ErrorCode code);
/// Process exit code of the command line for this kind of failure.
int exitCode(ErrorCode code);

/// The rule that was broken, the measured number, where, and what to do next.
struct Failure {
  ErrorCode code = ErrorCode::kInternal;
  std::string stage;    ///< "read", "topology", "prescription", "field", …
  std::string message;  ///< one or two sentences: rule, number, what to do
  std::vector<Where> where;
  /// What to do, where that differs between command line, package and page; otherwise it is in the message.
  Notes advice = {};
};

/// The message with its advice, for users of the command line and of the libraries in C++ and Python.
std::string told(const Failure& failure);

/// Either a value or a Failure. A substitute for std::expected, which the supported compilers lack.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Failure failure) : state_(std::move(failure)) {}

  bool hasValue() const { return state_.index() == 0; }
  explicit operator bool() const { return hasValue(); }

  T& value() & { return std::get<0>(state_); }
  const T& value() const& { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Failure& error() const& { return std::get<1>(state_); }
  Failure&& error() && { return std::get<1>(std::move(state_)); }

 private:
  std::variant<T, Failure> state_;
};

/// The result of functions that return no value: success or a Failure.
struct Done {};
using Status = Result<Done>;

}  // namespace hgp

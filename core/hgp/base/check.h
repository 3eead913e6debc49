// Preconditions inside the core.  Role: a broken one is a bug in hgp, never a mistake of the user.
#pragma once

#include <stdexcept>
#include <string>

// Makes compilers that support it check arguments against the printf format.
#ifdef __GNUC__
#define HGP_PRINTF(text, first) __attribute__((format(printf, text, first)))
#else
#define HGP_PRINTF(text, first)
#endif

namespace hgp {

/// Thrown by HGP_CHECK; caught only at the API boundary (api/), where it becomes ErrorCode::kInternal.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] void failCheck(const char* condition, const char* file, int line, const char* format,
                            ...) HGP_PRINTF(4, 5);

/// printf into a std::string; the supported compilers lack <format>.
std::string formatText(const char* format, ...) HGP_PRINTF(1, 2);

}  // namespace hgp

/// HGP_CHECK(cond, "rule broken: %d", value)
#define HGP_CHECK(cond, ...)                                               \
  do {                                                                     \
    if (!(cond)) ::hgp::failCheck(#cond, __FILE__, __LINE__, __VA_ARGS__); \
  } while (false)

#include "hgp/base/check.h"

#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace hgp {
namespace {

std::string formatList(const char* format, std::va_list args) {
  std::va_list copy;
  va_copy(copy, args);
  const int length = std::vsnprintf(nullptr, 0, format, copy);
  va_end(copy);
  std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  if (length > 0) std::vsnprintf(text.data(), text.size() + 1, format, args);
  return text;
}

}  // namespace

std::string formatText(const char* format, ...) {
  std::va_list args;
  va_start(args, format);
  std::string text = formatList(format, args);
  va_end(args);
  return text;
}

void failCheck(const char* condition, const char* file, int line, const char* format, ...) {
  std::va_list args;
  va_start(args, format);
  const std::string text = formatList(format, args);
  va_end(args);
  const char* name = std::strrchr(file, '/');
  throw InternalError(
      formatText("%s:%d: %s (%s)", name ? name + 1 : file, line, text.c_str(), condition));
}

}  // namespace hgp

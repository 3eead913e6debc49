#include "hgp/parametrize/method.h"

#include <array>

namespace hgp {
namespace {

constexpr std::array<const char*, 5> kNames{"auto", "harmonic", "soft", "printed", "all-frames"};

}  // namespace

const char* methodName(Method method) { return kNames[static_cast<std::size_t>(method)]; }

std::optional<Method> methodNamed(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i]) return static_cast<Method>(i);
  return {};
}

}  // namespace hgp

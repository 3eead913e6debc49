#include "hgp/api/options.h"

#include <array>

#include "hgp/text/text.h"

namespace hgp::api {
namespace {

struct NamedBalance {
  const char* word;
  double balance;
};
constexpr std::array<NamedBalance, 3> kBalances{
    {{"isometric", 0.0}, {"conformal", -1.0}, {"area", 1.0}}};

}  // namespace

std::optional<MapFormat> mapFormatNamed(const std::string& word) {
  constexpr std::array<const char*, 6> kWords{"same", "glb", "gltf", "obj", "flat-obj", "svg"};
  for (std::size_t i = 0; i < kWords.size(); ++i)
    if (word == kWords[i]) return static_cast<MapFormat>(i);
  return std::nullopt;
}

std::optional<double> improveBalance(const std::string& word) {
  for (const NamedBalance& named : kBalances)
    if (word == named.word) return named.balance;
  const char* p = word.data();
  const char* end = p + word.size();
  double value = 0.0;
  if (!io::readDouble(p, end, value) || p != end || !(value >= -1.0 && value <= 1.0))
    return std::nullopt;
  return value;
}

std::string improveWord(double balance) {
  for (const NamedBalance& named : kBalances)
    if (balance == named.balance) return named.word;
  return "";
}

}  // namespace hgp::api

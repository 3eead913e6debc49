#include "hgp/api/option_words.h"

#include <algorithm>
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

/// In the order of Symmetry.
constexpr std::array<const char*, 5> kSymmetries{"none", "auto", "X", "Y", "Z"};
constexpr std::array kBoundaries{"free", "convex", "rectangle"};

/// The value at the place of the word.
template <class Value, std::size_t N>
std::optional<Value> valueNamed(std::string_view word, const std::array<const char*, N>& words) {
  for (std::size_t i = 0; i < N; ++i)
    if (word == words[i]) return static_cast<Value>(i);
  return std::nullopt;
}

}  // namespace

std::optional<BoundaryKind> boundaryNamed(std::string_view word) {
  return valueNamed<BoundaryKind>(word, kBoundaries);
}
const char* boundaryName(BoundaryKind boundary) {
  return kBoundaries[static_cast<std::size_t>(boundary)];
}

std::optional<FrameSource> framesNamed(std::string_view word) {
  return valueNamed<FrameSource>(word, std::array{"auto", "file"});
}

std::optional<Scale> scaleNamed(std::string_view word) {
  return valueNamed<Scale>(word, std::array{"solved", "unit", "fit"});
}

std::optional<GridMode> gridModeNamed(std::string_view word) {
  return valueNamed<GridMode>(word, std::array{"tile", "quad"});
}

std::optional<Symmetry> symmetryNamed(std::string_view word) {
  const auto found = std::find(kSymmetries.begin() + 1, kSymmetries.end(), word);
  if (found == kSymmetries.end()) return std::nullopt;
  return static_cast<Symmetry>(found - kSymmetries.begin());
}

const char* symmetryWord(Symmetry symmetry) {
  return kSymmetries[static_cast<std::size_t>(symmetry)];
}

std::optional<MapFormat> mapFormatNamed(std::string_view word) {
  return valueNamed<MapFormat>(word, std::array{"same", "glb", "gltf", "obj", "flat-obj", "svg"});
}

std::optional<double> weldNamed(std::string_view word) {
  if (word == "exact") return 0.0;
  if (word == "none") return LoadOptions::kWeldNever;
  return std::nullopt;
}

std::optional<double> improveBalance(const std::string& word) {
  for (const NamedBalance& named : kBalances)
    if (word == named.word) return named.balance;
  const char* p = word.data();
  const char* end = p + word.size();
  double value = 0.0;
  if (!text::readDouble(p, end, value) || p != end || !(value >= -1.0 && value <= 1.0))
    return std::nullopt;
  return value;
}

std::string improveWord(double balance) {
  for (const NamedBalance& named : kBalances)
    if (balance == named.balance) return named.word;
  return "";
}

}  // namespace hgp::api

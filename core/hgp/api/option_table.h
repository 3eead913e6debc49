// The words of every option: how JSON objects, the command line and Python name it, and which values it has.
// Role: the one table that optionsFromJson, the command line, the package and Python follow; constant, for any thread.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hgp::api {

enum class OptionKind {
  kFlag,          ///< true or false
  kInteger,       ///< within the bounds
  kNumber,        ///< within the bounds
  kText,          ///< any string
  kWord,          ///< one of the words
  kWordOrNumber,  ///< one of the words, or a number within the bounds
  kFlagOrNumber,  ///< true, false or a number within the bounds
  kWords,         ///< a list of the words, or an object in which they are true or false
};

/// The end of integers that have no other one.
inline constexpr double kLargestInt = std::numeric_limits<int>::max();

struct OptionRow {
  const char*
      name;  ///< in JSON objects and in the package; "grid.cells" is `cells` of the object `grid`
  const char* flag;     ///< of the command line; "" where it has none
  const char* keyword;  ///< of Python; "" where it has none
  OptionKind kind;
  const char* words = "";  ///< "free|convex"
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool isOpen = false;  ///< values are above `low`, not equal to it
};

struct LoadOptions;
struct SolveOptions;
struct VerifyOptions;
struct WriteOptions;

/// The rows of LoadOptions, SolveOptions (with those of automatic cones), VerifyOptions or WriteOptions.
template <class Options>
std::span<const OptionRow> optionRows();
template <>
std::span<const OptionRow> optionRows<LoadOptions>();
template <>
std::span<const OptionRow> optionRows<SolveOptions>();
template <>
std::span<const OptionRow> optionRows<VerifyOptions>();
template <>
std::span<const OptionRow> optionRows<WriteOptions>();

/// The words of the option with this flag, in the order of the table; empty for flags without words.
std::vector<std::string> wordsOfFlag(std::string_view flag);
/// The row of one call's options with this flag; null if it has none.
template <class Options>
const OptionRow* rowOfFlag(std::string_view flag) {
  for (const OptionRow& row : optionRows<Options>())
    if (flag == row.flag) return &row;
  return nullptr;
}
/// The words of a row.
std::vector<std::string> wordsOf(const OptionRow& row);

}  // namespace hgp::api

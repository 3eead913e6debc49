#include "hgp/api/json/given_options.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/text/nearest.h"
#include "hgp/text/text.h"

namespace hgp::api {
namespace {

/// Options need two levels, and wrong ones of a few more can still be shown.
constexpr int kMaxDepth = 16;

Failure wrongOption(std::string message, const char* stage = "arguments") {
  return {ErrorCode::kUsage, stage, std::move(message), {}};
}

/// Values and names as the users of one language write them.
class Speller {
 public:
  explicit Speller(Spelling spelling) : isPython_(spelling == Spelling::kPython) {}

  std::string name(const OptionRow& row) const { return isPython_ ? row.keyword : row.name; }

  std::string value(const OptionJson& value) const {
    if (value.is_boolean() && isPython_) return value.get<bool>() ? "True" : "False";
    if (value.is_string()) return text::inQuotes(value.get_ref<const std::string&>());
    const std::string json = value.dump(-1, ' ', false, OptionJson::error_handler_t::replace);
    const std::string_view shown = text::beginningOf(json, 60);
    return std::string(shown) + (shown.size() < json.size() ? "…" : "");
  }

  std::string flag() const { return isPython_ ? "True or False" : "true or false"; }

 private:
  bool isPython_;
};

std::string number(double x) { return formatText("%.15g", x); }

/// "from 1 to 64", "at least 0", "above 0"; an end that is far away is named to who passed it.
std::string rangeOf(const OptionRow& row, double x = 0.0) {
  const bool isFar = row.high >= kLargestInt;
  if (isFar && x > row.high) return "at most " + number(row.high);
  if (!isFar) return "from " + number(row.low) + " to " + number(row.high);
  if (std::isfinite(row.low)) return (row.isOpen ? "above " : "at least ") + number(row.low);
  return "";
}

/// "'a', 'b' or 'c'"
std::string listed(const std::vector<std::string>& words, const char* last = " or ") {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += std::string(i == 0 ? "" : i + 1 == words.size() ? last : ", ") + "'" + words[i] + "'";
  return text;
}

std::string kindOf(const OptionRow& row, const Speller& speller) {
  const std::string range = rangeOf(row);
  switch (row.kind) {
    case OptionKind::kFlag:
      return speller.flag();
    case OptionKind::kInteger:
      return "an integer";
    case OptionKind::kNumber:
      return "a number";
    case OptionKind::kText:
      return "a string";
    case OptionKind::kWord:
      return listed(wordsOf(row));
    case OptionKind::kWordOrNumber:
      return listed(wordsOf(row), ", ") + " or a number " + range;
    case OptionKind::kFlagOrNumber:
      return speller.flag() + " or a number " + range;
    case OptionKind::kWords:
      return "a list of " + listed(wordsOf(row), " and ");
  }
  return "";
}

bool isWord(const OptionRow& row, const OptionJson& value) {
  if (!value.is_string()) return false;
  const std::vector<std::string> words = wordsOf(row);
  return std::find(words.begin(), words.end(), value.get<std::string>()) != words.end();
}

bool areWords(const OptionRow& row, const OptionJson& value) {
  for (const auto& item : value.items()) {
    const OptionJson word = value.is_array() ? item.value() : OptionJson(item.key());
    if (!isWord(row, word) || (value.is_object() && !item.value().is_boolean())) return false;
  }
  return true;
}

/// Whether the value has the type of the row; bounds and words are left aside.
bool hasType(const OptionRow& row, const OptionJson& value) {
  switch (row.kind) {
    case OptionKind::kFlag:
      return value.is_boolean();
    case OptionKind::kInteger:
      return value.is_number_integer();
    case OptionKind::kNumber:
      return value.is_number();
    case OptionKind::kText:
    case OptionKind::kWord:
      return value.is_string();
    case OptionKind::kWordOrNumber:
      return value.is_string() || value.is_number();
    case OptionKind::kFlagOrNumber:
      return value.is_boolean() || value.is_number();
    case OptionKind::kWords:
      return value.is_array() || value.is_object();
  }
  return false;
}

Status checkValue(const OptionRow& row, const OptionJson& value, const Speller& speller) {
  const auto refuse = [&](const std::string& rule, const char* stage) {
    return wrongOption(speller.name(row) + " must be " + rule + ", not " + speller.value(value),
                       stage);
  };
  if (!hasType(row, value)) return refuse(kindOf(row, speller), "type");
  if (value.is_string() && row.kind != OptionKind::kText && !isWord(row, value))
    return refuse(kindOf(row, speller), "arguments");
  if (row.kind == OptionKind::kWords && !areWords(row, value))
    return refuse(kindOf(row, speller), "arguments");
  if (!value.is_number()) return Done{};
  const double x = value.get<double>();
  const bool isAbove = row.isOpen ? x > row.low : x >= row.low;
  if (std::isfinite(x) && isAbove && x <= row.high) return Done{};
  const bool isPlain = row.kind == OptionKind::kInteger || row.kind == OptionKind::kNumber;
  return refuse(isPlain ? rangeOf(row, x) : kindOf(row, speller), "arguments");
}

}  // namespace

Result<GivenOptions> GivenOptions::read(std::string_view text, std::span<const OptionRow> rows,
                                        Spelling spelling) {
  if (text::isNestedDeeper(text, kMaxDepth))
    return wrongOption(
        formatText("options must not be nested deeper than %d lists and objects", kMaxDepth),
        "type");
  const OptionJson json = OptionJson::parse(text.begin(), text.end(), nullptr, false);
  if (!json.is_object()) return wrongOption("options must be a JSON object", "type");
  GivenOptions given(rows, spelling);
  if (Status done = given.take(json, ""); !done) return done.error();
  return given;
}

const OptionJson& GivenOptions::at(std::string_view name) const {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (name == rows_[i].name) return values_[i];
  throw InternalError("there is no option " + std::string(name));
}

Failure GivenOptions::contradiction(std::string_view a, std::string_view b,
                                    const std::string& why) const {
  return wrongOption(nameOf(a) + " and " + nameOf(b) + " " + why);
}

std::string GivenOptions::nameOf(std::string_view name) const {
  for (const OptionRow& row : rows_)
    if (name == row.name) return Speller(spelling_).name(row);
  return std::string(name);
}

Status GivenOptions::take(const OptionJson& object, const std::string& before) {
  const Speller speller(spelling_);
  for (const auto& [key, value] : object.items()) {
    const std::string name = before + key;
    const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const OptionRow& one) {
      return !name.empty() && speller.name(one) == name;
    });
    if (row == rows_.end()) {
      if (!isObject(name)) return unknown(name);
      if (value.is_null()) continue;
      if (!value.is_object())
        return wrongOption(name + " must be an object, not " + speller.value(value), "type");
      if (Status done = take(value, name + "."); !done) return done;
      continue;
    }
    if (value.is_null()) continue;
    if (Status done = checkValue(*row, value, speller); !done) return done;
    values_[static_cast<std::size_t>(row - rows_.begin())] = value;
  }
  return Done{};
}

bool GivenOptions::isObject(const std::string& name) const {
  const Speller speller(spelling_);
  return std::any_of(rows_.begin(), rows_.end(), [&](const OptionRow& row) {
    return speller.name(row).compare(0, name.size() + 1, name + ".") == 0;
  });
}

Failure GivenOptions::unknown(const std::string& name) const {
  const Speller speller(spelling_);
  std::vector<std::string> names;
  std::string all;
  for (const OptionRow& row : rows_) {
    names.push_back(speller.name(row));
    if (!names.back().empty()) all += (all.empty() ? "" : ", ") + names.back();
  }
  const std::string nearest = text::nearestOf(name, names);
  return wrongOption("there is no option " + text::inQuotes(name) + "; " +
                     (nearest.empty() ? "there are: " + all : "did you mean '" + nearest + "'?"));
}

}  // namespace hgp::api

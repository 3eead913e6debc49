#include "hgp/prescription/feature_files.h"

#include <algorithm>
#include <cstdint>

#include "hgp/base/check.h"
#include "hgp/prescription/cones.h"
#include "hgp/text/text.h"

namespace hgp::prescription {
namespace {

/// Calls use(line, number) for every line until it returns a failure; the line ends are left out.
template <class Use>
Status forLines(std::string_view text, const Use& use) {
  const char end = text::lineEndOf(text);
  std::int64_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t stop = std::min(text.find(end, begin), text.size());
    if (Status done = use(text.substr(begin, stop - begin), ++number); !done) return done;
    begin = stop + 1;
  }
  return Done{};
}

Failure wrong(std::int64_t line, const std::string& message) {
  Failure failure = text::malformedLine(line, message);
  failure.stage = "features";
  return failure;
}

/// Reads numbers separated by blanks or commas to the end of the line; false where there is anything else.
bool readNumbers(std::string_view line, std::vector<int>& out) {
  out.clear();
  const char *p = line.data(), *end = p + line.size();
  for (;;) {
    text::skipBlanks(p, end);
    if (p != end && *p == ',' && !out.empty()) {
      ++p;
      text::skipBlanks(p, end);
    }
    if (p == end || *p == '#') return true;
    std::int64_t value = 0;
    if (!text::readInt(p, end, value) || value < INT32_MIN || value > INT32_MAX) return false;
    out.push_back(static_cast<int>(value));
  }
}

Result<PrescribedFeatures> readSharp(std::string_view text) {
  PrescribedFeatures out;
  std::vector<int> row;
  std::int64_t count = -1;
  Status done = forLines(text, [&](std::string_view line, std::int64_t number) -> Status {
    if (!readNumbers(line, row))
      return wrong(number, "must hold integers, not " + text::inQuotes(line));
    if (row.empty()) return Done{};
    if (count < 0) {
      if (row.size() != 1 || row[0] < 0 || row[0] > kMaxFeatures)
        return wrong(number, "must be the number of rows, not " + text::inQuotes(line));
      count = row[0];
      return Done{};
    }
    if (row.size() != 3 || row[1] < 0 || row[2] < 0 || row[2] > 2)
      return wrong(number, "must be type, triangle and side 0 to 2, not " + text::inQuotes(line));
    out.sides.push_back({row[1], row[2]});
    return Done{};
  });
  if (!done) return std::move(done).error();
  if (count != static_cast<std::int64_t>(out.sides.size()))
    return wrong(1, formatText("announces %lld rows and %zu follow", static_cast<long long>(count),
                               out.sides.size()));
  return out;
}

Result<PrescribedFeatures> readPairs(std::string_view text) {
  PrescribedFeatures out;
  std::vector<int> row;
  Status done = forLines(text, [&](std::string_view line, std::int64_t number) -> Status {
    const bool isRow = readNumbers(line, row) && (row.empty() || row.size() == 2);
    if (!isRow) return wrong(number, "must be two vertices, not " + text::inQuotes(line));
    if (row.empty()) return Done{};
    if (row[0] < 0 || row[1] < 0 || row[0] == row[1])
      return wrong(number, "must be two different vertices from 0, not " + text::inQuotes(line));
    out.lines.push_back({{row[0], row[1]}});
    return out.lines.size() <= static_cast<std::size_t>(kMaxFeatures)
               ? Status(Done{})
               : wrong(number, "too many edges");
  });
  if (!done) return std::move(done).error();
  return out;
}

/// The lines "l a b c …" of an OBJ, polylines through vertices counted from 1.
Result<PrescribedFeatures> readObjLines(std::string_view text) {
  PrescribedFeatures out;
  std::vector<int> row;
  Status done = forLines(text, [&](std::string_view line, std::int64_t number) -> Status {
    if (line.size() < 2 || line[0] != 'l' || !text::isBlank(line[1])) return Done{};
    if (!readNumbers(line.substr(1), row))
      return wrong(number, "must be a line through vertices, not " + text::inQuotes(line));
    if (row.size() < 2) return wrong(number, "must name two vertices, not " + text::inQuotes(line));
    for (std::size_t i = 0; i < row.size(); ++i)
      if (row[i] < 1 || (i > 0 && row[i - 1] == row[i]))
        return wrong(number, "must name different vertices from 1, not " + text::inQuotes(line));
    for (int& vertex : row) --vertex;
    out.lines.push_back({row});
    return Done{};
  });
  if (!done) return std::move(done).error();
  return out;
}

bool endsWith(std::string_view name, std::string_view end) {
  return name.size() >= end.size() && name.substr(name.size() - end.size()) == end;
}

}  // namespace

Result<PrescribedFeatures> readFeatures(std::string_view name, std::string_view text) {
  if (endsWith(name, ".sharp")) return readSharp(text);
  if (endsWith(name, ".obj")) return readObjLines(text);
  if (endsWith(name, ".json")) {
    Result<Prescription> read = readConesJson(text);
    if (!read) return std::move(read).error();
    read->features.sha256 = std::move(read->sha256);
    return std::move(read->features);
  }
  return readPairs(text);
}

std::optional<std::vector<FeatureMark>> featureMarksNamed(const std::vector<std::string>& words) {
  std::vector<FeatureMark> marks;
  for (std::size_t m = 0; m < std::size(kFeatureMarks); ++m) {
    const bool isNamed = std::find(words.begin(), words.end(), kFeatureMarks[m]) != words.end();
    if (words.empty() || isNamed) marks.push_back(static_cast<FeatureMark>(m));
  }
  const bool areKnown = std::all_of(words.begin(), words.end(), [](const std::string& word) {
    return std::find(std::begin(kFeatureMarks), std::end(kFeatureMarks), word) !=
           std::end(kFeatureMarks);
  });
  if (!areKnown) return std::nullopt;
  return marks;
}

void addFeatures(PrescribedFeatures& features, std::optional<PrescribedFeatures> list,
                 const PrescribedFeatures& asked) {
  const auto takeRest = [&features](const PrescribedFeatures& other) {
    features.hasRims = features.hasRims || other.hasRims;
    if (other.creaseDegrees) features.creaseDegrees = other.creaseDegrees;
    if (!other.marks.empty()) features.marks = other.marks;
  };
  if (list) {
    const PrescribedFeatures before = std::move(features);
    features = std::move(*list);
    takeRest(before);
  }
  takeRest(asked);
}

}  // namespace hgp::prescription

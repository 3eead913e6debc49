#include "stress_table.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "hgp/base/check.h"

namespace hgp::stress {
namespace {

struct Count {
  int certified = 0, all = 0, apart = 0;
  void add(const Row& row) {
    const bool isApart = row.verdict == Verdict::kTooFine || row.verdict == Verdict::kTooCoarse;
    apart += isApart;
    all += !isApart;
    certified += row.verdict == Verdict::kCertified;
  }
  std::string text() const {
    if (all + apart == 0) return "";
    std::string cell = formatText("%d/%d", certified, all);
    if (apart > 0) cell += formatText(" (+%d)", apart);
    return cell;
  }
  std::string share() const {
    return all == 0 ? "" : formatText("%.1f %%", 100.0 * certified / all);
  }
};

double quantile(std::vector<double> values, double p) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1))];
}

/// "sphere", "disk", "genus 0, 2+ loops", "genus 1", …, "genus 4+".
std::string surfaceClass(const Row& row) {
  if (row.genus == 0) return row.loops == 0 ? "sphere" : row.loops == 1 ? "disk" : "genus 0, loops";
  return row.genus >= 4 ? "genus 4+" : formatText("genus %d", row.genus);
}
const std::vector<std::string>& surfaceClasses() {
  static const std::vector<std::string> kClasses = {
      "sphere", "disk", "genus 0, loops", "genus 1", "genus 2", "genus 3", "genus 4+"};
  return kClasses;
}

std::vector<std::string> namesOf(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const Row& row : rows)
    if (std::find(names.begin(), names.end(), row.family) == names.end())
      names.push_back(row.family);
  return names;
}

std::string familyLine(const std::string& name, const std::vector<Row>& rows,
                       const std::function<bool(const Row&)>& belongs) {
  std::map<std::string, Count> byClass;
  Count all;
  std::vector<double> rounds, seconds;
  for (const Row& row : rows) {
    if (!belongs(row)) continue;
    byClass[surfaceClass(row)].add(row);
    all.add(row);
    rounds.push_back(row.rounds);
    seconds.push_back(row.seconds);
  }
  std::string line = "| " + name;
  for (const std::string& c : surfaceClasses()) line += " | " + byClass[c].text();
  return line + " | " + all.text() + " | " + all.share() +
         formatText(" | %.0f / %.0f / %.0f | %.2f / %.2f / %.1f |\n", quantile(rounds, 0.5),
                    quantile(rounds, 0.9), quantile(rounds, 1.0), quantile(seconds, 0.5),
                    quantile(seconds, 0.9), quantile(seconds, 1.0));
}

}  // namespace

std::string familyTable(const std::vector<Row>& rows) {
  std::string table = "| prescriptions";
  for (const std::string& c : surfaceClasses()) table += " | " + c;
  table += " | all | | rounds 50 / 90 / 100 % | processor s 50 / 90 / 100 % |\n|---|";
  for (std::size_t i = 0; i < surfaceClasses().size(); ++i) table += "--:|";
  table += "--:|--:|--:|--:|\n";
  for (const std::string& name : namesOf(rows))
    table += familyLine(name, rows, [&](const Row& r) { return r.family == name; });
  return table + familyLine("**all**", rows, [](const Row&) { return true; });
}

std::string harmTable(const std::vector<Row>& rows) {
  std::string table = "| harm | automatic cones | random prescription |\n|---|--:|--:|\n";
  for (const std::string& name : namesOf(rows)) {
    Count automatic, random;
    for (const Row& row : rows)
      if (row.family == name) (row.isAutomatic ? automatic : random).add(row);
    table += "| " + name + " | " + automatic.text() + " | " + random.text() + " |\n";
  }
  return table;
}

std::string stretchTable(const std::vector<Row>& rows) {
  static const double kBounds[] = {0, 5, 10, 15, 20, 25, 1e9};
  std::string table =
      "| predicted stretch | genus 0 | warned | handles | warned |\n|---|--:|--:|--:|--:|\n";
  for (int bin = 0; bin + 1 < static_cast<int>(std::size(kBounds)); ++bin) {
    Count count[2];
    int warned[2] = {0, 0};
    for (const Row& row : rows) {
      if (row.isAutomatic || row.scaleRange < kBounds[bin] || row.scaleRange >= kBounds[bin + 1])
        continue;
      count[row.genus > 0].add(row);
      warned[row.genus > 0] += row.isWarned;
    }
    table += kBounds[bin + 1] > 1e8
                 ? formatText("| above e^%.0f", kBounds[bin])
                 : formatText("| e^%.0f to e^%.0f", kBounds[bin], kBounds[bin + 1]);
    for (int i = 0; i < 2; ++i) table += " | " + count[i].text() + formatText(" | %d", warned[i]);
    table += " |\n";
  }
  int failures = 0, unwarned = 0;
  for (const Row& row : rows) {
    if (row.verdict == Verdict::kCertified || row.isAutomatic) continue;
    ++failures;
    unwarned += !row.isWarned;
  }
  return table + formatText("\n%d of %d failures came without a warning.\n", unwarned, failures);
}

std::string lineOf(const Row& row) {
  std::string line = formatText(
      "%-34s g %d m %d F %5d q %d cones %2d%s u %4.1f: %s, %d rounds, %.2f s", row.name.c_str(),
      row.genus, row.loops, row.triangles, row.q, row.cones, row.areHandlesGiven ? " +handles" : "",
      row.scaleRange, verdictName(row.verdict), row.rounds, row.seconds);
  if (row.verdict != Verdict::kCertified)
    line += formatText(" [%s] %s", row.method.c_str(), row.reason.substr(0, 120).c_str());
  return line + "\n";
}

}  // namespace hgp::stress

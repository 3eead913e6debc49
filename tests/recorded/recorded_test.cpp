// Results are those of the recording. A change that is wanted is recorded anew, and said in the commit:
//   HGP_RECORD=tests/recorded/recording.inc build/native-release/bin/tests_recorded
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "recorded/recorder.h"

namespace hgp::recorded {
namespace {

const char* const kRecording =
#include "recorded/recording.inc"
    ;

const std::map<std::string, std::string>& recording() {
  static const std::map<std::string, std::string> lines = [] {
    std::map<std::string, std::string> all;
    std::istringstream in(kRecording);
    for (std::string line; std::getline(in, line);)
      if (const std::size_t end = line.find(" |"); end != std::string::npos)
        all[line.substr(0, end)] = line.substr(end + 2);
    return all;
  }();
  return lines;
}

std::vector<Scenario> scenarios() {
  std::vector<Scenario> all;
  for (std::vector<Scenario> some :
       {maps(), prescriptions(), grids(), files(), gltfFiles(), verdicts(), edits(), wrongFiles()})
    for (Scenario& one : some) all.push_back(std::move(one));
  return all;
}

/// Where two lines begin to differ, with the word before.
std::string difference(const std::string& was, const std::string& is) {
  std::istringstream a(was), b(is);
  std::string x, y;
  while (true) {
    const bool hasMore = static_cast<bool>(a >> x), hasOther = static_cast<bool>(b >> y);
    if (!hasMore && !hasOther) return "";
    if (!hasMore || !hasOther || x != y)
      return "was " + (hasMore ? x : "(end)") + ", is " + (hasOther ? y : "(end)");
  }
}

class Recorded : public testing::TestWithParam<Scenario> {
 protected:
  static void SetUpTestSuite() { api::setReproducible(true); }
  static void TearDownTestSuite() {
    if (const char* path = std::getenv("HGP_RECORD")) {
      std::ofstream out(path);
      out << "R\"rec(\n";
      for (const auto& [name, line] : made()) out << name << " |" << line << "\n";
      out << ")rec\"\n";
    }
    api::setReproducible(false);
  }
  static std::map<std::string, std::string>& made() {
    static std::map<std::string, std::string> lines;
    return lines;
  }
};

TEST_P(Recorded, IsWhatItWas) {
  Recorder recorder;
  GetParam().run(recorder);
  made()[GetParam().name] = recorder.line();
  if (std::getenv("HGP_RECORD")) return;
  const auto was = recording().find(GetParam().name);
  ASSERT_NE(was, recording().end()) << GetParam().name << " is not recorded";
  EXPECT_EQ(difference(was->second, recorder.line()), "")
      << GetParam().name << "\nIf this is wanted, record it anew as the head of this file says.";
}

std::string testName(const testing::TestParamInfo<Scenario>& info) {
  std::string name;
  for (char c : info.param.name)
    if (std::isalnum(static_cast<unsigned char>(c))) name += c;
  return name + "_" + std::to_string(info.index);
}

INSTANTIATE_TEST_SUITE_P(All, Recorded, testing::ValuesIn(scenarios()), testName);

TEST(Recording, HasNothingThatIsNotRunAnyMore) {
  std::set<std::string> names;
  for (const Scenario& one : scenarios()) EXPECT_TRUE(names.insert(one.name).second) << one.name;
  for (const auto& [name, line] : recording()) EXPECT_TRUE(names.contains(name)) << name;
}

}  // namespace
}  // namespace hgp::recorded

// The number of threads changes no byte of what a run gives, and no word of a failure.
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "corpus/corpus.h"
#include "hgp/api/options_from_json.h"
#include "hgp/api/session.h"
#include "hgp/base/threads.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// What a program can see of a run, without times.
struct Seen {
  std::string failure, certificate, cones;
  std::vector<double> uv;
  std::vector<std::uint32_t> corners;
  std::vector<io::Bytes> files;
  bool isCertified = false;
  bool operator==(const Seen&) const = default;
};

using Load = std::function<Status(api::Session&)>;

Seen seen(int threads, const Load& load, const std::string& options, const std::string& cones) {
  const ThreadScope scope(threads);
  Seen out;
  api::Session session;
  const auto failed = [&](const Status& status) {
    if (!status) out.failure = status.error().stage + ": " + status.error().message;
    return !status;
  };
  if (failed(load(session))) return out;
  const auto solve = api::optionsFromJson<api::SolveOptions>(options);
  HGP_CHECK(solve, "%s", solve.error().message.c_str());
  std::optional<prescription::Prescription> prescription;
  if (!cones.empty()) {
    auto read = api::readPrescription("cones.json", cones, 4);
    HGP_CHECK(read, "%s", read.error().message.c_str());
    prescription = std::move(*read);
  }
  if (failed(session.parametrize(prescription, *solve))) return out;
  out.isCertified = session.isCertified();
  out.certificate = session.certificateJson();
  out.cones = session.conesJson();
  out.uv = session.uv();
  out.corners = session.cornerToUv();
  api::WriteOptions write;
  write.allowUncertified = true;
  for (const auto format :
       {api::MapFormat::kSame, api::MapFormat::kGlb, api::MapFormat::kObj, api::MapFormat::kSvg}) {
    write.format = format;
    write.name = format == api::MapFormat::kGlb   ? "m.glb"
                 : format == api::MapFormat::kSvg ? "m.svg"
                                                  : "m.obj";
    const auto written = session.write(write);
    if (!written) continue;
    for (const auto& file : written->files) out.files.push_back(file.bytes);
  }
  return out;
}

Seen expectSame(const std::string& name, const Load& load, const std::string& options,
                const std::string& cones = "") {
  const Seen one = seen(1, load, options, cones);
  for (const int threads : {2, 4}) {
    const bool isSame = seen(threads, load, options, cones) == one;
    EXPECT_TRUE(isSame) << name << ' ' << options << " with " << threads << " threads";
  }
  return one;
}

Load arrays(const test::Shape& shape) {
  return [data = shape.data](api::Session& session) {
    return session.loadArrays(data.positions, data.triangles, {});
  };
}

test::Shape several() {
  test::Shape all = test::jittered(test::icosphere(16), 0.005);
  for (const test::Shape& more : {test::jittered(test::disk(24), 0.01), test::torus(40, 20)}) {
    const int first = static_cast<int>(all.data.positions.size());
    all.data.positions.insert(all.data.positions.end(), more.data.positions.begin(),
                              more.data.positions.end());
    for (const auto& t : more.data.triangles)
      all.data.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

TEST(SameBytes, AutomaticConesWithEveryMethod) {
  // Large enough for shared dissections, and with handles, boundary and several components.
  const test::Shape sphere = test::scattered(test::jittered(test::icosphere(30), 0.004));
  int certified = 0;
  for (const char* options :
       {"{}", R"({"method": "soft"})", R"({"improve": "isometric"})", R"({"q": 6})"})
    certified += expectSame("sphere", arrays(sphere), options).isCertified;
  EXPECT_EQ(certified, 4);
  EXPECT_TRUE(
      expectSame("pretzel", arrays(test::jittered(test::pretzel(3, 12), 0.01)), "{}").isCertified);
  EXPECT_TRUE(expectSame("disk", arrays(test::jittered(test::disk(40), 0.01)), "{}").isCertified);
  EXPECT_TRUE(expectSame("several", arrays(several()), "{}").isCertified);
}

TEST(SameBytes, GridsAndPrescriptions) {
  const Load cube = arrays(test::jittered(test::cube(12), 0.004));
  expectSame("cube", cube, R"({"grid": {"cells": 300}})");
  expectSame("cube", cube, "{}",
             R"({"format": "hgp-cones", "version": 1, "q": 4, "cones": [)"
             R"({"vertex": 3, "k": 2}, {"vertex": 200, "k": 2}, {"vertex": 400, "k": 2},)"
             R"({"vertex": 700, "k": 2}]})");
  // Gauss–Bonnet fails.
  const Seen impossible = expectSame("cube", cube, "{}",
                                     R"({"format": "hgp-cones", "version": 1, "q": 4, "cones": [)"
                                     R"({"vertex": 3, "k": 3}]})");
  EXPECT_FALSE(impossible.failure.empty());
}

TEST(SameBytes, RealMeshes) {
  const std::vector<std::string> names = {"OptCuts/feline_half.obj", "OptCuts/multiComp.obj",
                                          "Directional/train-station.off", "BFF/cowhead.obj",
                                          "odedstein-meshes/spot_low_resolution.obj"};
  int found = 0;
  for (const std::string& name : names) {
    if (!test::hasFile(name)) continue;
    ++found;
    io::FileSet files;
    files.main = test::bytesOf(name);
    files.name = name.ends_with(".gz") ? name.substr(0, name.size() - 3) : name;
    const Load load = [&](api::Session& session) { return session.load(files, {}); };
    EXPECT_TRUE(expectSame(name, load, "{}").failure.empty()) << name;
  }
  if (found == 0) GTEST_SKIP() << "no real meshes here";
}

}  // namespace
}  // namespace hgp

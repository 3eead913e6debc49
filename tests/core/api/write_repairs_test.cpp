#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hgp/api/session.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

using Json = nlohmann::json;

io::FileSet fileOf(const std::string& name, io::Bytes bytes) {
  io::FileSet files;
  files.name = name;
  files.main = std::move(bytes);
  return files;
}

/// Two spheres that share vertex 0; three faces of the first are turned over.
MeshData damaged() {
  MeshData data = test::icosphere(2).data;
  const MeshData once = data;
  const int first = static_cast<int>(data.positions.size());
  const Vec3 pole = once.positions[0];
  for (const Vec3& p : once.positions)
    data.positions.push_back({2 * pole[0] - p[0], 2 * pole[1] - p[1], 2 * pole[2] - p[2]});
  for (const auto& t : once.triangles) {
    const auto moved = [&](int v) { return v == 0 ? 0 : v + first; };
    data.triangles.push_back({moved(t[0]), moved(t[2]), moved(t[1])});
  }
  data.positions.erase(data.positions.begin() + first);
  for (auto& t : data.triangles)
    for (int& v : t) v -= v > first;
  for (const std::size_t f : {3, 4, 11}) std::swap(data.triangles[f][1], data.triangles[f][2]);
  return data;
}

struct Outcome {
  Json report;
  io::Bytes bytes;
};

Outcome solved(io::FileSet files, bool writes, const std::string& target) {
  Session session;
  LoadOptions load;
  load.writesRepairs = writes;
  load.target = target;
  Status done = session.load(std::move(files), load);
  if (done) done = session.parametrize(std::nullopt, {});
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  if (!done) return {};
  EXPECT_TRUE(session.isCertified());
  WriteOptions options;
  options.name = "out." + target;
  Result<WrittenMap> written = session.write(options);
  EXPECT_TRUE(written) << (written ? "" : written.error().message);
  return {Json::parse(session.reportJson()), written ? written->files[0].bytes : io::Bytes()};
}

class WriteRepairs : public testing::TestWithParam<const char*> {};

TEST_P(WriteRepairs, TheWrittenFileIsAsTheCertificateSeesIt) {
  const std::string format = GetParam();
  const MeshData mesh = damaged();
  const io::Bytes input = io::writePlainObj(mesh, {}, "");
  const Outcome plain = solved(fileOf("in.obj", input), false, format);
  const Outcome written = solved(fileOf("in.obj", input), true, format);
  EXPECT_TRUE(plain.report["repairsWritten"].is_null());
  EXPECT_EQ(plain.report["certificate"]["stored"]["reversed"], 3);
  EXPECT_EQ(written.report["repairsWritten"], (Json{{"facesTurned", 3}, {"verticesCopied", 1}}));
  EXPECT_EQ(written.report["certificate"]["stored"]["reversed"], 0);
  EXPECT_EQ(written.report["input"]["vertices"], mesh.positions.size());

  Session again;
  LoadOptions strict;
  strict.isStrict = true;
  ASSERT_TRUE(again.load(fileOf("out." + format, written.bytes), strict));
  const Result<Verdict> verdict = again.verify(std::nullopt, {});
  if (format == "obj") {
    ASSERT_TRUE(verdict) << verdict.error().message;
    EXPECT_TRUE(verdict->isGood);
    return;
  }
  // In glTF equal positions are one vertex again: that is all that is left to repair.
  ASSERT_FALSE(verdict);
  EXPECT_NE(verdict.error().message.find("1 vertex joins several fans"), std::string::npos)
      << verdict.error().message;
  Session lenient;
  ASSERT_TRUE(lenient.load(fileOf("out.glb", written.bytes), {}));
  const Result<Verdict> good = lenient.verify(std::nullopt, {});
  ASSERT_TRUE(good);
  EXPECT_TRUE(good->isGood);
}

INSTANTIATE_TEST_SUITE_P(Formats, WriteRepairs, testing::Values("obj", "glb"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace hgp::api

// What the reasons of a certificate say of a file with several components.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hgp/api/session.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

using Json = nlohmann::json;

/// The surface twice in one file, with its map; the ids of the second begin at `vertices`, `loops` and `handles`.
struct Twice {
  int vertices = 0, loops = 0, handles = 0;
  Session mapped;
  prescription::Prescription cones;
};

Twice twice(const test::Shape& shape) {
  Twice out;
  out.vertices = static_cast<int>(shape.data.positions.size());
  out.loops = shape.loops;
  out.handles = 2 * shape.genus;
  std::vector<Vec3> positions = shape.data.positions;
  std::vector<std::array<int, 3>> triangles = shape.data.triangles;
  for (const Vec3& p : shape.data.positions) positions.push_back({p[0] + 20, p[1], p[2]});
  for (const auto& t : shape.data.triangles)
    triangles.push_back({t[0] + out.vertices, t[1] + out.vertices, t[2] + out.vertices});
  Session solved;
  EXPECT_TRUE(solved.loadArrays(positions, triangles, {}));
  EXPECT_TRUE(solved.parametrize(std::nullopt, {}));
  EXPECT_TRUE(solved.isCertified());
  WriteOptions options;
  options.name = "twice.obj";
  const Result<WrittenMap> written = solved.write(options);
  EXPECT_TRUE(written);
  io::FileSet files;
  files.name = options.name;
  files.main = written->files[0].bytes;
  EXPECT_TRUE(out.mapped.load(std::move(files), {}));
  out.cones = *readPrescription("cones.json", solved.conesJson(), 4);
  return out;
}

/// The reasons for which the map does not have these cones, turnings and rotations, component after component.
std::vector<Json> reasons(const Twice& file) {
  const Result<Verdict> verdict = file.mapped.verify(file.cones, {});
  EXPECT_TRUE(verdict) << verdict.error().message;
  EXPECT_FALSE(verdict->isGood);
  std::vector<Json> out;
  const Json certificate = Json::parse(verdict->json);
  for (const Json& component : certificate["components"])
    for (const Json& reason : component["reasons"]) out.push_back(reason);
  return out;
}

bool says(const Json& reason, const std::string& words) {
  return reason["message"].get<std::string>().find(words) != std::string::npos;
}

TEST(Reasons, NameTheVertexOfTheFileAndByHowMuchItsAngleDiffersFromTheAskedOne) {
  Twice file = twice(test::icosphere(2));
  std::vector<prescription::PrescribedCone*> second;
  for (prescription::PrescribedCone& cone : file.cones.cones)
    if (cone.vertex >= file.vertices) second.push_back(&cone);
  ASSERT_GE(second.size(), 4U);
  second[2]->k += 2;  // half a turn, which two others pay for
  for (const std::size_t n : {0, 1}) second[n]->k -= 1;
  const std::vector<Json> found = reasons(file);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["rule"], "cone-angle");
  EXPECT_EQ(found[0]["where"][0]["id"], second[2]->vertex) << found[0];
  EXPECT_TRUE(
      says(found[0], "In component 1: 3 interior angle sums are not as asked; worst at vertex " +
                         std::to_string(second[2]->vertex) + ": k = "))
      << found[0];
  EXPECT_TRUE(says(found[0], "off by 3.14 rad")) << found[0];
  EXPECT_NEAR(found[0]["worst"].get<double>(), 2.0, 1e-9);
}

TEST(Reasons, NameTheLoopAndTheHandleOfTheFile) {
  Twice file = twice(test::puncturedTorus(12, 10));
  for (prescription::PrescribedTurning& turning : file.cones.boundaries)
    if (turning.loop >= file.loops) turning.l += 1;
  for (prescription::PrescribedHandle& handle : file.cones.handles)
    if (handle.generator == file.handles + 1) handle.r = (handle.r + 1) % 4;
  bool isLoop = false, isHandle = false;
  for (const Json& reason : reasons(file)) {
    if (reason["rule"] == "turning") {
      isLoop = true;
      EXPECT_TRUE(says(reason, "worst loop " + std::to_string(file.loops) + ": l = ")) << reason;
      EXPECT_TRUE(says(reason, "off by 1.57 rad")) << reason;
    }
    if (reason["rule"] == "handle") {
      isHandle = true;
      EXPECT_TRUE(says(reason, "first is handle " + std::to_string(file.handles + 1) + ": "))
          << reason;
    }
  }
  EXPECT_TRUE(isLoop);
  EXPECT_TRUE(isHandle);
}

}  // namespace
}  // namespace hgp::api

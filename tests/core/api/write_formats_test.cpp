// A result in other formats than that of its file.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "hgp/api/option_words.h"
#include "hgp/api/session.h"
#include "hgp/io/convert.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

using Json = nlohmann::json;

Session solved(const MeshData& mesh, SolveOptions options = {}) {
  Session session;
  Status done = session.loadArrays(mesh.positions, mesh.triangles, {});
  if (done) done = session.parametrize(std::nullopt, options);
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  EXPECT_TRUE(session.isCertified());
  return session;
}

io::Written in(const Session& session, MapFormat format, const std::string& name) {
  WriteOptions options;
  options.format = format;
  options.name = name;
  Result<WrittenMap> written = session.write(options);
  EXPECT_TRUE(written) << (written ? "" : written.error().message);
  if (!written) return {};
  EXPECT_TRUE(written->isCertified);
  return *written;
}

/// Read again and verified, with the cones that were solved for.
Json verified(const io::Written& written, const Session& from) {
  io::FileSet files;
  files.name = written.files[0].name;
  files.main = written.files[0].bytes;
  files.resolve = [&](const std::string& name) -> Result<io::Bytes> {
    for (const io::OutputFile& file : written.files)
      if (file.name == name) return file.bytes;
    return Failure{ErrorCode::kMalformed, "read", name, {}};
  };
  Session again;
  const Status done = again.load(std::move(files), {});
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  const auto cones = readPrescription("cones.json", from.conesJson(), 0);
  const Result<Verdict> verdict = again.verify(*cones, {});
  EXPECT_TRUE(verdict) << (verdict ? "" : verdict.error().message);
  return verdict ? Json::parse(verdict->json) : Json();
}

TEST(WriteFormats, EveryMeshFormatIsCertifiedWithTheSameCones) {
  for (const auto& shape : {test::icosphere(3), test::torus(12, 9), test::disk(5)}) {
    const Session session = solved(shape.data);
    const std::pair<MapFormat, const char*> all[] = {
        {MapFormat::kGlb, "a.glb"}, {MapFormat::kGltf, "a.gltf"}, {MapFormat::kObj, "a.obj"}};
    for (const auto& [format, name] : all) {
      const io::Written written = in(session, format, name);
      ASSERT_EQ(written.files.size(), format == MapFormat::kGltf ? 2U : 1U) << name;
      const Json certificate = verified(written, session);
      EXPECT_EQ(certificate["certified"], true) << shape.name << " " << name;
      EXPECT_EQ(certificate["triangles"], shape.data.triangles.size());
    }
  }
}

TEST(WriteFormats, TheCertificateIsThatOfTheBytes) {
  // Numbers that depend on the stored digits: seams that are exact, residuals, angles.
  const auto facts = [](const Json& certificate) {
    Json out;
    for (const char* key : {"exactSeams", "seams", "handles", "angles", "distortion", "triangles"})
      if (certificate.contains(key)) out[key] = certificate[key];
    if (certificate.contains("components"))
      for (const Json& part : certificate["components"])
        for (const char* key : {"exactSeams", "seams", "triangles"})
          if (part.contains(key)) out["components"].push_back(part[key]);
    return out;
  };
  for (const Scale scale : {Scale::kSolved, Scale::kUnit, Scale::kFit})
    for (const auto& shape : {test::pretzel(3, 2), test::jittered(test::icosphere(3), 0.05)}) {
      SolveOptions options;
      options.scale = scale;
      const Session session = solved(shape.data, options);
      const Json read = facts(verified(in(session, MapFormat::kObj, "a.obj"), session));
      const Json told = facts(Json::parse(session.certificateJson()));
      EXPECT_FALSE(told.empty());
      EXPECT_EQ(told, read) << shape.name;
    }
}

TEST(WriteFormats, AMapInSinglePrecisionKeepsItsNumbers) {
  const Session first = solved(test::torus(12, 9).data);
  io::FileSet files;
  files.name = "a.glb";
  files.main = in(first, MapFormat::kGlb, "a.glb").files[0].bytes;
  Session session;
  ASSERT_TRUE(session.load(std::move(files), {}));
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  const io::Written written = in(session, MapFormat::kObj, "a.obj");
  io::FileSet again;
  again.name = "a.obj";
  again.main = written.files[0].bytes;
  const auto document = io::openDocument(std::move(again), {});
  ASSERT_TRUE(document);
  const UvMap map = *(*document)->existingUv(0, 0);
  for (std::size_t c = 0; c < session.cornerToUv().size(); ++c) {
    const auto corner = static_cast<std::size_t>(map.cornerUv[c / 3][c % 3]);
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_EQ(map.uv[corner][k], session.uv()[2 * session.cornerToUv()[c] + k]);
  }
}

TEST(WriteFormats, AMapThatSeparatesVerticesWhichAGltfJoinsIsRefused) {
  // A square of two triangles that do not share their diagonal.
  const MeshData cut{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                     {{0, 1, 2}, {3, 4, 5}}};
  Session session;
  LoadOptions load;
  load.weld = LoadOptions::kWeldNever;
  ASSERT_TRUE(session.loadArrays(cut.positions, cut.triangles, load));
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  WriteOptions options;
  options.format = MapFormat::kGlb;
  EXPECT_EQ(session.write(options).error().code, ErrorCode::kUnsupported);
  options.format = MapFormat::kObj;
  EXPECT_TRUE(session.write(options));
}

TEST(WriteFormats, AnAlignedMapStaysAligned) {
  SolveOptions options;
  options.grid.cells = 400;
  const Session session = solved(test::icosphere(3).data, options);
  ASSERT_TRUE(session.isAligned());
  for (const MapFormat format : {MapFormat::kGlb, MapFormat::kObj}) {
    const Json certificate =
        verified(in(session, format, format == MapFormat::kGlb ? "a.glb" : "a.obj"), session);
    EXPECT_EQ(certificate["certified"], true);
  }
}

TEST(WriteFormats, DrawingsAndFlatMeshes) {
  const Session session = solved(test::icosphere(2).data);
  const auto text = [](const io::Written& w) {
    return std::string(w.files[0].bytes.begin(), w.files[0].bytes.end());
  };
  EXPECT_EQ(text(in(session, MapFormat::kSvg, "a.svg")).substr(0, 4), "<svg");
  const std::string flat = text(in(session, MapFormat::kFlatObj, "a.flat.obj"));
  EXPECT_NE(flat.find("\nvt "), std::string::npos);
}

TEST(WriteFormats, TheGridHasAGivenOrTheDefaultNumberOfTiles) {
  const Session session = solved(test::icosphere(2).data);
  WriteOptions options;
  options.name = "a.obj";
  options.gridTiles = 4;
  const auto four = session.write(options);
  ASSERT_TRUE(four);
  ASSERT_EQ(four->files.size(), 3U);
  EXPECT_NE(std::string(four->files[1].bytes.begin(), four->files[1].bytes.end()).find("-s 2 2 1"),
            std::string::npos);
  options.gridTiles = 0;
  EXPECT_EQ(session.write(options)->files.size(), 3U);
  options.gridTiles = -1;
  EXPECT_EQ(session.write(options).error().code, ErrorCode::kUsage);
}

TEST(WriteFormats, WithoutAResultNothingIsWritten) {
  WriteOptions options;
  options.format = MapFormat::kSvg;
  EXPECT_EQ(Session().write(options).error().code, ErrorCode::kUsage);
  EXPECT_EQ(mapFormatNamed("flat-obj"), MapFormat::kFlatObj);
  EXPECT_FALSE(mapFormatNamed("stl"));
}

TEST(WriteFormats, PartsThatMeetAtAnEdgeAreRoundedEachOnItsOwn) {
  const char* given = std::getenv("HGP_SHARED_MESHES");
  const std::string name =
      std::string(given ? given : HGP_SHARED_MESHES_DEFAULT) + "/../cases/real/glass-table.glb";
  std::ifstream file(name, std::ios::binary);
  if (!file) GTEST_SKIP() << "optional data are not there: " << name;
  const io::Bytes bytes(std::istreambuf_iterator<char>(file), {});
  for (int surface = 0; surface < 5; ++surface) {
    io::FileSet files;
    files.name = "table.glb";
    files.main = bytes;
    LoadOptions options;
    options.surface = surface;
    Session session;
    ASSERT_TRUE(session.load(std::move(files), options));
    ASSERT_TRUE(session.parametrize(std::nullopt, {}));
    EXPECT_TRUE(session.isCertified()) << surface << session.certificateJson();
  }
}

}  // namespace
}  // namespace hgp::api

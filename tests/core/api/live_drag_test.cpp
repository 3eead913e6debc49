#include "hgp/api/live_drag.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hgp/api/model/load_model.h"
#include "hgp/api/request/request.h"
#include "hgp/api/stored/stored_map.h"
#include "hgp/io/cone_files.h"
#include "hgp/verify/certificate.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

/// Two components: the cone that is dragged is on the second one.
MeshData twoSpheres() {
  MeshData all = test::jittered(test::icosphere(4), 0.02).data;
  const MeshData other = test::jittered(test::icosphere(5), 0.02, 2).data;
  const int shift = static_cast<int>(all.positions.size());
  for (Vec3 p : other.positions) {
    p[0] += 3.0;
    all.positions.push_back(p);
  }
  for (auto t : other.triangles) {
    for (int& v : t) v += shift;
    all.triangles.push_back(t);
  }
  return all;
}

struct Dragged {
  Dragged() {
    const MeshData mesh = twoSpheres();
    EXPECT_TRUE(session.loadArrays(mesh.positions, mesh.triangles, {}));
    EXPECT_TRUE(session.parametrize(std::nullopt, {}));
    EXPECT_TRUE(session.isCertified());
    const auto cones = readPrescription("c.json", session.conesJson(), 4);
    EXPECT_TRUE(cones);
    isCone.resize(mesh.positions.size(), 0);
    for (const prescription::PrescribedCone& c : cones->cones)
      isCone[static_cast<std::size_t>(c.vertex)] = 1;
    cone = cones->cones.back().vertex;
    for (const auto& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] == cone && isCone[static_cast<std::size_t>(t[(k + 1) % 3])] == 0)
          beside = t[(k + 1) % 3];
  }
  Session session;
  std::vector<char> isCone;
  int cone = -1, beside = -1;
};

TEST(LiveDrag, ItsMapIsCertifiedForItsConesAlsoWhenReadFromTheArrays) {
  Dragged on;
  Result<LiveDrag> drag = LiveDrag::begin(on.session, on.cone);
  ASSERT_TRUE(drag) << drag.error().message;
  const Result<LiveView> view = drag->moveTo(on.beside);
  ASSERT_TRUE(view) << view.error().message;
  ASSERT_EQ(view->state, LiveState::kCertified);
  EXPECT_TRUE(view->notPositive.empty() && view->reasons.empty());
  EXPECT_TRUE(std::isnan(view->logScale.front()));
  EXPECT_FALSE(std::isnan(view->logScale.back()));
  // Nothing but the arrays and the cones: as another program would read them.
  const auto cones = readPrescription("c.json", view->cones, 4);
  ASSERT_TRUE(cones);
  const Result<Model> model = modelOfArrays(twoSpheres(), {});
  ASSERT_TRUE(model);
  const Result<Request> request = resolve(*model, *cones);
  ASSERT_TRUE(request);
  UvMap map;
  for (std::size_t i = 0; i < view->uv.size(); i += 2)
    map.uv.push_back({view->uv[i], view->uv[i + 1]});
  for (std::size_t i = 0; i < view->cornerToUv.size(); i += 3)
    map.cornerUv.push_back({static_cast<int>(view->cornerToUv[i]),
                            static_cast<int>(view->cornerToUv[i + 1]),
                            static_cast<int>(view->cornerToUv[i + 2])});
  for (std::size_t p = 0; p < 2; ++p) {
    const ModelComponent& component = model->components[p];
    EXPECT_TRUE(certify(component.mesh, request->components[p].spec, mapOfComponent(component, map))
                    .isCertified);
  }
}

TEST(LiveDrag, DroppingTheConeGivesTheResultOfANewRunAndEndsTheDrag) {
  Dragged on;
  Result<LiveDrag> drag = LiveDrag::begin(on.session, on.cone);
  ASSERT_TRUE(drag);
  const Result<LiveView> view = drag->moveTo(on.beside);
  ASSERT_TRUE(view);
  const auto cones = readPrescription("c.json", view->cones, 4);
  ASSERT_TRUE(cones);
  ASSERT_TRUE(on.session.parametrize(*cones, {}));
  EXPECT_TRUE(on.session.isCertified());
  EXPECT_EQ(on.session.conesJson(), view->cones);
  const Result<LiveView> late = drag->moveTo(on.cone);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().code, ErrorCode::kUsage);
  EXPECT_FALSE(drag->prepareHere());
}

TEST(LiveDrag, DropStoresTheMapOfTheDragAndCertifiesWhatIsStored) {
  Dragged on;
  Result<LiveDrag> drag = LiveDrag::begin(on.session, on.cone);
  ASSERT_TRUE(drag);
  const Result<LiveView> view = drag->moveTo(on.beside);
  ASSERT_TRUE(view);
  ASSERT_EQ(view->state, LiveState::kCertified);
  ASSERT_TRUE(drag->drop());
  EXPECT_TRUE(on.session.isCertified());
  EXPECT_EQ(on.session.conesJson(), view->cones);
  EXPECT_NE(on.session.reportJson().find("\"map-dragged\""), std::string::npos);
  EXPECT_FALSE(drag->drop()) << "the drag has ended";
  // What is written is read and verified like any file.
  const Result<WrittenMap> written = on.session.write({});
  ASSERT_TRUE(written) << written.error().message;
  EXPECT_TRUE(written->isCertified);
  io::FileSet files;
  files.name = "mesh.obj";
  files.main = written->files[0].bytes;
  Session reader;
  ASSERT_TRUE(reader.load(std::move(files), {}));
  const auto cones = readPrescription("c.json", view->cones, 4);
  ASSERT_TRUE(cones);
  const Result<Verdict> verdict = reader.verify(*cones, {});
  ASSERT_TRUE(verdict);
  EXPECT_TRUE(verdict->isGood);
  EXPECT_TRUE(LiveDrag::begin(on.session, on.beside)) << "the next drag starts from it";
  const std::vector<double> dragged = on.session.uv();
  ASSERT_TRUE(on.session.parametrize(*cones, {}));
  EXPECT_NE(on.session.uv(), dragged) << "a run with these cones is a run of its own";
}

TEST(LiveDrag, RefusesWhatIsNoConeAndSessionsWithoutAMap) {
  Dragged on;
  EXPECT_FALSE(LiveDrag::begin(on.session, on.beside));
  EXPECT_FALSE(LiveDrag::begin(on.session, -1));
  EXPECT_FALSE(LiveDrag::begin(on.session, 1'000'000));
  Session empty;
  EXPECT_FALSE(LiveDrag::begin(empty, 0));
  Result<LiveDrag> drag = LiveDrag::begin(on.session, on.cone);
  ASSERT_TRUE(drag);
  const Result<LiveView> elsewhere = drag->moveTo(0);  // on the other sphere
  ASSERT_FALSE(elsewhere);
  EXPECT_EQ(elsewhere.error().code, ErrorCode::kUsage);
}

TEST(LogScale, IsThatOfTheRunAndKeepsNothingThatARunWouldSee) {
  Dragged on;
  const auto cones = readPrescription("c.json", on.session.conesJson(), 4);
  ASSERT_TRUE(cones);
  Result<LiveDrag> drag = LiveDrag::begin(on.session, on.cone);
  ASSERT_TRUE(drag);
  const Result<LiveView> view = drag->moveTo(on.beside);
  ASSERT_TRUE(view);
  prescription::Prescription moved = *cones;
  for (prescription::PrescribedCone& c : moved.cones)
    if (c.vertex == on.cone) c.vertex = on.beside;
  const Result<std::vector<float>> scale = on.session.logScale(moved);
  ASSERT_TRUE(scale) << scale.error().message;
  ASSERT_EQ(scale->size(), view->logScale.size());
  double spread = 0.0;
  for (std::size_t v = 0; v < scale->size(); ++v) {
    ASSERT_FALSE(std::isnan((*scale)[v])) << "both components have cones";
    if (std::isnan(view->logScale[v])) continue;
    spread = std::max(spread, std::fabs(static_cast<double>((*scale)[v] - view->logScale[v])));
  }
  EXPECT_LT(spread, 1e-4);

  ASSERT_TRUE(on.session.parametrize(moved, {}));
  Session other;
  const MeshData mesh = twoSpheres();
  ASSERT_TRUE(other.loadArrays(mesh.positions, mesh.triangles, {}));
  ASSERT_TRUE(other.parametrize(moved, {}));
  EXPECT_EQ(on.session.uv(), other.uv());
}

TEST(LogScale, IsUnknownWhereNothingIsPrescribedAndRefusesWhatHasNoMap) {
  Dragged on;
  const auto cones = readPrescription("c.json", on.session.conesJson(), 4);
  prescription::Prescription few = *cones;
  few.cones.clear();
  few.handles.clear();
  const Result<std::vector<float>> none = on.session.logScale(few);
  ASSERT_TRUE(none);
  for (const float u : *none) ASSERT_TRUE(std::isnan(u));
  few = *cones;
  few.cones.pop_back();
  const Result<std::vector<float>> bad = on.session.logScale(few);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().code, ErrorCode::kPrescription);
  EXPECT_FALSE(Session().logScale(few));
}

}  // namespace
}  // namespace hgp::api

#include <cmath>
#include <cstdlib>

#include "hgp/base/turns.h"
#include "hgp/io/cone_files.h"
#include "io_support.h"

namespace hgp::io {
namespace {

Result<prescription::Prescription> read(const std::string& name, const std::string& text,
                                        int q = 4) {
  return readPrescription(name, text, q);
}

bool isRefused(const std::string& name, const std::string& text) {
  Result<prescription::Prescription> p = read(name, text);
  return !p && !p.error().message.empty();
}

TEST(ConesJson, WrittenConesAreReadBackTheSame) {
  prescription::Prescription p;
  p.q = 6;
  p.hasCones = true;
  p.cones = {{4, 5, Vec3{0.1, 1.0 / 3.0, -2}}, {9, 7, std::nullopt}};
  p.boundaries = {{0, -3, 17}};
  p.handles = {{1, 5}};
  p.vertexCount = 100;
  p.triangleCount = 196;
  p.sha256 = "ab";
  p.field.emplace();
  p.field->order = 6;
  p.field->hasMatchings = true;
  p.field->matchings = {{3, 4, 10, 11, 2}};
  for (int indent : {-1, 2}) {
    Result<prescription::Prescription> r =
        prescription::readConesJson(prescription::writeConesJson(p, indent));
    ASSERT_TRUE(r.hasValue()) << r.error().message;
    EXPECT_EQ(r->q, 6);
    ASSERT_EQ(r->cones.size(), 2u);
    EXPECT_EQ(r->cones[0].position, p.cones[0].position);
    EXPECT_EQ(r->cones[1].k, 7);
    EXPECT_EQ(r->boundaries[0].l, -3);
    EXPECT_EQ(r->boundaries[0].anchor, 17);
    EXPECT_EQ(r->handles[0].r, 5);
    EXPECT_EQ(r->sha256, "ab");
    EXPECT_EQ(r->vertexCount, 100);
    EXPECT_EQ(r->field->matchings[0].turn, 2);
    EXPECT_EQ(r->field->matchings[0].from, 3);
  }
}

TEST(ConesJson, RefusesWhatItDoesNotUnderstand) {
  EXPECT_TRUE(isRefused("a.json", "{"));
  EXPECT_TRUE(isRefused("a.json", "{}"));
  EXPECT_TRUE(isRefused("a.json", R"({"q":4.5})"));
  EXPECT_TRUE(isRefused("a.json", R"({"q":4,"format":"other"})"));
  EXPECT_TRUE(isRefused("a.json", R"({"q":4,"version":2})"));
  EXPECT_TRUE(isRefused("a.json", R"({"q":4,"cones":[{"vertex":1}]})"));
  EXPECT_TRUE(isRefused("a.json", R"({"q":4,"cones":[{"vertex":1,"k":2.5}]})"));
  EXPECT_TRUE(isRefused("a.json", R"({"q":4,"cones":[{"vertex":99999999999,"k":2}]})"));
  EXPECT_TRUE(isRefused("a.json", R"({"q":4,"cones":[3]})"));
  EXPECT_TRUE(isRefused("a.json", R"({"q":4,"cones":{"vertex":1,"k":2}})"));
  EXPECT_TRUE(isRefused("a.json", R"({"q":4,"cones":[{"vertex":1,"k":2,"position":[1,2]}]})"));
  EXPECT_TRUE(isRefused("a.json", R"({"q":4,"boundaries":[{"loop":0}]})"));
  EXPECT_TRUE(isRefused("a.json", "{\"q\":" + std::string(100000, '[')));
}

TEST(ConesJson, CreasesAreAnAngleBelowAHalfTurn) {
  const auto text = [](const char* angle) {
    return std::string(R"({"q":4,"features":{"creases":)") + angle + "}}";
  };
  for (const char* angle : {"0", "-1", "180", "1e9", "true", "\"30\"", "null"})
    EXPECT_TRUE(isRefused("a.json", text(angle))) << angle;
  for (const char* angle : {"0.5", "30", "179.5"}) {
    const Result<prescription::Prescription> read = prescription::readConesJson(text(angle));
    ASSERT_TRUE(read) << angle;
    EXPECT_EQ(*read->features.creaseDegrees, std::atof(angle));
  }
}

TEST(ConesJson, RefusesDeepNestingWhateverStandsBetween) {
  const auto nested = [](int depth) {
    std::string text = R"({"q":4,"cones":[],"extra":)";
    for (int n = 0; n < depth; ++n) text += "[0, 1, ";
    text += "2";
    for (int n = 0; n < depth; ++n) text += "]";
    return text + "}";
  };
  EXPECT_FALSE(isRefused("a.json", nested(50)));
  EXPECT_TRUE(isRefused("a.json", nested(70)));
}

TEST(ConesJson, AnAbsentListIsNotAnEmptyOne) {
  EXPECT_FALSE(read("a.json", R"({"q":4})")->hasCones);
  EXPECT_TRUE(read("a.json", R"({"q":4,"cones":[]})")->hasCones);
}

TEST(ConesText, ReadsConesAndMatchings) {
  Result<prescription::Prescription> p =
      read("a.cones", "# comment\nq 5\ncones 2\n3 4\n7 6\nmatchings 1\n10 11 3 7 -2\n");
  ASSERT_TRUE(p.hasValue()) << p.error().message;
  EXPECT_EQ(p->q, 5);
  EXPECT_EQ(p->cones[1].vertex, 7);
  EXPECT_EQ(p->field->matchings[0].to, 10);
  EXPECT_EQ(p->field->matchings[0].from, 11);
  EXPECT_EQ(p->field->matchings[0].tail, 3);
  EXPECT_EQ(p->field->matchings[0].turn, -2);
  EXPECT_TRUE(isRefused("a.cones", "q 5\ncones 2\n3 4\n"));
  EXPECT_TRUE(isRefused("a.cones", "q 5\ncones 1\n3 4.5\n"));
  EXPECT_TRUE(isRefused("a.cones", "q 5\ncones 1\n3 4\n5 6\n"));
  EXPECT_TRUE(isRefused("a.cones", "q 5\ncones 999999999999\n"));
  EXPECT_TRUE(isRefused("a.cones", ""));
}

TEST(Sings, KIsOrderMinusIndex) {
  Result<prescription::Prescription> p = read("a.sings", "4 3\n5 1\n6 -1\n7 0\n");
  ASSERT_TRUE(p.hasValue());
  ASSERT_EQ(p->cones.size(), 2u);
  EXPECT_EQ(p->cones[0].k, 3);
  EXPECT_EQ(p->cones[1].k, 5);
  Result<prescription::Prescription> broken = read("a.sings", "4 2\n5 1\n61\n");
  ASSERT_FALSE(broken.hasValue());
  EXPECT_NE(broken.error().message.find("line"), std::string::npos);
}

TEST(Sings, NumbersThatNoIntHoldsAreRefused) {
  for (const char* text : {"1963793227 1\n5 -1231582227\n", "4 1\n1532679322831853 1\n"}) {
    Result<prescription::Prescription> p = read("a.sings", text);
    ASSERT_FALSE(p.hasValue()) << text;
    EXPECT_EQ(p.error().code, ErrorCode::kMalformed);
    EXPECT_EQ(p.error().where.at(0).id, 2);
  }
}

TEST(Curvatures, AreExactOrRefused) {
  Result<prescription::Prescription> p =
      read("a.txt", "# x\n3 1.5707963267948966\n4 -1.5707963267948966\n5 0\n");
  ASSERT_TRUE(p.hasValue()) << p.error().message;
  ASSERT_EQ(p->cones.size(), 2u);
  EXPECT_EQ(p->cones[0].k, 3);
  EXPECT_EQ(p->cones[1].k, 5);
  Result<prescription::Prescription> off = read("a.txt", "3 1.5707963267948966\n4 0.3\n9 1\n");
  ASSERT_FALSE(off.hasValue());
  EXPECT_EQ(off.error().code, ErrorCode::kPrescription);
  EXPECT_NE(off.error().message.find("line 2"), std::string::npos) << off.error().message;
  EXPECT_EQ(read("a.txt", "3 1.0471975511965976\n1 0\n2 0\n", 6)->cones[0].k, 5);
}

TEST(TotalAngles, BecomeConesAndTurning) {
  // A fan of four triangles around vertex 0, cut open: 5 boundary vertices would be needed to close.
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  Result<TriMesh> mesh = buildTriMesh(data);
  ASSERT_TRUE(mesh.hasValue());
  const Topology topology = computeTopology(*mesh);
  std::string text = "4.71238898038469\n";                     // k = 3
  for (int i = 0; i < 4; ++i) text += "1.9634954084936207\n";  // 5π/8 each: Σ(π − θ) = 3π/2
  Result<prescription::Prescription> raw = read("x_Th_hat", text);
  ASSERT_TRUE(raw.hasValue());
  Result<prescription::Prescription> p = prescription::reduceTotalAngles(*raw, *mesh, topology, {});
  ASSERT_TRUE(p.hasValue()) << p.error().message;
  ASSERT_EQ(p->cones.size(), 1u);
  EXPECT_EQ(p->cones[0].k, 3);
  ASSERT_EQ(p->boundaries.size(), 1u);
  EXPECT_EQ(p->boundaries[0].l, 3);
  raw->totalAngles[0] += 0.01;
  Result<prescription::Prescription> off =
      prescription::reduceTotalAngles(*raw, *mesh, topology, {});
  ASSERT_FALSE(off.hasValue());
  EXPECT_NE(off.error().message.find("line 1"), std::string::npos);
}

TEST(HgpObj, ConeAndSeamLines) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
      "c 1 1.5\nc 2 1\nsm 2 2 1\nsm 1 1 3\n";
  Result<prescription::Prescription> p = read("a.obj", text);
  ASSERT_TRUE(p.hasValue()) << p.error().message;
  EXPECT_EQ(p->q, 4);
  EXPECT_EQ(p->cones[0].vertex, 0);
  EXPECT_EQ(p->cones[0].k, 3);
  EXPECT_EQ(p->cones[1].k, 2);
  ASSERT_EQ(p->field->matchings.size(), 1u) << "both sides are one edge";
  const Matching& m = p->field->matchings[0];
  EXPECT_EQ(std::min(m.tail, m.head), 0);
  EXPECT_EQ(std::max(m.tail, m.head), 1);
  EXPECT_EQ(m.from == 1 ? m.turn : -m.turn, m.from == 1 ? 1 : -3);
  EXPECT_TRUE(isRefused("a.obj", text + "c 1 0.3\n"));
  EXPECT_TRUE(isRefused("a.obj", text + "c 9 1\n"));
  EXPECT_TRUE(isRefused("a.obj", text + "sm 9 1 0\n"));
  EXPECT_TRUE(isRefused("a.obj", text + "sm 1 4 0\n"));
  EXPECT_TRUE(isRefused("a.obj",
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n"
                        "sm 2 2 1\nsm 1 1 1\n"))
      << "two sides that contradict each other";
}

TEST(RawField, MustBeARosy) {
  EXPECT_TRUE(read("a.rawfield", "4 1\n1 0 0 0 1 0 -1 0 0 0 -1 0\n").hasValue());
  EXPECT_TRUE(read("a.rawfield", "4 1\n1 0 0 0 -1 0 -1 0 0 0 1 0\n").hasValue()) << "clockwise";
  EXPECT_TRUE(isRefused("a.rawfield", "4 1\n1 0 0 0 1 0 -1 0 0 0 1 0\n"));
  EXPECT_TRUE(isRefused("a.rawfield", "4 2\n1 0 0 0 1 0 -1 0 0 0 -1 0\n"));
  EXPECT_TRUE(isRefused("a.rawfield", "0 1\n"));
  EXPECT_TRUE(isRefused("a.rawfield", "4 1\n1 0 0 0 1 0 -1 0 0 0 -1 nan\n"));
}

TEST(Rosy, TakesOneDirectionPerFace) {
  Result<prescription::Prescription> p = read("a.rosy", "2\n4\n1 0 0\n0 1 0\n");
  ASSERT_TRUE(p.hasValue());
  EXPECT_EQ(p->field->directions.size(), 2u);
  EXPECT_TRUE(isRefused("a.rosy", "2\n4\n1 0 0\n"));
}

TEST(FField, StoredMatchingsAreTaken) {
  const std::string head =
      "target_frame\n2\nk1 k2 k1v_x k1v_y k1v_z k2v_x k2v_y k2v_z\n"
      "0 0 1 0 0 0 1 0\n0 0 0 1 0 1 0 0\ncrossfield_angles\n0.1 0.2\nfixed\n1 0\n";
  // Faces (0 1 2) and (0 2 3) share the edge 0–2; the halfedge of face 0 that points to 0 is 2 → 0.
  const std::string tail = "MI_matchings_and_sharp\n0 1 2 1 0 0 0 0 0\n0 2 3 0 -1 0 0 0 0\n";
  for (int version : {1, 2}) {
    Result<prescription::Prescription> p =
        read("a.ffield", "# version " + std::to_string(version) + "\n" + head + tail);
    ASSERT_TRUE(p.hasValue()) << p.error().message;
    EXPECT_EQ(p->q, 4);
    EXPECT_EQ(p->field->directions[1], (Vec3{0, 1, 0}));
    ASSERT_EQ(p->field->matchings.size(), 1u);
    Matching m = p->field->matchings[0];
    if (m.from == 1) std::swap(m.tail, m.head), m.turn = -m.turn;
    EXPECT_EQ(reduceTurn(m.turn, 4), reduceTurn(version == 2 ? -1 : 1, 4));
    EXPECT_EQ(m.tail, 2);
    Status done = prescription::completeMatchings(*p->field, {{0, 1, 2}, {0, 2, 3}});
    EXPECT_TRUE(done.hasValue());
    EXPECT_GE(p->field->matchings[0].to, 0);
  }
  EXPECT_TRUE(isRefused("a.ffield", "nonsense"));
}

TEST(SharedCones, AreReadCompletely) {
  struct Known {
    const char* name;
    int q;
  };
  for (const Known& k :
       {Known{"cones/Directional__eight.cones", 4}, Known{"cones/Directional__torus-hex.cones", 6},
        Known{"cones/Directional__train-station-5.cones", 5},
        Known{"cones/Directional__vase-7.cones", 7}, Known{"Directional/torus-hex.rawfield", 6},
        Known{"Directional/train-station-5.rawfield", 5}, Known{"Directional/vase-7.rawfield", 7},
        Known{"Directional/torus_twosings.rawfield", 4}, Known{"Directional/eight.sings", 4}}) {
    std::string text;
    if (!test::readShared(k.name, text))
      GTEST_SKIP() << "no data folder at " << test::sharedMeshes();
    Result<prescription::Prescription> p = read(k.name, text);
    ASSERT_TRUE(p.hasValue()) << k.name << ": " << p.error().message;
    EXPECT_EQ(p->q, k.q) << k.name;
  }
}

}  // namespace
}  // namespace hgp::io

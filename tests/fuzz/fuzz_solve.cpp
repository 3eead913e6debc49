// Small surfaces with cones at random, solved; what is certified is verified by code of its own, written, read
// again and verified once more.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fuzz_support.h"
#include "hgp/api/session.h"
#include "independent_map.h"
#include "small_surface.h"

using namespace hgp;

namespace {

api::SolveOptions solveOptions(fuzz::Bytewise& bytes) {
  constexpr Method kMethods[] = {Method::kAuto, Method::kAuto,    Method::kHarmonic,
                                 Method::kSoft, Method::kPrinted, Method::kAllFrames};
  api::SolveOptions out;
  out.q = 1 + bytes.below(8);
  out.method = kMethods[bytes.below(6)];
  out.maxRounds = 1 + bytes.below(6);
  out.keepsGoing = bytes.below(4) == 0;
  if (bytes.below(4) == 0) out.improve.emplace().balance = bytes.real();
  if (bytes.below(6) == 0) out.grid.cells = 1 + bytes.below(100);
  return out;
}

/// What an oriented manifold may look like: no edge twice in one direction, around every vertex one fan.
bool isPlain(const std::vector<std::uint32_t>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> halfedges;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    if (!halfedges.insert({{triangles[i], triangles[next]}, i}).second) return false;
  }
  std::map<std::uint32_t, int> corners, firstOf, reached;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    ++corners[triangles[i]];
    firstOf.try_emplace(triangles[i], static_cast<int>(i));
  }
  for (const auto& [vertex, first] : firstOf) {
    // Round one way until the fan closes or ends, then the other way.
    int count = 1;
    auto i = static_cast<std::size_t>(first);
    bool isClosed = false;
    for (;;) {
      const std::size_t before = i % 3 == 0 ? i + 2 : i - 1;
      const auto twin = halfedges.find({vertex, triangles[before]});
      if (twin == halfedges.end()) break;
      i = twin->second;
      isClosed = i == static_cast<std::size_t>(first);
      if (isClosed || ++count > corners[vertex]) break;
    }
    for (i = static_cast<std::size_t>(first); !isClosed && count <= corners[vertex];) {
      const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
      const auto twin = halfedges.find({triangles[next], vertex});
      if (twin == halfedges.end()) break;
      i = twin->second % 3 == 2 ? twin->second - 2 : twin->second + 1;
      ++count;
    }
    if (count != corners[vertex]) return false;
  }
  return true;
}

void checkMap(const api::Session& session, const std::optional<prescription::Prescription>& asked) {
  fuzz::FlatMap map{session.triangles(), session.cornerToUv(), session.uv(), 4, {}, 2e-6};
  const auto cones = nlohmann::json::parse(session.conesJson());
  map.q = cones["q"].get<int>();
  for (const auto& cone : cones["cones"])
    map.cones[cone["vertex"].get<int>()] = cone["k"].get<int>();
  const bool isPlainSurface = !session.repaired() && isPlain(session.triangles());
  if (asked && isPlainSurface) {
    fuzz::require(asked->q == map.q, "the order is the one that was asked for");
    for (const prescription::PrescribedCone& cone : asked->cones)
      fuzz::require(cone.k == map.q || map.cones.count(cone.vertex) > 0,
                    "cones that are asked for are there");
  }
  const char* broken = isPlainSurface ? fuzz::brokenLaw(map) : nullptr;
  if (broken != nullptr) fuzz::require(false, broken);
}

/// The written file verifies with the cones that it holds.
void checkWritten(const api::Session& session) {
  api::WriteOptions write;
  write.name = "out.obj";
  write.embedCones = true;
  const auto written = session.write(write);
  fuzz::require(written.hasValue(), "what is certified can be written");
  api::Session again;
  io::FileSet files;
  files.name = "out.obj";
  files.main = written->files[0].bytes;
  fuzz::require(again.load(std::move(files), {}).hasValue(), "what was written can be read");
  const auto cones = again.embeddedCones();
  fuzz::require(cones.hasValue() && cones->has_value(), "the cones are in the file");
  const auto verdict = again.verify(*cones, {});
  const bool isGood = verdict.hasValue() && (verdict->isGood || session.repaired());
  if (!isGood) {
    const io::Bytes& text = written->files[0].bytes;
    std::fprintf(stderr, "%.*s\n%s\n", static_cast<int>(text.size()),
                 reinterpret_cast<const char*>(text.data()),
                 verdict ? verdict->json.c_str() : verdict.error().message.c_str());
  }
  fuzz::require(isGood, "what is certified is so when it is read again");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytewise bytes(data, size);
  const api::SolveOptions options = solveOptions(bytes);
  MeshData mesh = fuzz::baseSurface(bytes);
  for (int n = bytes.below(40); n > 0; --n) fuzz::change(mesh, bytes);
  const std::optional<prescription::Prescription> asked = fuzz::prescription(mesh, bytes);
  api::LoadOptions load;
  load.isStrict = bytes.below(4) == 0;
  api::Session session;
  const Status loaded = session.loadArrays(mesh.positions, mesh.triangles, load);
  if (!loaded) {
    fuzz::require(loaded.error().code != ErrorCode::kInternal, "loading is never our bug");
    return 0;
  }
  const Status solved = session.parametrize(asked, options);
  if (!solved) {
    if (solved.error().code == ErrorCode::kInternal)
      std::fprintf(stderr, "%s\n", solved.error().message.c_str());
    fuzz::require(solved.error().code != ErrorCode::kInternal, "solving is never our bug");
    return 0;
  }
  if (!session.isCertified()) return 0;
  checkMap(session, asked);
  checkWritten(session);
  return 0;
}

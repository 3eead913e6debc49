// hgp/lite: maps and verdicts of arrays, on the method alone.  Role: the module without files, repairs and documents; it calls
// what `hgp::core` has. Every call returns a plain object, with `error`, the JSON of a failure, or its results.
#include "lite.h"

#include <emscripten/bind.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "hgp/api/session/guard.h"
#include "hgp/grid/snap.h"
#include "hgp/parametrize/parametrize.h"

namespace hgp::js {
namespace {

/// A connected part of the surface, with its numbers in the whole.
struct Part {
  TriMesh mesh;
  std::vector<int> vertexOrigin, faceOrigin;
};

/// What is returned: a map of the whole surface, and the certificates of its parts.
struct LiteMap {
  UvMap map;
  std::vector<std::uint32_t> uvToVertex;
  std::vector<std::int32_t> seams;  ///< rows of a0 a1 b0 b1 r
  std::vector<Certificate> certificates;
  std::vector<std::vector<int>> vertices;  ///< those of each part, as it numbers them
};

Failure refusal(ErrorCode code, const char* stage, std::string message) {
  return {code, stage, std::move(message), {}};
}

/// Gives vertices at equal positions, also those of cones, the number of the first of them.
void joinEqual(MeshData& data, LiteOptions& options) {
  std::map<Vec3, int> first;
  std::vector<int> image(data.positions.size());
  for (std::size_t v = 0; v < image.size(); ++v)
    image[v] = first.emplace(data.positions[v], static_cast<int>(v)).first->second;
  const auto join = [&](int& v) {
    if (v >= 0 && static_cast<std::size_t>(v) < image.size())
      v = image[static_cast<std::size_t>(v)];
  };
  for (std::array<int, 3>& triangle : data.triangles)
    for (int& v : triangle) join(v);
  for (auto& cone : options.cones) join(cone.first);
}

Result<std::vector<Part>> partsOf(const MeshData& data) {
  for (const std::array<int, 3>& triangle : data.triangles)
    for (const int v : triangle)
      if (v < 0 || static_cast<std::size_t>(v) >= data.positions.size())
        return refusal(ErrorCode::kUsage, "arguments",
                       "a triangle names the vertex " + std::to_string(v) + " of " +
                           std::to_string(data.positions.size()));
  Result<TriMesh> whole = buildTriMesh(data);
  if (!whole) {
    std::string message = whole.error().message;
    if (message.ends_with('.')) message.pop_back();
    return refusal(whole.error().code, "topology",
                   message + "; hgp repairs such meshes, hgp/lite does not");
  }
  const Topology topology = computeTopology(*whole);
  std::vector<Part> parts;
  for (Component& component : splitComponents(data, *whole, topology)) {
    Result<TriMesh> mesh = buildTriMesh(component.mesh);
    if (!mesh) return mesh.error();
    parts.push_back(
        {std::move(*mesh), std::move(component.vertexOrigin), std::move(component.faceOrigin)});
  }
  return parts;
}

/// The part with the cones that are prescribed in it.
HolonomySpec specOf(const Part& part, const LiteOptions& options) {
  HolonomySpec spec;
  spec.q = options.q;
  for (const auto& [vertex, k] : options.cones) {
    const auto at = std::lower_bound(part.vertexOrigin.begin(), part.vertexOrigin.end(), vertex);
    if (at != part.vertexOrigin.end() && *at == vertex)
      spec.cones.push_back({VertexId(static_cast<int>(at - part.vertexOrigin.begin())), k});
  }
  return spec;
}

Status checkCones(const std::vector<Part>& parts, const LiteOptions& options) {
  for (const auto& cone : options.cones) {
    const bool isThere = std::any_of(parts.begin(), parts.end(), [&](const Part& part) {
      return std::binary_search(part.vertexOrigin.begin(), part.vertexOrigin.end(), cone.first);
    });
    if (!isThere)
      return refusal(
          ErrorCode::kPrescription, "prescription",
          "a cone is at vertex " + std::to_string(cone.first) + ", which has no triangle");
  }
  return Done{};
}

Result<Parametrization> solve(const Part& part, const LiteOptions& options) {
  ParametrizeOptions how;
  how.improve = options.improve;
  how.progress = options.progress;
  if (options.hasCones) return parametrize(part.mesh, specOf(part, options), how);
  SuggestOptions choice;
  choice.q = options.q;
  choice.coneCount = options.count;
  choice.conesFor = options.conesFor;
  choice.progress = options.progress;
  Result<CompleteSpec> cones = suggestCones(part.mesh, choice);
  if (!cones) return cones.error();
  return parametrize(part.mesh, toSpec(*cones), how);
}

/// Moves the map so that its box begins at (x, 0), and returns where it ends.
double place(std::vector<Vec2>& uv, double x) {
  Vec2 low = uv.front(), high = low;
  for (const Vec2& p : uv)
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  for (Vec2& p : uv) p = {p[0] - low[0] + x, p[1] - low[1]};
  return x + 1.05 * (high[0] - low[0]);
}

/// The map in the numbers in which it is stored, with the certificate of these.
Certificate store(const Part& part, const Parametrization& solved, bool isFloat, UvMap& map) {
  const StoredNumbers numbers{isFloat ? 24 : 53, false, false};
  std::vector<VertexId> cones;
  for (const ConePoint& cone : solved.spec.cones) cones.push_back(cone.vertex);
  double step = 0;
  const auto snapper = solved.isCertified
                           ? SeamSnapper::make(part.mesh, solved.map, solved.spec.q, cones)
                           : std::nullopt;
  for (int e = snapper ? snapper->firstExponent(map.uv, numbers) : 0, last = e + 1;
       snapper && e <= last; ++e) {
    const auto snapped = snapper->snap(map.uv, e, numbers);
    if (!snapped) continue;
    map.uv = snapped->uv;
    step = isFloat ? std::scalbn(1.0, e) : 0.0;
    break;
  }
  for (Vec2& p : map.uv)
    for (double& x : p)
      if (isFloat) x = static_cast<double>(static_cast<float>(x));
  CertifyOptions how;
  if (isFloat) how.precision = Precision::kFloat32;
  how.gridStep = step;
  return certify(part.mesh, solved.spec, map, how);
}

void append(const Part& part, const UvMap& map, const std::vector<VertexId>& copyOf,
            const Certificate& certificate, LiteMap& out) {
  const int first = static_cast<int>(out.map.uv.size());
  out.map.uv.insert(out.map.uv.end(), map.uv.begin(), map.uv.end());
  for (const VertexId v : copyOf)
    out.uvToVertex.push_back(
        static_cast<std::uint32_t>(part.vertexOrigin[static_cast<std::size_t>(v.i)]));
  for (std::size_t f = 0; f < map.cornerUv.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      out.map.cornerUv[static_cast<std::size_t>(part.faceOrigin[f])][k] =
          first + map.cornerUv[f][k];
  for (const MeasuredSeam& seam : certificate.seams.seams) {
    const HalfedgeId h = part.mesh.halfedge(seam.edge), twin = part.mesh.twin(h);
    const auto corner = [&](HalfedgeId at) {
      return first +
             map.cornerUv[static_cast<std::size_t>(at.i / 3)][static_cast<std::size_t>(at.i % 3)];
    };
    for (const int i :
         {corner(h), corner(TriMesh::next(h)), corner(TriMesh::next(twin)), corner(twin), seam.r})
      out.seams.push_back(i);
  }
}

Result<LiteMap> mapOf(MeshData data, LiteOptions options) {
  if (options.isJoined) joinEqual(data, options);
  const Result<std::vector<Part>> parts = partsOf(data);
  if (!parts) return parts.error();
  if (Status there = checkCones(*parts, options); !there) return there.error();
  LiteMap out;
  out.map.cornerUv.assign(data.triangles.size(), {-1, -1, -1});
  double x = 0;
  for (const Part& part : *parts) {
    Result<Parametrization> solved = solve(part, options);
    if (!solved) return solved.error();
    UvMap map = solved->map;
    x = place(map.uv, x);
    Certificate certificate = store(part, *solved, options.isFloat, map);
    if (solved->isCertified &&
        !certificate.isCertified) {  // at the origin numbers are most precise
      map = solved->map;
      place(map.uv, 0);
      certificate = store(part, *solved, options.isFloat, map);
    }
    append(part, map, solved->copyOf, certificate, out);
    out.certificates.push_back(std::move(certificate));
    out.vertices.push_back(part.vertexOrigin);
  }
  return out;
}

val parametrizeArrays(const val& mesh, const val& options, const val& onProgress) {
  return guardedLite([&]() -> val {
    const Result<LiteMap> made = mapOf(toMeshData(mesh), toLiteOptions(options, onProgress));
    if (!made) return failedLite(made.error());
    val reply = val::object();
    std::vector<double> uv;
    for (const Vec2& p : made->map.uv) uv.insert(uv.end(), p.begin(), p.end());
    std::vector<std::uint32_t> corners;
    for (const auto& row : made->map.cornerUv)
      for (const int i : row) corners.push_back(static_cast<std::uint32_t>(i));
    reply.set("uv", toTypedArray("Float64Array", uv));
    reply.set("cornerToUv", toTypedArray("Uint32Array", corners));
    reply.set("uvToVertex", toTypedArray("Uint32Array", made->uvToVertex));
    reply.set("seams", toTypedArray("Int32Array", made->seams));
    reply.set("certificate", toCertificate(made->certificates, made->vertices));
    return reply;
  });
}

val verifyArrays(const val& mesh, const val& options) {
  return guardedLite([&]() -> val {
    MeshData data = toMeshData(mesh);
    LiteOptions asked = toLiteOptions(options, val::undefined());
    if (asked.isJoined) joinEqual(data, asked);
    const UvMap whole = toUvMap(mesh);
    const Result<std::vector<Part>> parts = partsOf(data);
    if (!parts) return failedLite(parts.error());
    if (Status there = checkCones(*parts, asked); !there) return failedLite(there.error());
    std::vector<Certificate> certificates;
    std::vector<std::vector<int>> vertices;
    for (const Part& part : *parts) {
      vertices.push_back(part.vertexOrigin);
      UvMap map{whole.uv, {}};
      for (const int f : part.faceOrigin)
        map.cornerUv.push_back(whole.cornerUv[static_cast<std::size_t>(f)]);
      CertifyOptions how;
      how.tolerance = asked.tolerance;
      how.isAnyConeAllowed = !asked.hasCones;
      certificates.push_back(certify(part.mesh, specOf(part, asked), map, how));
    }
    val reply = val::object();
    reply.set("certificate", toCertificate(certificates, vertices));
    return reply;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(hgp_lite) {
  emscripten::function("parametrize", &parametrizeArrays);
  emscripten::function("verify", &verifyArrays);
}

}  // namespace hgp::js

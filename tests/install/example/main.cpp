// A square with a raised middle, mapped onto a convex polygon and verified.
#include <hgp/mesh/tri_mesh.h>
#include <hgp/parametrize/parametrize.h>

#include <cstdio>

int main() {
  hgp::MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.4, 0.5, 0.3}};
  data.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const auto mesh = hgp::buildTriMesh(data);
  if (!mesh) return std::puts(mesh.error().message.c_str()), 1;
  const auto result = hgp::parametrizeConvex(*mesh, {});
  if (!result) return std::puts(result.error().message.c_str()), 1;
  std::printf("certified: %s\n", result->isCertified ? "yes" : "no");
  for (const auto& uv : result->map.uv) std::printf("vt %.17g %.17g\n", uv[0], uv[1]);
  return result->isCertified ? 0 : 1;
}

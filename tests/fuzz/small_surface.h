// Small surfaces and prescriptions out of bytes.  Role: what fuzz_solve solves; every choice is a byte, so that
// the fuzzer can make it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hgp/mesh/mesh_data.h"
#include "hgp/prescription/prescription.h"

namespace hgp::fuzz {

/// Bytes one after the other, zeros behind the last.
class Bytewise {
 public:
  Bytewise(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  int next() { return at_ < size_ ? data_[at_++] : 0; }
  /// In [0, n).
  int below(int n) { return n <= 0 ? 0 : (n > 256 ? next() * 256 + next() : next()) % n; }
  /// In [−1, 1).
  double real() { return (next() * 256 + next()) / 32768.0 - 1.0; }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

/// m × n squares in two triangles each; opposite sides joined where asked.
inline MeshData squares(int m, int n, bool isRound, bool isTorus) {
  MeshData out;
  const int across = isRound ? m : m + 1, up = isTorus ? n : n + 1;
  for (int j = 0; j < up; ++j) {
    for (int i = 0; i < across; ++i) {
      const double a = 6.283185307179586 * i / m, b = 6.283185307179586 * j / n;
      if (isTorus)
        out.positions.push_back(
            {(2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b)});
      else if (isRound)
        out.positions.push_back({std::cos(a), std::sin(a), 1.0 * j});
      else
        out.positions.push_back({1.0 * i, 1.0 * j, 0.1 * ((i * 7 + j * 3) % 5)});
    }
  }
  const auto at = [&](int i, int j) { return (j % up) * across + i % across; };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < m; ++i) {
      out.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      out.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return out;
}

/// A tetrahedron, an octahedron, a disk, an annulus, a torus, or triangles at random.
inline MeshData baseSurface(Bytewise& bytes) {
  switch (bytes.below(7)) {
    case 0:
      return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
              {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    case 1:
      return {
          {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    case 2:
      return squares(1 + bytes.below(6), 1 + bytes.below(6), false, false);
    case 3:
      return squares(3 + bytes.below(6), 1 + bytes.below(4), true, false);
    case 4:
    case 5:
      return squares(3 + bytes.below(5), 3 + bytes.below(5), true, true);
    default: {
      MeshData soup;
      const int vertices = 3 + bytes.below(12);
      for (int v = 0; v < vertices; ++v)
        soup.positions.push_back({bytes.real(), bytes.real(), bytes.real()});
      for (int f = 1 + bytes.below(24); f > 0; --f)
        soup.triangles.push_back(
            {bytes.below(vertices), bytes.below(vertices), bytes.below(vertices)});
      return soup;
    }
  }
}

/// The face with the halfedge from a to b and the corner of a in it; −1: none.
inline std::pair<int, std::size_t> faceWith(const MeshData& mesh, int a, int b) {
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (mesh.triangles[f][k] == a && mesh.triangles[f][(k + 1) % 3] == b)
        return {static_cast<int>(f), k};
  return {-1, 0};
}

/// One change of the surface: a face cut in three or taken away, an edge flipped or halved, a vertex moved, a
/// corner torn off.
inline void change(MeshData& mesh, Bytewise& bytes) {
  const int kind = bytes.below(8);
  const auto f = static_cast<std::size_t>(bytes.below(static_cast<int>(mesh.triangles.size())));
  const auto k = static_cast<std::size_t>(bytes.below(3));
  const std::array<int, 3> t = mesh.triangles[f];
  const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
  const auto position = [&](int v) { return mesh.positions[static_cast<std::size_t>(v)]; };
  const int fresh = static_cast<int>(mesh.positions.size());
  const auto between = [&](std::initializer_list<int> corners) {
    Vec3 p{};
    for (const int v : corners)
      for (std::size_t i = 0; i < 3; ++i)
        p[i] += position(v)[i] / static_cast<double>(corners.size());
    for (double& x : p) x += 0.1 * bytes.real();
    mesh.positions.push_back(p);
  };
  const auto [g, at] = faceWith(mesh, b, a);
  const auto other = static_cast<std::size_t>(std::max(g, 0));
  const int d = g >= 0 ? mesh.triangles[other][(at + 2) % 3] : -1;
  if (kind <= 1) {
    between({a, b, c});
    mesh.triangles[f] = {a, b, fresh};
    mesh.triangles.push_back({b, c, fresh});
    mesh.triangles.push_back({c, a, fresh});
  } else if (kind == 2) {
    between({a, b});
    mesh.triangles[f] = {a, fresh, c};
    mesh.triangles.push_back({fresh, b, c});
    if (g < 0) return;
    mesh.triangles[other] = {b, fresh, d};
    mesh.triangles.push_back({fresh, a, d});
  } else if (kind == 3) {
    const bool isFree =
        g >= 0 && c != d && faceWith(mesh, c, d).first < 0 && faceWith(mesh, d, c).first < 0;
    if (!isFree) return;
    mesh.triangles[f] = {c, a, d};
    mesh.triangles[other] = {d, b, c};
  } else if (kind <= 5) {
    const double far = kind == 4 ? 0.3 : 1000.0;
    for (double& x : mesh.positions[static_cast<std::size_t>(a)]) x += far * bytes.real();
  } else if (kind == 6 && mesh.triangles.size() > 1) {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(f));
  } else if (kind == 7 && bytes.below(4) == 0) {
    mesh.positions.push_back(position(a));
    mesh.triangles[f][k] = fresh;
  }
}

/// Cones anywhere, of any angle; what they leave open is open, and whether they can be is not asked.
inline std::optional<prescription::Prescription> prescription(const MeshData& mesh,
                                                              Bytewise& bytes) {
  if (bytes.below(3) == 0) return std::nullopt;
  prescription::Prescription out;
  out.q = 1 + bytes.below(8);
  out.hasCones = true;
  const int chi2 = 2 * out.q;  // of a sphere, which the last cone balances
  int left = chi2;
  for (int n = bytes.below(9); n > 0; --n) {
    const int vertex = bytes.below(static_cast<int>(mesh.positions.size()));
    const bool isLast = n == 1 && bytes.below(2) == 0;
    const int k = isLast ? out.q - left : 1 + bytes.below(2 * out.q);
    left -= out.q - k;
    out.cones.push_back({vertex, k, std::nullopt});
  }
  return out;
}

}  // namespace hgp::fuzz

#include "arrays.h"

#include <cstring>

#include "hgp/base/check.h"

namespace hgp::python {
namespace {

template <class T>
std::vector<std::array<int, 3>> rowsOf(const T* from, py::ssize_t rows, const char* name,
                                       py::ssize_t count) {
  std::vector<std::array<int, 3>> triangles(static_cast<std::size_t>(rows));
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<long long>(from[3 * f + k]);
      if (v < 0 || v >= count) {
        raise(Failure{ErrorCode::kUsage,
                      "arguments",
                      formatText("%s[%zu, %zu] is %lld; ", name, f, k, v) +
                          (count == 0 ? "there are no vertices"
                                      : formatText("indices are from 0 to %lld",
                                                   static_cast<long long>(count) - 1)),
                      {{Where::Kind::kFace, static_cast<std::int64_t>(f)}}});
      }
      triangles[f][k] = static_cast<int>(v);
    }
  }
  return triangles;
}

}  // namespace

std::vector<Vec3> toPositions(const Reals& rows) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  std::vector<Vec3> positions(static_cast<std::size_t>(rows.shape(0)));
  if (!positions.empty())
    std::memcpy(positions.data(), rows.data(), positions.size() * sizeof(Vec3));
  return positions;
}

std::vector<std::array<int, 3>> toTriangles(const py::array& rows, const char* name,
                                            py::ssize_t count) {
  if (py::isinstance<ShortIntegers>(rows)) {
    const auto narrow = py::reinterpret_borrow<ShortIntegers>(rows);
    return rowsOf(narrow.data(), rows.shape(0), name, count);
  }
  const auto wide = py::cast<Integers>(rows);
  return rowsOf(wide.data(), rows.shape(0), name, count);
}

}  // namespace hgp::python

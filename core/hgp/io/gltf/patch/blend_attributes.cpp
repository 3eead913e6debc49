#include "hgp/io/gltf/patch/blend_attributes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>

#include "hgp/base/check.h"
#include "hgp/base/ids.h"
#include "hgp/io/gltf/decode/accessor.h"

namespace hgp::io {
namespace {

bool startsWith(const std::string& name, const char* start) { return name.rfind(start, 0) == 0; }

/// The largest integer of a normalized or plain component type; 0 for float.
double largestOf(int componentType) {
  switch (componentType) {
    case 5120:
      return 127;
    case kGltfUnsignedByte:
      return 255;
    case 5122:
      return 32767;
    case kGltfUnsignedShort:
      return 65535;
    case kGltfUnsignedInt:
      return 4294967295.0;
    default:
      return 0;
  }
}

void store(double x, int componentType, bool isNormalized, std::uint8_t* to) {
  if (componentType == kGltfFloat) {
    const auto single = static_cast<float>(x);
    std::memcpy(to, &single, sizeof single);
    return;
  }
  const double largest = largestOf(componentType);
  const double bound = componentType == 5120 || componentType == 5122 ? -largest - 1 : 0;
  const double whole = std::round(std::clamp(isNormalized ? x * largest : x, bound, largest));
  const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(whole));
  std::memcpy(to, &bits, gltfComponentSize(componentType));  // little-endian: low bytes first
}

GltfBlended encoded(const std::vector<double>& numbers, std::size_t width, int componentType,
                    bool isNormalized) {
  const std::size_t size = gltfComponentSize(componentType);
  GltfBlended out{{}, (size * width + 3) / 4 * 4, componentType, isNormalized};
  const std::size_t count = numbers.size() / width;
  out.data.assign(count * out.stride, 0);
  for (std::size_t v = 0; v < count; ++v)
    for (std::size_t k = 0; k < width; ++k)
      store(numbers[v * width + k], componentType, isNormalized,
            out.data.data() + v * out.stride + k * size);
  return out;
}

void toUnitLength(double* x) {
  const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  for (std::size_t k = 0; k < 3 && length > 0; ++k) x[k] /= length;
}

std::size_t largestWeight(const Blend& blend) {
  return static_cast<std::size_t>(std::max_element(blend.weight.begin(), blend.weight.end()) -
                                  blend.weight.begin());
}

/// Integers of a normalized attribute of weights keep the sum that the real numbers have.
void roundWeights(double* weights, int componentType) {
  const double largest = largestOf(componentType);
  if (!(largest > 0)) return;
  double sum = 0, rounded = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    sum += weights[k];
    weights[k] = std::round(weights[k] * largest);
    rounded += weights[k];
  }
  weights[0] += std::round(sum * largest) - rounded;  // the largest one
  for (std::size_t k = 0; k < 4; ++k) weights[k] /= largest;
}

}  // namespace

GltfBlender::GltfBlender(const GltfStore& store, const GltfSurface& part,
                         const std::vector<Blend>& vertices)
    : store_(store), part_(part), vertices_(vertices) {}

std::size_t GltfBlender::poolOf(int stored) const {
  const auto after =
      std::upper_bound(part_.pools.begin(), part_.pools.end(), stored,
                       [](int vertex, const GltfPool& pool) { return vertex < pool.firstStored; });
  return static_cast<std::size_t>(after - part_.pools.begin()) - 1;
}

const GltfAccessor& GltfBlender::shapeOf(const GltfAttributeOf& attribute, std::size_t pool) const {
  const GltfPrimitive& primitive =
      store_.model.meshes[at(part_.mesh)].primitives[at(attribute.primitive[pool])];
  const GltfAttributes& names =
      attribute.target < 0 ? primitive.attributes : primitive.targets[at(attribute.target)];
  return store_.model.accessors[at(names.at(attribute.semantic))];
}

std::vector<GltfBlender::Numbers> GltfBlender::numbersOf(const GltfAttributeOf& attribute) const {
  std::vector<Numbers> out(part_.pools.size());
  for (std::size_t pool = 0; pool < out.size(); ++pool)
    if (attribute.primitive[pool] >= 0)
      out[pool] = realNumbers(shapeOf(attribute, pool),
                              packedAttribute(store_, part_.mesh, attribute.primitive[pool],
                                              attribute.semantic, attribute.target));
  return out;
}

void GltfBlender::interpolate(const GltfAttributeOf& attribute, std::size_t width,
                              Numbers& out) const {
  const bool isBase = attribute.target < 0;
  const bool isDirection =
      isBase && (attribute.semantic == "NORMAL" || attribute.semantic == "TANGENT");
  const bool isNearest = isBase && startsWith(attribute.semantic, "_");
  const std::vector<Numbers> numbers = numbersOf(attribute);
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const Blend& blend = vertices_[v];
    const std::size_t pool = poolOf(blend.of[0]);
    double* x = out.data() + v * width;
    if (numbers[pool].empty()) {
      if (isDirection || startsWith(attribute.semantic, "WEIGHTS_0"))
        x[isDirection ? width - 1 : 0] = 1;
      if (attribute.semantic == "TANGENT") x[0] = 1;
      continue;
    }
    const auto at = [&](std::size_t i, std::size_t k) {
      const auto local = static_cast<std::size_t>(blend.of[i] - part_.pools[pool].firstStored);
      return numbers[pool][local * width + k];
    };
    const std::size_t nearest = largestWeight(blend);
    const bool isFromNearest = isNearest && shapeOf(attribute, pool).componentType != kGltfFloat;
    for (std::size_t k = 0; k < width; ++k) {
      for (std::size_t i = 0; i < 3 && blend.of[i] >= 0; ++i) x[k] += blend.weight[i] * at(i, k);
      if (isFromNearest) x[k] = at(nearest, k);
    }
    if (!isDirection || blend.isOne()) continue;
    toUnitLength(x);
    if (width > 3) x[3] = at(nearest, 3);
  }
}

/// Per set the joints and the weights of all vertices of a pool.
GltfBlender::Skin GltfBlender::skinOf(int p) const {
  Skin sets;
  if (p < 0) return sets;
  const GltfPrimitive& primitive = store_.model.meshes[at(part_.mesh)].primitives[at(p)];
  for (int n = 0;; ++n) {
    std::array<Numbers, 2> both;
    for (const std::size_t isWeights : {0, 1}) {
      const std::string name = (isWeights == 1 ? "WEIGHTS_" : "JOINTS_") + std::to_string(n);
      const int accessor = primitive.attribute(name);
      if (accessor >= 0)
        both[isWeights] = realNumbers(store_.model.accessors[at(accessor)],
                                      packedAttribute(store_, part_.mesh, p, name));
    }
    if (both[0].empty() || both[1].empty()) return sets;
    sets.push_back(std::move(both));
  }
}

/// JOINTS_n or WEIGHTS_n. Vertices that are no means keep theirs.
bool GltfBlender::takeSkin(const GltfAttributeOf& attribute, Numbers& out) const {
  const bool areJoints = startsWith(attribute.semantic, "JOINTS_");
  if (attribute.target >= 0 || (!areJoints && !startsWith(attribute.semantic, "WEIGHTS_")))
    return false;
  const std::size_t set = std::strtoul(
      attribute.semantic.substr(attribute.semantic.find('_') + 1).c_str(), nullptr, 10);
  std::vector<Skin> skins;
  for (const int p : attribute.primitive) skins.push_back(skinOf(p));
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const Blend& blend = vertices_[v];
    const std::size_t pool = poolOf(blend.of[0]);
    double* x = out.data() + 4 * v;
    if (set >= skins[pool].size()) {
      if (!areJoints && set == 0) x[0] = 1;
    } else if (blend.isOne()) {
      const auto first = 4 * static_cast<std::size_t>(blend.of[0] - part_.pools[pool].firstStored);
      for (std::size_t k = 0; k < 4; ++k) x[k] = skins[pool][set][areJoints ? 0 : 1][first + k];
    } else {
      takeBones(blend, skins[pool], part_.pools[pool].firstStored, set, areJoints, x);
      if (!areJoints) roundWeights(x, shapeOf(attribute, pool).componentType);
    }
  }
  return true;
}

/// The joints or weights number 4·set … 4·set + 3 of a mean, the largest weight first.
void GltfBlender::takeBones(const Blend& blend, const Skin& skin, int firstStored, std::size_t set,
                            bool areJoints, double* x) {
  std::map<double, double> weightOf;
  double sum = 0, kept = 0;
  for (std::size_t i = 0; i < 3 && blend.of[i] >= 0; ++i) {
    const auto first = 4 * static_cast<std::size_t>(blend.of[i] - firstStored);
    for (const auto& [joints, weights] : skin)
      for (std::size_t k = first; k < first + 4; ++k) {
        weightOf[joints[k]] += blend.weight[i] * weights[k];
        sum += blend.weight[i] * weights[k];
      }
  }
  std::vector<std::pair<double, double>> order;  // −weight and joint
  for (const auto& [joint, weight] : weightOf)
    if (weight > 0) order.emplace_back(-weight, joint);
  std::sort(order.begin(), order.end());
  order.resize(std::min(order.size(), 4 * skin.size()));
  for (const auto& [negative, joint] : order) kept -= negative;
  for (std::size_t k = 0; k < 4 && 4 * set + k < order.size(); ++k) {
    const auto& [negative, joint] = order[4 * set + k];
    x[k] = areJoints ? joint : -negative * sum / kept;
  }
}

Result<GltfBlended> GltfBlender::blend(const GltfAttributeOf& attribute) const {
  const GltfAccessor* first = nullptr;
  bool isOneType = true;
  for (std::size_t pool = 0; pool < part_.pools.size(); ++pool) {
    if (attribute.primitive[pool] < 0) continue;
    const GltfAccessor& shape = shapeOf(attribute, pool);
    if (first == nullptr) first = &shape;
    if (shape.components() != first->components())
      return Failure{ErrorCode::kUnsupported,
                     "write",
                     attribute.semantic + " has different types in the primitives of a mesh",
                     {}};
    isOneType = isOneType && shape.componentType == first->componentType &&
                shape.isNormalized == first->isNormalized;
  }
  HGP_CHECK(first != nullptr, "an attribute that no primitive has");
  const auto width = static_cast<std::size_t>(first->components());
  Numbers numbers(vertices_.size() * width, 0.0);
  int type = first->componentType;
  bool isNormalized = first->isNormalized;
  if (startsWith(attribute.semantic, "JOINTS_")) {
    if (!isOneType) type = kGltfUnsignedShort;
  } else if (!isOneType || attribute.semantic == "POSITION" ||
             (!isNormalized && !startsWith(attribute.semantic, "_"))) {
    type = kGltfFloat;
    isNormalized = false;
  }
  if (width != 4 || !takeSkin(attribute, numbers)) interpolate(attribute, width, numbers);
  return encoded(numbers, width, type, isNormalized);
}

GltfBlended GltfBlender::positions(const std::vector<Vec3>& positions) {
  std::vector<double> numbers;
  for (const Vec3& p : positions) numbers.insert(numbers.end(), p.begin(), p.end());
  return encoded(numbers, 3, kGltfFloat, false);
}

}  // namespace hgp::io

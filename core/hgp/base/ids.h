// Typed indices and containers that accept only their own index.  Role: a face cannot index a
// vertex array by mistake.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace hgp {

/// An index into one kind of element. -1 means "none".
template <class Tag>
struct Id {
  int i = -1;
  constexpr Id() = default;
  constexpr explicit Id(int index) : i(index) {}
  constexpr bool isValid() const { return i >= 0; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexTag>;
using FaceId = Id<struct FaceTag>;
/// Halfedge 3f + k runs from corner k to corner k + 1 of face f.
using HalfedgeId = Id<struct HalfedgeTag>;
using EdgeId = Id<struct EdgeTag>;
/// A boundary component of the surface.
using LoopId = Id<struct LoopTag>;
/// A vertex of the cut mesh S_c: one copy of a vertex of S.
using CutVertexId = Id<struct CutVertexTag>;

/// Converts a non-negative number to an index of the standard containers.
constexpr std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// A vector indexed by one kind of id only.
template <class IdType, class T>
class Per {
 public:
  Per() = default;
  explicit Per(std::size_t count, const T& value = T()) : data_(count, value) {}
  explicit Per(std::vector<T> data) : data_(std::move(data)) {}

  decltype(auto) operator[](IdType id) { return data_[static_cast<std::size_t>(id.i)]; }
  decltype(auto) operator[](IdType id) const { return data_[static_cast<std::size_t>(id.i)]; }
  int size() const { return static_cast<int>(data_.size()); }
  std::vector<T>& raw() { return data_; }
  const std::vector<T>& raw() const { return data_; }
  auto begin() const { return data_.begin(); }
  auto end() const { return data_.end(); }

 private:
  std::vector<T> data_;
};

template <class T>
using PerVertex = Per<VertexId, T>;
template <class T>
using PerFace = Per<FaceId, T>;
template <class T>
using PerHalfedge = Per<HalfedgeId, T>;
template <class T>
using PerEdge = Per<EdgeId, T>;
template <class T>
using PerLoop = Per<LoopId, T>;
template <class T>
using PerCutVertex = Per<CutVertexId, T>;

/// for (VertexId v : idRange<VertexId>(n)) …
template <class IdType>
class IdRange {
 public:
  explicit IdRange(int count) : count_(count) {}
  struct Iterator {
    int i;
    IdType operator*() const { return IdType(i); }
    Iterator& operator++() {
      ++i;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return i != other.i; }
  };
  Iterator begin() const { return {0}; }
  Iterator end() const { return {count_}; }

 private:
  int count_;
};

}  // namespace hgp

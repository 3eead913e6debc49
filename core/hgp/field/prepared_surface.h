// A surface with everything that does not depend on cones, computed once.  Role: kept by a session, so that a second
// run with other cones repeats nothing that depends only on the surface.
#pragma once

#include <memory>
#include <optional>

#include "hgp/field/prescribed_field.h"
#include "hgp/mesh/angle_shortage_memo.h"

namespace hgp {

/// Topology, geometry, nested dissection and filled surface are computed at construction, Laplacian and handle basis
/// when they are first needed; the last prescribed field is kept. Keeps a reference to the mesh.
/// @pre mesh has one component
class PreparedSurface {
 public:
  /// On larger surfaces memory counts more than time: what is prepared is freed when it has been used.
  static constexpr int kKeptFaces = 200'000;

  explicit PreparedSurface(const TriMesh& mesh, Metric metric = Metric::kOwn);
  PreparedSurface(const PreparedSurface&) = delete;  // its searches refer to it
  PreparedSurface& operator=(const PreparedSurface&) = delete;

  const TriMesh& mesh() const { return *mesh_; }
  const Topology& topology() const { return context_->topology; }
  /// Without Laplacian and handles until requireConnection().
  const FieldContext& context() const { return *context_; }
  std::shared_ptr<const FieldContext> share() const { return context_; }

  /// The same surface in the evened metric, prepared on the first call; *this if it already has that metric.
  PreparedSurface& evened();
  bool isEvened() const { return context_->own.has_value(); }

  /// Laplacian and handle basis. Fails with kUnsupported where the Laplacian cannot be factored.
  Status requireConnection();
  bool hasConnection() const { return hasConnection_; }
  /// Frees their memory, which is most of all; they are computed again when needed.
  void releaseConnection();

  /// Kept answers about the mesh alone.
  AngleShortageMemo& shortages() { return shortages_; }

  /// prescribedField(…) of this surface. The last result is kept and returned without computation when `spec` is its
  /// completed specification, its cones in any order; otherwise the connection is needed.
  Result<PrescribedField> field(const HolonomySpec& spec);

 private:
  const TriMesh* mesh_;
  std::shared_ptr<FieldContext> context_;
  bool hasConnection_ = false;
  AngleShortageMemo shortages_;
  std::optional<PrescribedField> last_;
  std::unique_ptr<PreparedSurface> evened_;
};

}  // namespace hgp

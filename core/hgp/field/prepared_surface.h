// What every solve on one surface starts from, found once.  Role: kept by a session, so that a second
// run with other cones repeats nothing that depends on the surface alone.
#pragma once

#include <memory>
#include <optional>

#include "hgp/field/prescribed_field.h"

namespace hgp {

/// Topology, geometry, dissection and filled surface at once; Laplacian and handle basis when they
/// are first needed; the last prescribed field. Keeps a reference to the mesh.
/// @pre mesh has one component
class PreparedSurface {
 public:
  explicit PreparedSurface(const TriMesh& mesh, Metric metric = Metric::kOwn);

  const TriMesh& mesh() const { return *mesh_; }
  const Topology& topology() const { return context_->topology; }
  /// Without Laplacian and handles until requireConnection().
  const FieldContext& context() const { return *context_; }
  std::shared_ptr<const FieldContext> share() const { return context_; }

  /// The same surface in the evened metric, prepared when first asked for; itself where it is that.
  PreparedSurface& evened();
  bool isEvened() const { return context_->own.has_value(); }

  /// Laplacian and handle basis. Fails with kUnsupported where the Laplacian cannot be factored.
  Status requireConnection();
  bool hasConnection() const { return hasConnection_; }
  /// Gives back their memory, which is most of it; they are found again when needed.
  void releaseConnection();

  /// prescribedField(…), the last one remembered: asked again by its own completed specification it
  /// is not computed again. Needs the connection only where it computes.
  Result<PrescribedField> field(const HolonomySpec& spec);

 private:
  const TriMesh* mesh_;
  std::shared_ptr<FieldContext> context_;
  bool hasConnection_ = false;
  std::optional<PrescribedField> last_;
  std::unique_ptr<PreparedSurface> evened_;
};

}  // namespace hgp

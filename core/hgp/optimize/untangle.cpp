#include "hgp/optimize/untangle.h"

#include "hgp/optimize/program_terms.h"
#include "hgp/optimize/untangler.h"

namespace hgp {
namespace {

constexpr Complex kI(0.0, 1.0);

/// Complex unknowns: i times the derivative by the real part is that by the imaginary one.
UntangleFace faceOf(const FaceRows& rows, const FreeUnknowns& free) {
  UntangleFace face;
  for (const FaceRows::Term& term : rows.terms)
    face.terms.push_back({free.number(term.unknown),
                          {term.similar, kI * term.similar},
                          {term.anti, kI * term.anti}});
  face.heldSimilar = rows.heldSimilar;
  face.heldAnti = rows.heldAnti;
  return face;
}

}  // namespace

UntangleResult untangle(const SeamlessSystem& system, const Eigen::VectorXcd& x,
                        const UntangleOptions& options) {
  const Frames none;
  ProgramOptions program;
  program.u = options.u;
  const ProgramInput in{system, none, program};
  HeldUnknowns held = heldUnknowns(in);
  held.value = x;
  const FreeUnknowns free(held.isHeld);
  UntangleFaces faces(system.mesh, options);
  FaceRows rows;
  for (const FaceId f : system.mesh.faces()) {
    faceRows(in, held, f, rows);
    faces.add(f, faceOf(rows, free), system.seams.frameAngle[f]);
  }
  UntangleResult result = untangleFaces(faces.take(), free.count(), free.gather(x), options);
  Eigen::VectorXcd all = x;
  free.scatter(result.x, all);
  result.x = std::move(all);
  return result;
}

}  // namespace hgp

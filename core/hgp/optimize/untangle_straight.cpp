#include "hgp/optimize/untangle_straight.h"

#include <algorithm>
#include <utility>

namespace hgp {
namespace {

/// Real unknown i is part variable[i] % 2 of pair variable[i] / 2.
class PairedFaces {
 public:
  PairedFaces(const StraightSystem& straight, const Eigen::VectorXd& x, std::vector<char> isGiven)
      : s_(straight.system), unknowns_(straight.unknowns), x_(x), isGiven_(std::move(isGiven)) {}

  UntangleFace rows(FaceId f) const {
    UntangleFace face;
    const LinearParts parts = linearParts(s_.geometry, f);
    for (int k = 0; k < 3; ++k) {
      const int copy = s_.cut.copy[TriMesh::halfedge(f, k)].i;
      for (const int part : {0, 1})
        for (RealUnknowns::Rows::InnerIterator it(unknowns_.rows, 2 * copy + part); it; ++it) {
          const Complex factor = part == 0 ? Complex(it.value()) : Complex(0.0, it.value());
          add(static_cast<int>(it.col()), parts.similarity[at(k)] * factor,
              parts.antisimilarity[at(k)] * factor, face);
        }
    }
    return face;
  }

 private:
  void add(int unknown, const Complex& similar, const Complex& anti, UntangleFace& face) const {
    if (isGiven_[at(unknown)] != 0) {
      face.heldSimilar += similar * x_[unknown];
      face.heldAnti += anti * x_[unknown];
      return;
    }
    const int variable = unknowns_.variable[at(unknown)], pair = variable / 2;
    const auto isOfPair = [pair](const UntangleFace::Term& term) { return term.unknown == pair; };
    const auto found = std::find_if(face.terms.begin(), face.terms.end(), isOfPair);
    UntangleFace::Term& term = found != face.terms.end()
                                   ? *found
                                   : face.terms.emplace_back(UntangleFace::Term{pair, {}, {}});
    term.similar[at(variable % 2)] += similar;
    term.anti[at(variable % 2)] += anti;
  }

  const SeamlessSystem& s_;
  const RealUnknowns& unknowns_;
  const Eigen::VectorXd& x_;
  const std::vector<char> isGiven_;
};

}  // namespace

StraightUntangling untangleStraight(const StraightSystem& straight, const Eigen::VectorXd& x,
                                    const std::vector<std::pair<int, double>>& given,
                                    const PerFace<double>& frameAngle,
                                    const UntangleOptions& options) {
  const RealUnknowns& unknowns = straight.unknowns;
  const TriMesh& mesh = straight.system.mesh;
  StraightUntangling out;
  out.x = x;
  std::vector<char> isGiven(at(unknowns.count), 0);
  for (const auto& [unknown, value] : given) {
    isGiven[at(unknown)] = 1;
    out.x[unknown] = value;
  }
  const PairedFaces paired(straight, out.x, std::move(isGiven));
  UntangleFaces faces(mesh, options);
  for (const FaceId f : mesh.faces()) faces.add(f, paired.rows(f), frameAngle[f]);
  Eigen::VectorXcd pairs = Eigen::VectorXcd::Zero(straight.system.unknowns.count);
  setParts(out.x, unknowns.variable, pairs);
  const UntangleResult result =
      untangleFaces(faces.take(), straight.system.unknowns.count, pairs, options);
  out.x = partsOf(result.x, unknowns.variable);
  for (const auto& [unknown, value] : given) out.x[unknown] = value;
  out.z = placesOf(unknowns, out.x);
  out.iterations = result.iterations;
  out.flipped = result.flipped;
  out.isCancelled = result.isCancelled;
  return out;
}

}  // namespace hgp

// Prints random cone programs with our solutions as JSON, one per line, for against_scs.test.mjs.
#include <cstdio>

#include "core/socp/random_program.h"

namespace {

void printVector(const char* name, const Eigen::VectorXd& values) {
  std::printf("\"%s\":[", name);
  for (Eigen::Index i = 0; i < values.size(); ++i) std::printf("%s%.17g", i ? "," : "", values[i]);
  std::printf("]");
}

void printRows(const char* name, const Eigen::MatrixXd& matrix) {
  std::printf("\"%s\":[", name);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    std::printf("%s[", i ? "," : "");
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      std::printf("%s%.17g", j ? "," : "", matrix(i, j));
    std::printf("]");
  }
  std::printf("]");
}

void print(unsigned seed, const hgp::test::RandomProgram& p) {
  // Tighter than the method needs: minimisers are compared, not objectives.
  hgp::socp::SolveOptions options;
  options.primal = 1e-10;
  options.dual = 1e-9;
  options.gap = 1e-12;
  const hgp::test::Solved solved = hgp::test::solveProgram(p, options);
  const auto count = static_cast<Eigen::Index>(p.cliques.size());
  Eigen::MatrixXd F(3 * count, 2 * p.H.rows());
  Eigen::VectorXd h(3 * count);
  for (Eigen::Index b = 0; b < count; ++b) {
    F.middleRows<3>(3 * b) = p.fullF(static_cast<std::size_t>(b));
    h.segment<3>(3 * b) = p.h[static_cast<std::size_t>(b)];
  }
  std::printf("{\"seed\":%u,\"status\":\"%s\",", seed,
              hgp::socp::statusName(solved.solution.status));
  printRows("H", p.realH());
  std::printf(",");
  printVector("c", p.realC());
  std::printf(",");
  printRows("F", F);
  std::printf(",");
  printVector("h", h);
  std::printf(",");
  printVector("x", solved.x);
  std::printf("}\n");
}

}  // namespace

int main() {
  for (unsigned seed = 101; seed < 131; ++seed) print(seed, hgp::test::randomProgram(seed));
  // And some that contradict themselves: the first constraint once more, mirrored and apart.
  for (unsigned seed = 201; seed < 206; ++seed) {
    hgp::test::RandomProgram p = hgp::test::randomProgram(seed);
    p.cliques.push_back(p.cliques[0]);
    p.F.emplace_back(p.F[0]);
    p.F.back().row(0) *= -1.0;
    p.h.emplace_back(1.0 - p.h[0][0], 0.0, 0.0);
    print(seed, p);
  }
  return 0;
}

#include "hgp/parametrize/strategy/found.h"

namespace hgp {
namespace {

/// Orders maps, to keep the best one: −1 when certified, then by the number of wrong triangles, vertices and loops.
long long distanceToCertified(const Attempt& attempt) {
  if (attempt.certificate.isCertified) return -1;
  return attempt.certificate.isMeasured ? attempt.wrongCount : 1LL << 40;
}

/// A harmonic map goes before one of less mean μ unless its own is larger by more than this factor.
constexpr double kMuchLarger = 1.05;

bool isMuchLarger(const Attempt& attempt, const Attempt& other) {
  return meanMuOf(attempt) > kMuchLarger * meanMuOf(other);
}

}  // namespace

double meanMuOf(const Attempt& attempt) { return attempt.certificate.distortion.meanMu; }

void Found::add(const std::shared_ptr<const Attempt>& attempt, bool isHarmonic) {
  const bool isCertified = attempt->certificate.isCertified;
  if (isHarmonic && isCertified && (!harmonic || meanMuOf(*attempt) < meanMuOf(*harmonic)))
    harmonic = attempt;
  if (best && best->certificate.isCertified) {
    if (isCertified && isMuchLarger(*best, *attempt))
      best = harmonic && !isMuchLarger(*harmonic, *attempt) ? harmonic : attempt;
  } else if (!best || distanceToCertified(*attempt) < distanceToCertified(*best)) {
    best = attempt;
  }
}

}  // namespace hgp

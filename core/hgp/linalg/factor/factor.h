// The factorizations of this module in one header.  Role: what other modules include.
#pragma once

#include "hgp/linalg/factor/multifrontal.h"
#include "hgp/linalg/factor/partial_cholesky.h"
#include "hgp/linalg/factor/real_partial.h"
#include "hgp/linalg/factor/schur_extension.h"
#include "hgp/linalg/factor/schur_lu.h"
#include "hgp/linalg/factor/work.h"

namespace hgp::linalg {}  // namespace hgp::linalg

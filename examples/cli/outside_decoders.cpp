#include "outside_decoders.h"

namespace hgp::cli {

std::shared_ptr<const io::GltfDecoders> outsideDecoders() { return {}; }

}  // namespace hgp::cli

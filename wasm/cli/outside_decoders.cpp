#include "../../examples/cli/outside_decoders.h"

#include "../decoders.h"

namespace hgp::cli {

std::shared_ptr<const io::GltfDecoders> outsideDecoders() {
  return js::toDecoders(emscripten::val::global("hgpDecoders"));
}

}  // namespace hgp::cli

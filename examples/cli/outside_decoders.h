// Decoders of compressed glTF from outside this build.  Role: WebAssembly gets them from JavaScript.
#pragma once

#include <memory>

#include "hgp/io/document.h"

namespace hgp::cli {

/// Empty: those of this build. In WebAssembly those that the launcher has loaded (wasm/cli/outside_decoders.cpp).
std::shared_ptr<const io::GltfDecoders> outsideDecoders();

}  // namespace hgp::cli

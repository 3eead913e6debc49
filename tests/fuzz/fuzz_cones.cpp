// Any text as a cone or field file, under every name that readers go by; cones JSON comes back.
#include "fuzz_support.h"
#include "hgp/io/cone_files.h"

using namespace hgp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto json = prescription::readConesJson(text);
  if (json) {
    const auto again = prescription::readConesJson(prescription::writeConesJson(*json));
    fuzz::require(
        again.hasValue() && again->q == json->q && again->cones.size() == json->cones.size(),
        "cones that were read can be written and read");
  }
  for (const char* name : {"a.json", "a.cones", "a.sing", "a_Th_hat", "a.curvatures", "a.rawfield",
                           "a.rosy", "a.ffield", "a.obj", "a"}) {
    const auto prescription = io::readPrescription(name, text, 4);
    if (!prescription) {
      fuzz::require(prescription.error().code != ErrorCode::kInternal,
                    "bad bytes are never our bug");
    }
  }
  return 0;
}

// Prescriptions from files of every known format.  Role: what programs read before they call a session. Any
// thread may call them.
#pragma once

#include <string_view>

#include "hgp/prescription/prescription.h"

namespace hgp::api {

/// prescription::readPrescription and prescription::readFeatures at the API boundary.
Result<prescription::Prescription> readPrescription(std::string_view name, std::string_view text,
                                                    int q);
Result<prescription::PrescribedFeatures> readFeatures(std::string_view name, std::string_view text);

/// `cones` with the field of `field`, which determines what the cones leave open. Fails with kUsage if q differs.
Result<prescription::Prescription> withField(prescription::Prescription cones,
                                             prescription::Prescription field);

}  // namespace hgp::api

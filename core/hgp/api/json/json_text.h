// The JSON documents of docs/schema.  Role: the same documents for command line, package,
// page and benchmarks.
#pragma once

#include "hgp/api/request/request.h"
#include "hgp/api/stored/outside.h"
#include "hgp/api/stored/stored_map.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/system/harmonic_residual.h"

namespace hgp::api {

std::string inspectText(const Model& model);

/// The check of one component: either its budget or the reason why the prescription is refused.
struct ComponentCheck {
  std::optional<BudgetReport> budget;
  std::optional<Failure> refusal;
  bool isAutomatic = false;
};
std::string checkText(const Model& model, const Request& request,
                      const std::vector<ComponentCheck>& checks);
/// The document of a check that failed before it reached any component.
std::string checkText(const Failure& refusal);

/// @param uvSet  the set of the file that was verified; −1: a map not yet written
std::string certificateText(const Model& model, const std::vector<Certificate>& certificates,
                            const OutsideFacts& outside, int uvSet = -1, const Notes& notes = {});

/// What --refine split, in ids of the surface before the refinement.
struct RefinedFacts {
  int verticesBefore = 0, trianglesBefore = 0;  ///< of the surface before
  int edges = 0;
  struct Place {
    std::string reason;
    int component = 0;
    std::vector<Where> edges;
  };
  std::vector<Place> places;
  std::size_t roundsBefore = 0;  ///< programs solved on the surface before
};

/// The same as a document that is part of another one; it refers to model and certificates.
struct SplicedDocument;
SplicedDocument certificateDocument(const Model& model,
                                    const std::vector<Certificate>& certificates,
                                    const OutsideFacts& outside, int uvSet, const Notes& notes);
/// The hgp-certificate in a report.
std::string certificateOf(const std::string& report);

/// The results of a run besides the map.
struct RunRecord {
  SolveOptions options;
  bool isAutomatic = false;
  std::vector<Parametrization> components;  ///< their maps may be empty
  std::vector<HarmonicFacts> harmonic;      ///< per component, of the stored map
  Notes notes;
  double seconds = 0;
  std::optional<RefinedFacts> refined;  ///< of the run that gave the map
};
/// The text of hgp-report, which has the certificate. @param certificates  per component, of the stored map
/// @param cones  the JSON text that becomes a member of the report
std::string reportText(const Model& model, const RunRecord& run,
                       const std::vector<Certificate>& certificates, const OutsideFacts& outside,
                       const std::string& cones);

}  // namespace hgp::api

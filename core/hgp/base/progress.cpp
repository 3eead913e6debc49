#include "hgp/base/progress.h"

namespace hgp {

const char* stageName(Stage stage) {
  switch (stage) {
    case Stage::kPrepare:
      return "prepare";
    case Stage::kCones:
      return "cones";
    case Stage::kConnection:
      return "connection";
    case Stage::kField:
      return "field";
    case Stage::kCut:
      return "cut";
    case Stage::kAssemble:
      return "assemble";
    case Stage::kSolve:
      return "solve";
    case Stage::kImprove:
      return "improve";
    case Stage::kAlign:
      return "align";
  }
  return "";
}

}  // namespace hgp

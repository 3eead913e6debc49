#include "hgp/base/result.h"

#include "hgp/base/phrase.h"

namespace hgp {

const char* errorName(ErrorCode code) {
  switch (code) {
    case ErrorCode::kUsage:
      return "usage";
    case ErrorCode::kMalformed:
      return "malformed";
    case ErrorCode::kUnsupported:
      return "unsupported";
    case ErrorCode::kPrescription:
      return "prescription";
    case ErrorCode::kNoMap:
      return "no-map";
    case ErrorCode::kWriteFailed:
      return "write-failed";
    case ErrorCode::kLimit:
      return "limit";
    case ErrorCode::kInternal:
      return "internal";
    case ErrorCode::kCancelled:
      return "cancelled";
  }
  return "internal";
}

int exitCode(ErrorCode code) {
  switch (code) {
    case ErrorCode::kUsage:
      return 2;
    case ErrorCode::kMalformed:
      return 3;
    case ErrorCode::kUnsupported:
      return 4;
    case ErrorCode::kPrescription:
      return 5;
    case ErrorCode::kNoMap:
      return 6;
    case ErrorCode::kWriteFailed:
      return 7;
    case ErrorCode::kLimit:
      return 8;
    case ErrorCode::kInternal:
      return 70;
    case ErrorCode::kCancelled:
      return 130;
  }
  return 70;
}

std::string told(const Failure& failure) {
  if (failure.advice.empty()) return failure.message;
  std::string out = failure.message;
  if (!out.empty() && out.back() == '.') out.pop_back();
  for (const Note& note : failure.advice) out += ". " + phrase(note);
  return out + ".";
}

}  // namespace hgp

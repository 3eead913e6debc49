#include "hgp/base/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>

#include "hgp/base/check.h"

namespace hgp {
namespace {

Result<std::string> half(int n) {
  if (n % 2 != 0) return Failure{ErrorCode::kUsage, "half", formatText("%d is odd", n), {}};
  return std::to_string(n / 2);
}

TEST(Result, IsEitherAValueOrAFailure) {
  const Result<std::string> good = half(6), bad = half(7);
  ASSERT_TRUE(good);
  EXPECT_EQ(*good, "3");
  EXPECT_EQ(good->size(), 1u);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().message, "7 is odd");
  EXPECT_EQ(bad.error().code, ErrorCode::kUsage);
}

TEST(Result, MovesOutWhatCannotBeCopied) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(4));
  const std::unique_ptr<int> value = *std::move(result);
  EXPECT_EQ(*value, 4);
}

TEST(Result, StatusIsSuccessOrAFailure) {
  const Status good = Done{}, bad = Failure{};
  EXPECT_TRUE(good);
  EXPECT_FALSE(bad);
}

TEST(Result, ErrorsHaveTheirOwnNamesAndExitCodes) {
  std::set<std::string> names;
  std::set<int> codes;
  for (ErrorCode code : {ErrorCode::kUsage, ErrorCode::kMalformed, ErrorCode::kUnsupported,
                         ErrorCode::kPrescription, ErrorCode::kNoMap, ErrorCode::kWriteFailed,
                         ErrorCode::kLimit, ErrorCode::kInternal, ErrorCode::kCancelled}) {
    EXPECT_TRUE(names.insert(errorName(code)).second);
    EXPECT_TRUE(codes.insert(exitCode(code)).second);
    EXPECT_GT(exitCode(code), 1);
  }
  EXPECT_EQ(exitCode(ErrorCode::kCancelled), 130);
}

TEST(Check, ThrowsWithTheRuleAndTheNumber) {
  const int n = 3;
  EXPECT_NO_THROW(HGP_CHECK(n == 3, "n = %d", n));
  try {
    HGP_CHECK(n == 4, "n must be 4, is %d", n);
    FAIL();
  } catch (const InternalError& error) {
    EXPECT_NE(std::string(error.what()).find("n must be 4, is 3 (n == 4)"), std::string::npos);
    EXPECT_EQ(std::string(error.what()).find('/'), std::string::npos) << "no path of the machine";
  }
}

TEST(FormatText, HasNoLimit) {
  const std::string longText(5000, 'x');
  EXPECT_EQ(formatText("%s|%d", longText.c_str(), 7), longText + "|7");
  EXPECT_EQ(formatText("%s", ""), "");
}

}  // namespace
}  // namespace hgp

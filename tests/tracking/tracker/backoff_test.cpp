// Less frequent attempts while they are in vain.
#include "tracking/tracker/backoff.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace abstand::tracking {
namespace backoff_test {

constexpr double kPeriod = 0.25;  // s, exact in binary

/// s of all attempts until `end`, of which none succeeds.
std::vector<double> attemptsUntil(double end, Backoff backoff) {
  std::vector<double> attempts;
  for (double t = 0.0; t < end; t += kPeriod) {
    if (!backoff.isDue(t)) continue;
    backoff.note(t, false);
    attempts.push_back(t);
  }
  return attempts;
}

TEST(Backoff, WaitsAfterFreeAttempts) {
  EXPECT_EQ(attemptsUntil(3.0, Backoff({3, 1.0, 1.0, 1.0})), (std::vector<double>{0.0, 0.25, 0.5, 1.5, 2.5}));
}

TEST(Backoff, WaitsLongerUpToTheLongest) {
  EXPECT_EQ(attemptsUntil(9.0, Backoff({0, 0.5, 2.0, 2.0})), (std::vector<double>{0.0, 1.0, 3.0, 5.0, 7.0}));
}

TEST(Backoff, SuccessStartsAgain) {
  Backoff backoff({0, 0.5, 2.0, 4.0});
  backoff.note(0.0, false);
  backoff.note(1.0, false);
  EXPECT_FALSE(backoff.isDue(2.0));
  backoff.note(3.0, true);
  EXPECT_FALSE(backoff.isDue(3.25)) << "no free attempts";
  EXPECT_TRUE(backoff.isDue(3.5));
}

TEST(Backoff, ResetStartsAgain) {
  Backoff backoff({1, 0.5, 2.0, 4.0});
  backoff.note(0.0, false);
  EXPECT_FALSE(backoff.isDue(0.25));
  backoff.reset();
  EXPECT_TRUE(backoff.isDue(0.25));
}

}  // namespace backoff_test
}  // namespace abstand::tracking

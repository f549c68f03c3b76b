// Which way a person who lies faces, from the costs of poses and of searches; and which ratios decide.
#include "tracking/tracker/facing.hpp"

#include <gtest/gtest.h>

namespace abstand::tracking {
namespace facing_test {

Facing lying(double turning, double searching) {
  Facing facing;
  facing.decideLying(turning, searching);
  return facing;
}

TEST(Facing, IsDecidedByRatiosFarFromOne) {
  const auto decided = [](double ratio, bool lies) { return Facing{.lies = lies, .ratio = ratio}.decided(); };
  for (const double ratio : {0.79, 1.51}) EXPECT_TRUE(decided(ratio, false)) << ratio;
  for (const double ratio : {0.81, 1.0, 1.49, kNaN}) EXPECT_FALSE(decided(ratio, false)) << ratio;
  for (const double ratio : {0.86, 1.16}) EXPECT_TRUE(decided(ratio, true)) << ratio;
  for (const double ratio : {0.88, 1.0, 1.14, kNaN}) EXPECT_FALSE(decided(ratio, true)) << ratio;
  EXPECT_TRUE(Facing{.given = true}.decided());
}

TEST(Facing, AwayOfPeopleWhoKneelNeedsMore) {
  const auto decided = [](double ratio) { return Facing{.kneels = true, .ratio = ratio}.decided(); };
  for (const double ratio : {0.66, 1.51}) EXPECT_TRUE(decided(ratio)) << ratio;
  for (const double ratio : {0.68, 0.79, 1.49}) EXPECT_FALSE(decided(ratio)) << ratio;
}

TEST(Facing, OfTrunksWithoutHeadAndFeetNeedsMore) {
  const auto decided = [](double ratio) { return Facing{.shows_little = true, .ratio = ratio}.decided(); };
  for (const double ratio : {0.24, 4.1}) EXPECT_TRUE(decided(ratio)) << ratio;
  for (const double ratio : {0.26, 1.0, 2.5, 3.9}) EXPECT_FALSE(decided(ratio)) << ratio;
}

TEST(Facing, IsContradictedByTheRatioOfTheOtherDirection) {
  EXPECT_TRUE((Facing{.away = true, .ratio = 1.6}.contradicts()));
  EXPECT_TRUE((Facing{.away = false, .ratio = 0.7}.contradicts()));
  EXPECT_FALSE((Facing{.away = true, .ratio = 0.7}.contradicts()));
  EXPECT_FALSE((Facing{.away = false, .ratio = 1.6}.contradicts()));
  for (const bool away : {true, false}) EXPECT_FALSE((Facing{.away = away, .ratio = kNaN}.contradicts()));
}

TEST(Facing, OfPeopleWhoLieIsThatOfTheLessCertain) {
  EXPECT_EQ(lying(2.0, 1.3).ratio, 1.3);
  EXPECT_EQ(lying(1.3, 2.0).ratio, 1.3);
  EXPECT_EQ(lying(0.9, 0.5).ratio, 0.9);
  EXPECT_TRUE(lying(0.5, 0.7).decided());
  EXPECT_TRUE(lying(0.5, 0.7).away);
  EXPECT_TRUE(lying(0.99, 0.99).away);
}

TEST(Facing, OfPeopleWhoLieIsUndecidedIfSearchesDisagree) {
  for (const double searching : {0.9, 1.0, kNaN}) {
    EXPECT_EQ(lying(2.0, searching).ratio, 1.0) << searching;
    EXPECT_FALSE(lying(2.0, searching).away) << searching;
  }
  EXPECT_TRUE(lying(1.6, 0.46).away);
}

}  // namespace facing_test
}  // namespace abstand::tracking

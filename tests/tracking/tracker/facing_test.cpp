// Which way a person faces, from the costs of poses and of searches.
#include <gtest/gtest.h>

#include "tracking/tracker/tracked_person.hpp"

namespace abstand::tracking {
namespace facing_test {

Facing decided(double turning, double searching, bool lies = false) {
  Facing facing;
  facing.lies = lies;
  facing.decide(turning, searching);
  return facing;
}

TEST(Facing, IsThatOfPosesIfSearchesAgree) {
  EXPECT_TRUE(decided(2.0, 1.2).decided());
  EXPECT_FALSE(decided(2.0, 1.2).away);
  EXPECT_EQ(decided(2.0, 1.2).ratio, 2.0);
  EXPECT_TRUE(decided(0.8, 0.9).decided());
  EXPECT_TRUE(decided(0.8, 0.9).away);
  // Neither clearly the back nor clearly the front.
  EXPECT_FALSE(decided(1.1, 3.0).decided());
  EXPECT_FALSE(decided(0.97, 0.5).decided());
  EXPECT_FALSE(decided(0.97, 0.5).away);
}

TEST(Facing, IsUndecidedIfSearchesDisagree) {
  for (const double searching : {0.8, 1.0, kNaN})
    EXPECT_FALSE(decided(2.0, searching).decided()) << searching;
  EXPECT_FALSE(decided(0.5, 1.2).decided());
}

TEST(Facing, LikelierSideIsAssumed) {
  EXPECT_TRUE(decided(1.6, 0.46).away);
  EXPECT_FALSE(decided(2.3, 0.54).away);
  // Of a person who does not lie the front, unless the back is clearly the likelier side.
  EXPECT_FALSE(decided(1.02, 0.97).away);
}

TEST(Facing, OfPeopleWhoLieIsThatOfTheLessCertain) {
  EXPECT_EQ(decided(2.0, 1.3, true).ratio, 1.3);
  EXPECT_EQ(decided(0.9, 0.5, true).ratio, 0.9);
  EXPECT_FALSE(decided(2.0, 0.9, true).decided());
  EXPECT_TRUE(decided(0.99, 0.99, true).away);
}

}  // namespace facing_test
}  // namespace abstand::tracking

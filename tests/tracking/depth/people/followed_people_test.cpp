// Whom a followed person may disturb, and people who were found crouched.
#include "tracking/depth/people/followed_people.hpp"

#include <gtest/gtest.h>

namespace abstand::tracking {
namespace followed_people_test {

using Place = PlanView::Place;

constexpr double kReach = 0.8;  // m

struct Followed : ::testing::Test {
  PlanView plan;
  FollowedPeople people{DepthCamera{}, 2.0, 10.0};
};

TEST_F(Followed, PeopleDisturbWhatIsNearThemOrBehind) {
  people.add(0.0, plan, {0.0, 2.0});
  EXPECT_TRUE(people.mayDisturb({0.0, 2.5}));
  EXPECT_TRUE(people.mayDisturb({-1.0, 2.0}));
  EXPECT_TRUE(people.mayDisturb({0.0, 4.0})) << "behind";
  EXPECT_TRUE(people.mayDisturb({1.2, 4.0})) << "behind an arm";
  EXPECT_FALSE(people.mayDisturb({2.0, 4.0})) << "aside";
  EXPECT_FALSE(people.mayDisturb({-1.5, 2.0})) << "aside";
  EXPECT_FALSE(people.mayDisturb({0.0, 0.7})) << "before";
}

TEST_F(Followed, SomebodyFoundCrouchedDoesNot) {
  people.keepOrAddCrouched(0.0, plan, {0.0, 2.0}, kReach);
  ASSERT_EQ(people.all().size(), 1u);
  EXPECT_TRUE(people.all()[0].low);
  EXPECT_FALSE(people.mayDisturb({0.0, 2.1})) << "would be lost";
  people.keepOrAddCrouched(0.1, plan, {0.1, 2.1}, kReach);
  EXPECT_EQ(people.all().size(), 1u) << "the same person";
  EXPECT_EQ(people.all()[0].head_seen, 0.1);
}

TEST_F(Followed, WithdrawnPersonIsGoneWithTheArrival) {
  people.add(0.0, plan, {0.0, 2.0});
  people.add(0.0, plan, {1.5, 2.0});
  EXPECT_EQ(people.arrivals().size(), 2u);
  people.withdraw(0);
  ASSERT_EQ(people.arrivals().size(), 1u);
  EXPECT_EQ(people.arrivals()[0].id, 2);
  std::vector<Head> heads;
  people.follow(0.1, plan, heads);
  ASSERT_EQ(people.all().size(), 1u);
  EXPECT_EQ(people.all()[0].id, 2);
}

}  // namespace followed_people_test
}  // namespace abstand::tracking

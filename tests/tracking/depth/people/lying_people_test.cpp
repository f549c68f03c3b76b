// Outlines of people who lie, and of what is no person, in plan views made by hand.
#include "tracking/depth/people/lying_people.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"

namespace abstand::tracking {
namespace lying_people_test {

using Place = PlanView::Place;

/// A level surface at a height (m).
void addLevel(PlanView& plan, const Place& low, const Place& high, double z) {
  constexpr double kStep = 0.02;  // m
  for (double x = low.x(); x < high.x(); x += kStep)
    for (double y = low.y(); y < high.y(); y += kStep) plan.add(PlanView::cellAt(x, y), z, kStep * kStep);
}
/// Feet to head along x: legs, trunk, head.
void addLying(PlanView& plan, const Place& feet) {
  addLevel(plan, feet + Place(0.0, -0.2), feet + Place(0.25, 0.2), 0.22);
  addLevel(plan, feet + Place(0.25, -0.18), feet + Place(0.8, 0.18), 0.12);
  addLevel(plan, feet + Place(0.8, -0.24), feet + Place(1.45, 0.24), 0.24);
  addLevel(plan, feet + Place(1.45, -0.08), feet + Place(1.7, 0.08), 0.18);
}

struct Lying : ::testing::Test {
  PlanView plan;
  LyingPeople people;
  template <typename Add>
  void show(int images, const Add& add) {
    for (int k = 0; k < images; ++k) {
      plan.clear();
      add();
      plan.join();
      people.find(plan);
    }
  }
};

TEST_F(Lying, ArePeopleAfterSomeImages) {
  const auto add = [&] { addLying(plan, {-0.8, 2.5}); };
  show(LyingPeople::kImages - 1, add);
  EXPECT_TRUE(people.places().empty());
  show(1, add);
  ASSERT_EQ(people.places().size(), 1u);
  EXPECT_NEAR(people.places()[0].x(), 0.0, 0.1);
  EXPECT_NEAR(people.places()[0].y(), 2.5, 0.05);
  show(1, [] {});
  EXPECT_TRUE(people.places().empty());
}

TEST_F(Lying, MovingBodiesAreNoneYet) {
  double x = -1.0;
  show(2 * LyingPeople::kImages, [&] { addLying(plan, {x += 1.2 * RepeatedPlaces::kSamePlace, 2.5}); });
  EXPECT_TRUE(people.places().empty());
}

TEST_F(Lying, PalletsAndBoxesAreNone) {
  show(2 * LyingPeople::kImages, [&] {
    addLevel(plan, {-1.5, 2.0}, {-0.3, 2.8}, 0.15);  // level
    addLevel(plan, {0.0, 2.0}, {0.6, 2.5}, 0.3);     // short
    addLevel(plan, {0.0, 2.5}, {0.6, 2.7}, 0.2);
    addLevel(plan, {1.2, 2.0}, {2.4, 2.5}, 0.3);  // higher than people who lie
    addLevel(plan, {1.2, 2.5}, {2.4, 2.8}, 0.9);
    addLevel(plan, {-2.0, 4.0}, {1.8, 4.3}, 0.2);  // longer
    addLevel(plan, {-2.0, 4.3}, {1.8, 4.5}, 0.4);
  });
  EXPECT_TRUE(people.places().empty());
}

TEST_F(Lying, AllocateNothing) {
  plan.clear();
  addLying(plan, {-0.8, 2.5});
  plan.join();
  testing::NoAlloc guard;
  people.find(plan);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace lying_people_test
}  // namespace abstand::tracking

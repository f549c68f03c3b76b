// Fronts and levels that no person has, in plan views made by hand.
#include "tracking/depth/people/furniture.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"
#include "tracking/depth/people/pillars.hpp"

namespace abstand::tracking {
namespace furniture_test {

using Place = PlanView::Place;

/// A sheer surface from `a` to `b` (m, in plan view) between two heights (m).
void addFront(PlanView& plan, const Place& a, const Place& b, double low, double high) {
  constexpr double kStep = 0.01;  // m
  const double length = (b - a).norm();
  for (double s = 0.0; s < length; s += kStep)
    for (double z = low; z < high; z += kStep) {
      const Place p = a + s / length * (b - a);
      plan.add(PlanView::cellAt(p.x(), p.y()), z, kStep * kStep);
    }
}
void addLevel(PlanView& plan, const Place& low, const Place& high, double z) {
  constexpr double kStep = 0.01;  // m
  for (double x = low.x(); x < high.x(); x += kStep)
    for (double y = low.y(); y < high.y(); y += kStep) plan.add(PlanView::cellAt(x, y), z, kStep * kStep);
}
/// What is seen of somebody who stands: two legs, 0.14 m broad, and a trunk above, which is nearer.
void addPerson(PlanView& plan, const Place& at) {
  for (const double side : {-0.17, 0.03})
    addFront(plan, at + Place(side, 0.0), at + Place(side + 0.14, 0.0), 0.0, 0.85);
  addFront(plan, at + Place(-0.22, -0.06), at + Place(0.22, -0.06), 0.85, 1.5);
}
float topAt(const Furniture& furniture, const Place& p) {
  return furniture.topOf(PlanView::cellAt(p.x(), p.y()));
}

TEST(Furniture, DistinguishesBenchFromPersonBehindIt) {
  PlanView plan;
  Furniture furniture;
  plan.clear();
  addFront(plan, {-0.8, 1.8}, {0.8, 1.8}, 0.0, 0.9);
  addLevel(plan, {-0.8, 1.86}, {0.8, 2.0}, 0.9);
  addPerson(plan, {0.0, 2.3});
  plan.join();
  EXPECT_TRUE(furniture.find(plan));
  EXPECT_NEAR(topAt(furniture, {0.5, 1.81}), 0.95f, 0.03f);
  EXPECT_GT(topAt(furniture, {0.5, 1.95}), 0.9f) << "its top";
  EXPECT_EQ(topAt(furniture, {0.05, 2.31}), 0.0f) << "a leg";
}

TEST(Furniture, FindsTheEndOfABench) {
  PlanView plan;
  Furniture furniture;
  plan.clear();
  addFront(plan, {-0.25, 1.8}, {0.25, 1.8}, 0.0, 0.75);
  addLevel(plan, {-0.25, 1.86}, {0.25, 3.4}, 0.75);
  addPerson(plan, {0.55, 2.6});
  plan.join();
  EXPECT_TRUE(furniture.find(plan));
  EXPECT_NEAR(topAt(furniture, {0.1, 1.81}), 0.80f, 0.03f);
  EXPECT_GT(topAt(furniture, {0.1, 3.3}), 0.75f) << "its top, to the far end";
  EXPECT_EQ(topAt(furniture, {0.6, 2.61}), 0.0f) << "a leg";
}

// A wall goes on in its plane, also behind a gap; a cupboard does not.
TEST(Furniture, SomebodyInThePlaneOfACupboardIsNoWall) {
  for (const double top : {1.6, 2.3}) {
    PlanView plan;
    Furniture furniture;
    plan.clear();
    addFront(plan, {0.45, 2.5}, {1.05, 2.5}, 0.0, top);
    addPerson(plan, {0.0, 2.5});
    plan.join();
    EXPECT_TRUE(furniture.find(plan));
    EXPECT_GT(topAt(furniture, {0.7, 2.51}), 1.6f) << "the front";
    EXPECT_EQ(topAt(furniture, {0.05, 2.51}) > 0.0f, top > 1.9) << "a leg, beside one of " << top << " m";
  }
}

TEST(Furniture, NarrowFrontsWithoutALevelTopAreNone) {
  PlanView plan;
  Furniture furniture;
  plan.clear();
  addFront(plan, {-0.25, 1.8}, {0.0, 1.8}, 0.0, 0.7);
  addFront(plan, {0.0, 1.8}, {0.25, 1.8}, 0.0, 1.1);
  plan.join();
  EXPECT_FALSE(furniture.find(plan)) << "somebody in a coat";
  plan.clear();
  addFront(plan, {-0.25, 1.8}, {0.25, 1.8}, 0.0, 0.55);
  plan.join();
  EXPECT_FALSE(furniture.find(plan)) << "calves and knees of somebody who sits";
}

TEST(Furniture, BenchContinuesBehindAPerson) {
  PlanView plan;
  Furniture furniture;
  plan.clear();
  addFront(plan, {-0.8, 2.2}, {0.0, 2.2}, 0.0, 0.9);
  addFront(plan, {0.5, 2.2}, {0.7, 2.2}, 0.0, 0.9);
  addPerson(plan, {0.25, 1.8});
  plan.join();
  EXPECT_TRUE(furniture.find(plan));
  EXPECT_NEAR(topAt(furniture, {0.6, 2.21}), 0.93f, 0.03f);
  EXPECT_EQ(topAt(furniture, {0.31, 1.81}), 0.0f) << "a leg";
}

TEST(Furniture, SeatWithSomebodyOnItFromTheSideIsNone) {
  const auto addSeated = [](PlanView& plan) {
    addFront(plan, {-0.26, 2.0}, {-0.22, 2.0}, 0.0, 0.95);  // back of the chair
    addFront(plan, {0.18, 2.0}, {0.22, 2.0}, 0.0, 0.37);    // a leg of it
    addFront(plan, {-0.22, 2.0}, {0.22, 2.0}, 0.37, 0.41);  // seat
    addFront(plan, {-0.11, 2.0}, {0.45, 2.0}, 0.42, 0.56);  // thigh
    addFront(plan, {0.36, 2.0}, {0.45, 2.0}, 0.05, 0.42);   // calf
    addFront(plan, {-0.11, 2.0}, {0.12, 2.0}, 0.56, 1.0);   // trunk
  };
  PlanView plan;
  Furniture furniture;
  plan.clear();
  addSeated(plan);
  plan.join();
  EXPECT_FALSE(furniture.find(plan));
  plan.clear();
  addSeated(plan);
  addFront(plan, {0.6, 2.0}, {1.4, 2.0}, 0.0, 0.9);
  plan.join();
  EXPECT_TRUE(furniture.find(plan));
  EXPECT_GT(topAt(furniture, {1.0, 2.01}), 0.9f) << "a bench in line with them";
  EXPECT_EQ(topAt(furniture, {0.4, 2.01}), 0.0f) << "a calf";
}

TEST(Furniture, PeopleSideBySideAreNotFurniture) {
  PlanView plan;
  Furniture furniture;
  plan.clear();
  for (const double x : {-0.9, -0.45, 0.0, 0.45, 0.9}) addPerson(plan, {x, 2.5});
  plan.join();
  EXPECT_FALSE(furniture.find(plan));
}

TEST(Furniture, FindsPartlyHiddenWall) {
  PlanView plan;
  Furniture furniture;
  plan.clear();
  addFront(plan, {-1.5, 4.0}, {-0.4, 4.0}, 0.0, 2.2);
  addFront(plan, {-0.4, 4.0}, {0.4, 4.0}, 1.6, 2.2);
  plan.join();
  EXPECT_TRUE(furniture.find(plan));
  EXPECT_GT(topAt(furniture, {0.1, 4.01}), 2.2f);
}

TEST(Furniture, DistinguishesTableFromBentBack) {
  PlanView plan;
  Furniture furniture;
  plan.clear();
  addLevel(plan, {-0.2, 2.0}, {0.2, 2.55}, 0.9);
  plan.join();
  EXPECT_FALSE(furniture.find(plan)) << "a back";
  plan.clear();
  addLevel(plan, {-2.0, 2.0}, {-1.2, 2.7}, 0.74);
  plan.join();
  EXPECT_TRUE(furniture.find(plan));
  EXPECT_GT(topAt(furniture, {-1.5, 2.3}), 0.74f);
}

TEST(Furniture, DistinguishesPillarsFromPeople) {
  PlanView plan;
  Furniture furniture;
  for (const double height : {1.1, 1.8}) {
    plan.clear();
    addFront(plan, {-0.15, 2.5}, {0.15, 2.5}, 0.0, height);
    addLevel(plan, {-0.15, 2.5}, {0.15, 2.8}, height);
    plan.join();
    EXPECT_GT(sheerShare(plan, plan.component(0)), 0.95) << height;
    EXPECT_TRUE(furniture.find(plan)) << height;
    EXPECT_GT(topAt(furniture, {0.0, 2.51}), static_cast<float>(height));
  }
  plan.clear();
  addPerson(plan, {0.0, 2.5});
  addFront(plan, {-0.08, 2.44}, {0.08, 2.44}, 1.5, 1.75);  // the head
  plan.join();
  EXPECT_LT(sheerShare(plan, plan.component(0)), kPillar);
  plan.clear();
  addFront(plan, {-0.15, 2.5}, {0.15, 2.5}, 0.0, 0.9);  // as high as a chair
  plan.join();
  EXPECT_EQ(sheerShare(plan, plan.component(0)), 0.0);
}

// The side of the image cuts it off obliquely, as seen by a camera that looks down.
TEST(Furniture, PillarMayBeCutOffByASide) {
  constexpr double kTop = 1.6;  // m
  for (const bool at_side : {false, true}) {
    PlanView plan;
    plan.clear();
    addFront(plan, {-0.15, 2.5}, {0.0, 2.5}, 0.0, kTop);
    addLevel(plan, {-0.15, 2.5}, {0.0, 2.8}, kTop);
    for (double x = 0.02; x < 0.3; x += PlanView::kCell) {
      addFront(plan, {x, 2.5}, {x + PlanView::kCell, 2.5}, 0.0, kTop * (1.0 - x / 0.3));
      if (at_side) plan.markSide(PlanView::cellAt(x, 2.5));
    }
    plan.join();
    ASSERT_EQ(plan.components(), 1u);
    EXPECT_EQ(sheerShare(plan, plan.component(0)) >= kPillar, at_side);
  }
}

TEST(Furniture, PersistsForLimitedImages) {
  PlanView bench, empty;
  Furniture furniture;
  bench.clear();
  empty.clear();
  addFront(bench, {-0.8, 1.8}, {0.8, 1.8}, 0.0, 0.9);
  bench.join();
  empty.join();
  testing::NoAlloc guard;
  EXPECT_TRUE(furniture.find(bench));
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(furniture.find(empty)) << i;
  EXPECT_FALSE(furniture.find(empty));
  EXPECT_EQ(topAt(furniture, {0.5, 1.81}), 0.0f);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace furniture_test
}  // namespace abstand::tracking

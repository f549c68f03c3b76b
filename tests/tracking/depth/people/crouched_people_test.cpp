// Low bodies in motion.
#include "tracking/depth/people/crouched_people.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"

namespace abstand::tracking {
namespace crouched_people_test {

using Place = PlanView::Place;

constexpr double kEvery = 1.0 / 30.0;  // s, between two images
constexpr double kCellArea = 0.0012;   // m^2 of surface in each slab of a cell
constexpr double kNear = 2.0;          // m, of a body from the camera
// m, root mean square: of somebody who keeps still there (measured 0.004 to 0.01), and of a chair (0.001).
constexpr double kOfPerson = 0.005, kOfThing = 0.001;

struct Surface {
  double settled;  // share
  double drift;    // m
};
constexpr Surface kMoves{0.2, 0.0}, kStill{0.85, kOfPerson}, kStands{0.95, kOfThing};

class Crouched : public ::testing::Test {
 protected:
  /// A body as broad and as deep as given (m), of which one half drifts ahead, and the other one back.
  void add(const Place& middle, const Surface& surface, double breadth = 0.5, double depth = 0.4,
           float top = 0.85f) {
    for (double x = -0.5 * breadth; x <= 0.5 * breadth; x += PlanView::kCell)
      for (double y = -0.5 * depth; y <= 0.5 * depth; y += PlanView::kCell) {
        const int cell = PlanView::cellAt(middle.x() + x, middle.y() + y);
        for (float h = 0.1f; h < top; h += 0.25f) add(cell, h, x, surface);
        add(cell, top, x, surface);
      }
  }
  void add(int cell, float h, double x, const Surface& surface) {
    plan_.add(cell, static_cast<double>(h), kCellArea);
    plan_.addSettled(cell, surface.settled * kCellArea, x < 0.0 ? surface.drift : -surface.drift);
  }
  std::size_t find(bool is_disturbed = false) {
    t_ += kEvery;
    plan_.join();
    people_.find(t_, plan_, [&](const Place&) { return is_disturbed; });
    plan_.clear();
    return people_.places().size();
  }
  PlanView plan_;
  CrouchedPeople people_;
  double t_{0.0};
};

TEST_F(Crouched, WhoKeepsStillIsFoundAfterSomeImages) {
  for (int k = 1; k <= CrouchedPeople::kImages; ++k) {
    add({0.1, kNear}, kStill);
    EXPECT_EQ(find(), k < CrouchedPeople::kImages ? 0u : 1u) << k;
  }
  EXPECT_NEAR((people_.places()[0] - Place(0.1, kNear)).norm(), 0.0, PlanView::kCell);
}

TEST_F(Crouched, WhoMovesIsFoundAfterATime) {
  for (double since = 0.0; since < 2.0 * CrouchedPeople::kUnsettled; since += kEvery) {
    add({0.1 + 0.2 * since, kNear}, kMoves);
    const std::size_t found = find();
    if (std::abs(since - CrouchedPeople::kUnsettled) < 0.5 * kEvery) continue;  // rounded
    EXPECT_EQ(found, since < CrouchedPeople::kUnsettled ? 0u : 1u) << since;
  }
}

TEST_F(Crouched, WhatStandsIsNobody) {
  for (int k = 0; k < 100; ++k) {
    add({0.1, kNear}, k < 20 ? Surface{0.0, 0.0} : kStands);  // appears, and settles
    EXPECT_EQ(find(), 0u) << k;
  }
}

// The noise of a Kinect increases with the square of the distance.
TEST_F(Crouched, NoiseOfDistantThingsIsNoDrift) {
  constexpr double kFar = 4.0;
  for (int k = 0; k < 100; ++k) {
    add({0.1, kFar}, {0.95, kOfThing * (kFar * kFar) / (kNear * kNear)});
    EXPECT_EQ(find(), 0u) << k;
  }
}

TEST_F(Crouched, ThingsThatSomebodyMovesOrHidesAreNobody) {
  for (int k = 0; k < 100; ++k) {
    add({0.1, kNear}, k % 2 == 0 ? kMoves : kStill);
    EXPECT_EQ(find(true), 0u) << k;
  }
  for (int k = 0; k < 100; ++k) {
    add({0.1, kNear}, kStill);
    plan_.markBesideKnown(PlanView::cellAt(0.1, kNear));
    EXPECT_EQ(find(), 0u) << k;
  }
}

TEST_F(Crouched, SmallLargeFlatAndHighOnesAreNobody) {
  for (int k = 0; k < 100; ++k) {
    add({-3.0, kNear}, kMoves, 0.2, 0.12);       // a dog
    add({-1.0, kNear}, kMoves, 1.6, 0.3);        // a table
    add({1.0, kNear}, kMoves, 0.5, 0.4, 0.4f);   // a robot for the floor
    add({3.0, kNear}, kMoves, 0.5, 0.4, 1.25f);  // for HeadlessPeople
    EXPECT_EQ(find(), 0u) << k;
  }
}

// As many as there is room for.
TEST_F(Crouched, ManyAreFoundUpToALimit) {
  std::size_t found = 0;
  for (int k = 0; k < 100; ++k) {
    for (int person = 0; person < 14; ++person)
      add({-4.0 + 1.2 * (person % 7), person < 7 ? 2.0 : 4.0},
          person % 2 == 0 ? kMoves : Surface{0.85, 0.05});
    found = find();
    ASSERT_LE(found, RepeatedPlaces::kMax);
  }
  EXPECT_GE(found, RepeatedPlaces::kMax / 2);
}

TEST_F(Crouched, AllocateNothing) {
  add({0.1, kNear}, kStill);
  plan_.join();
  testing::NoAlloc guard;
  people_.find(kEvery, plan_, [](const Place&) { return false; });
}

}  // namespace crouched_people_test
}  // namespace abstand::tracking

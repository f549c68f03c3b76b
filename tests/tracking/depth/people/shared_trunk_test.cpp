// Two peaks above one trunk, or above two.
#include "tracking/depth/people/shared_trunk.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"

namespace abstand::tracking {
namespace shared_trunk_test {

using Place = PlanView::Place;

constexpr double kPeak = 1.95;        // m
constexpr double kCellArea = 0.0008;  // m^2 of surface in each slab of a cell
const Place kMiddle(0.0, 2.8);        // m
const Place kAcross = Place::UnitX(), kAhead = Place::UnitY();

class SharedTrunk : public ::testing::Test {
 protected:
  /// An upright cuboid of the size of a trunk, from the hips to the shoulders.
  void addTrunk(const Place& middle, double breadth = 0.42, double depth = 0.2) {
    for (double x = -0.5 * breadth; x <= 0.5 * breadth; x += PlanView::kCell)
      for (double y = -0.5 * depth; y <= 0.5 * depth; y += PlanView::kCell)
        for (double h = 0.8; h < 1.45; h += PlanView::kSlab)
          plan_.add(PlanView::cellAt(middle.x() + x, middle.y() + y), h, kCellArea);
  }
  bool share(const Place& half) const { return shareTrunk(plan_, kMiddle - half, kMiddle + half, kPeak); }
  PlanView plan_;
};

TEST_F(SharedTrunk, FistsAreAboveOneTrunk) {
  addTrunk(kMiddle);
  for (const double half : {0.2, 0.3, 0.39}) EXPECT_TRUE(share(half * kAcross)) << half;
  EXPECT_TRUE(share(0.2 * (kAcross + kAhead)));
}

TEST_F(SharedTrunk, PeopleSideBySideHaveTwo) {
  for (const double half : {0.22, 0.3, 0.39}) {
    addTrunk(kMiddle - half * kAcross);
    addTrunk(kMiddle + half * kAcross);
    EXPECT_FALSE(share(half * kAcross)) << half;
    plan_.clear();
  }
}

TEST_F(SharedTrunk, PeopleWhoTurnTheirSidesHaveTwo) {
  addTrunk(kMiddle - 0.25 * kAcross, 0.22);
  addTrunk(kMiddle + 0.25 * kAcross, 0.22);
  EXPECT_FALSE(share(0.25 * kAcross));
}

TEST_F(SharedTrunk, PartlyHiddenNeighbourHasOne) {
  addTrunk(kMiddle - 0.2 * kAcross);
  addTrunk(kMiddle + 0.3 * kAcross, 0.2);  // the outer half
  EXPECT_FALSE(share(0.2 * kAcross));
}

TEST_F(SharedTrunk, PeopleBehindOneAnotherAndFarPeaksAreTwo) {
  addTrunk(kMiddle);
  EXPECT_FALSE(share(0.2 * kAhead));
  EXPECT_FALSE(share((0.5 * kPeaksOfOne + 0.01) * kAcross));
}

TEST_F(SharedTrunk, WithoutSurfaceThereIsNone) { EXPECT_FALSE(share(0.2 * kAcross)); }

TEST_F(SharedTrunk, AllocatesNothing) {
  addTrunk(kMiddle);
  testing::NoAlloc guard;
  EXPECT_TRUE(share(0.3 * kAcross));
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace shared_trunk_test
}  // namespace abstand::tracking

// Plates beside somebody who stands: things are removed, limbs are not.
#include "tracking/depth/people/things_beside.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/depth/people/painted_image.hpp"

namespace abstand::tracking {
namespace things_beside_test {

using testing::PaintedImage;

struct ThingsBesideTest : ::testing::Test {
  PaintedImage painted;
  ThingsBeside things{painted.camera()};

  void find() {
    things.look(painted.image());
    things.find(painted.image(), painted.floor(), painted.cells(), {0.0, 2.5}, 1, painted.labels());
  }
  bool isPerson(double x, double h, double z) { return painted.labels()[painted.pixelOf(x, h, z)] == 1; }
  std::size_t personPixels() {
    return static_cast<std::size_t>(std::count(painted.labels().begin(), painted.labels().end(), 1));
  }
  void crate(double nearer = 0.3) { painted.plate(0.30, 0.70, 0.03, 0.45, 2.5 - nearer); }
};

TEST_F(ThingsBesideTest, RemovesACrateAndNothingOfThePerson) {
  painted.person();
  const std::size_t person = personPixels();
  crate();
  find();
  EXPECT_EQ(personPixels(), person);
  EXPECT_FALSE(isPerson(0.5, 0.3, 2.2));
}

TEST_F(ThingsBesideTest, RemovesACrateThatAPersonHidesInPart) {
  painted.person();
  painted.plate(0.05, 0.75, 0.03, 0.45, 2.9);
  const std::size_t legs = personPixels();
  find();
  EXPECT_FALSE(isPerson(0.5, 0.3, 2.9));
  EXPECT_LT(personPixels(), legs);
  EXPECT_TRUE(isPerson(0.1, 0.3, 2.5)) << "the leg before it";
}

TEST_F(ThingsBesideTest, RemovesAPostWithWhatItCarries) {
  painted.person();
  const std::size_t person = personPixels();
  painted.plate(0.30, 0.38, 0.03, 1.30, 2.3);
  painted.plate(0.24, 0.44, 1.20, 1.40, 2.1);
  find();
  EXPECT_FALSE(isPerson(0.34, 0.6, 2.3)) << "the post";
  EXPECT_FALSE(isPerson(0.34, 1.3, 2.1)) << "the box on it";
  EXPECT_EQ(personPixels(), person);
}

// A bar hides the thighs: the legs below it go on above behind it.
TEST_F(ThingsBesideTest, KeepsLegsBelowABar) {
  painted.person();
  painted.plate(-0.6, 0.6, 0.55, 0.75, 2.0, false);
  const std::size_t person = personPixels();
  find();
  EXPECT_EQ(personPixels(), person);
  EXPECT_TRUE(isPerson(0.1, 0.3, 2.5));
}

TEST_F(ThingsBesideTest, KeepsAnArmAheadOfTheTrunkAndAFarLeg) {
  painted.person();
  painted.plate(-0.05, 0.05, 1.10, 1.20, 1.9);  // a hand, 0.6 m ahead
  painted.plate(0.10, 0.28, 0.03, 0.75, 2.8);   // a leg behind the other one
  const std::size_t person = personPixels();
  find();
  EXPECT_EQ(personPixels(), person);
}

TEST_F(ThingsBesideTest, KeepsTheCalvesOfSomebodyWhoSits) {
  painted.plate(-0.09, 0.09, 1.05, 1.32, 2.7);
  painted.plate(-0.22, 0.22, 0.40, 1.06, 2.7);
  painted.plate(-0.15, 0.15, 0.03, 0.52, 2.25);  // both calves and knees beside each other
  const std::size_t person = personPixels();
  things.find(painted.image(), painted.floor(), painted.cells(), {0.0, 2.7}, 1, painted.labels());
  EXPECT_EQ(personPixels(), person);
}

TEST_F(ThingsBesideTest, RemembersWhatAHandTouchesAndForgetsWhatLeaves) {
  for (int k = 0; k < ThingsBeside::kImages; ++k) {
    EXPECT_FALSE(things.has(painted.pixelOf(0.5, 0.3, 2.2), 2.2f)) << k;
    painted.clear();
    painted.person();
    crate();
    find();
  }
  const std::size_t inside = painted.pixelOf(0.5, 0.3, 2.2);
  EXPECT_TRUE(things.has(inside, 2.2f));
  EXPECT_FALSE(things.has(inside, 2.1f)) << "a hand before it";
  ThingsBeside next(painted.camera());
  next.expect(things.things());
  EXPECT_TRUE(next.has(inside, 2.2f)) << "known from the first image on";
  next.expect({});
  EXPECT_TRUE(next.has(inside, 2.2f)) << "of another size: ignored";
  painted.clear();
  for (int k = 0; k < 10; ++k) things.look(painted.image());
  EXPECT_FALSE(things.has(inside, 2.2f)) << "the wall behind is seen";
}

TEST_F(ThingsBesideTest, DoesNotAllocate) {
  painted.person();
  crate();
  const testing::NoAlloc guard;
  find();
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace things_beside_test
}  // namespace abstand::tracking

// Bodies at the upper border of the image.
#include "tracking/depth/people/headless_people.hpp"

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"

namespace abstand::tracking {
namespace headless_people_test {

using Place = PlanView::Place;

constexpr float kCut = 1.72f;         // m, height of the border at the body
constexpr double kCellArea = 0.0008;  // m^2 of surface in each slab of a cell

class Headless : public ::testing::Test {
 protected:
  /// A body as broad and as deep as given (m), up to the border.
  void add(const Place& middle, double breadth, double depth, float top = kCut, bool cut = true) {
    for (double x = -0.5 * breadth; x <= 0.5 * breadth; x += PlanView::kCell)
      for (double y = -0.5 * depth; y <= 0.5 * depth; y += PlanView::kCell) {
        const int cell = PlanView::cellAt(middle.x() + x, middle.y() + y);
        for (float h = 0.3f; h < top; h += 0.25f) plan_.add(cell, static_cast<double>(h), kCellArea);
        plan_.add(cell, static_cast<double>(top), kCellArea);
        if (cut) plan_.markCut(cell);
      }
  }
  std::size_t find() {
    plan_.join();
    people_.find(plan_);
    plan_.clear();
    return people_.places().size();
  }
  PlanView plan_;
  HeadlessPeople people_;
};

TEST_F(Headless, MovingBodyIsAPersonAfterSomeImages) {
  for (int k = 1; k <= HeadlessPeople::kImages; ++k) {
    add({0.0, 1.3 + 0.02 * k}, 0.45, 0.2);
    EXPECT_EQ(find(), k < HeadlessPeople::kImages ? 0u : 1u) << k;
  }
  EXPECT_NEAR((people_.places()[0] - Place(0.0, 1.5)).norm(), 0.0, 0.05);
}

TEST_F(Headless, WhatStandsIsNone) {
  for (int k = 0; k < 3 * HeadlessPeople::kImages; ++k) {
    add({0.0, 1.3}, 0.45, 0.2);
    EXPECT_EQ(find(), 0u) << k;
  }
}

TEST_F(Headless, BroadLowAndThinOnesAreNone) {
  for (const bool cut : {true, false})
    for (int k = 0; k < 2 * HeadlessPeople::kImages; ++k) {
      const double y = 1.3 + 0.02 * k;
      add({-3.0, y}, 1.2, 0.2, kCut, cut);   // a front
      add({-1.0, y}, 0.45, 0.2, 0.9f, cut);  // as high as the hips
      add({1.0, y}, 0.08, 0.08, kCut, cut);  // a post
      add({3.0, y}, 0.45, 0.2, 2.47f, cut);  // higher than a person with raised arms
      EXPECT_EQ(find(), 0u) << k;
    }
}

TEST_F(Headless, WholeBodiesArePeopleWhateverTheirHighestPart) {
  for (int k = 1; k <= HeadlessPeople::kImages; ++k) {
    const Place middle(0.0, 1.3 + 0.02 * k);
    add(middle, 0.45, 0.2, 1.4f, false);
    for (const double aside : {-0.25, 0.25}) add(middle + aside * Place::UnitX(), 0.1, 0.1, 1.95f, false);
    EXPECT_EQ(find(), k < HeadlessPeople::kImages ? 0u : 1u) << k;
  }
  EXPECT_NEAR((people_.places()[0] - Place(0.0, 1.5)).norm(), 0.0, 0.1);
}

TEST_F(Headless, AllocateNothing) {
  add({0.0, 1.3}, 0.45, 0.2);
  plan_.join();
  people_.find(plan_);
  testing::NoAlloc guard;
  people_.find(plan_);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace headless_people_test
}  // namespace abstand::tracking

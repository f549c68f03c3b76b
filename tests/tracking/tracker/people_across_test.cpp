// Ids of people whom several cameras find.
#include "tracking/tracker/people_across.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace abstand::tracking {
namespace people_across_test {

using ::testing::ElementsAre;

constexpr double kStep = 1.0 / 30.0;  // s

std::vector<int> ids(PeopleAcross& across, double t, std::vector<SeenPlace> seen) {
  const std::span<const int> found = across.match(t, seen);
  return {found.begin(), found.end()};
}

TEST(PeopleAcross, MergesNearbyPeopleOfTwoCameras) {
  PeopleAcross across;
  EXPECT_THAT(
      ids(across, 0.0, {{0, 1, {0.0, 0.0}}, {0, 2, {2.0, 0.0}}, {1, 7, {1.9, 0.3}}, {1, 8, {0.2, 0.0}}}),
      ElementsAre(1, 2, 2, 1));
  EXPECT_THAT(ids(across, kStep, {{1, 8, {0.2, 0.0}}, {2, 1, {-3.0, 0.0}}}), ElementsAre(1, 3));
}

TEST(PeopleAcross, PeopleOfOneCameraKeepDistinctIds) {
  PeopleAcross across;
  EXPECT_THAT(
      ids(across, 0.0, {{0, 1, {0.0, 0.0}}, {0, 2, {0.1, 0.0}}, {1, 5, {0.05, 0.0}}, {1, 6, {0.1, 0.0}}}),
      ElementsAre(1, 2, 1, 2));
}

TEST(PeopleAcross, KeepsIdsWhilePeoplePass) {
  PeopleAcross across;
  for (double x = -1.0; x < 1.0; x += 0.05) {
    const double t = x + 1.0;
    EXPECT_THAT(ids(across, t, {{0, 1, {x, 0.0}}, {0, 2, {-x, 0.1}}, {1, 3, {x, 0.0}}, {1, 4, {-x, 0.1}}}),
                ElementsAre(1, 2, 1, 2));
  }
}

TEST(PeopleAcross, SplitsDivergingAndMergesCoincidingPeople) {
  PeopleAcross across;
  EXPECT_THAT(ids(across, 0.0, {{0, 1, {0.0, 0.0}}, {1, 1, {0.3, 0.0}}}), ElementsAre(1, 1));
  double t = 0.0;
  for (; t < 1.0; t += kStep) ids(across, t, {{0, 1, {0.0, 0.0}}, {1, 1, {2.0, 0.0}}});
  EXPECT_THAT(ids(across, t, {{0, 1, {0.0, 0.0}}, {1, 1, {2.0, 0.0}}}), ElementsAre(1, 2));
  // The second camera was wrong at first, behind a bench.
  for (double end = t + 1.0; t < end; t += kStep) ids(across, t, {{0, 1, {0.0, 0.0}}, {1, 1, {0.1, 0.0}}});
  EXPECT_THAT(ids(across, t, {{0, 1, {0.0, 0.0}}, {1, 1, {0.1, 0.0}}}), ElementsAre(1, 1));
}

}  // namespace people_across_test
}  // namespace abstand::tracking

// A second look at a recording: who was found later is found from the start.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/tracking/tracker/small_camera.hpp"
#include "tracking/depth/people/people_finder.hpp"

namespace abstand::tracking {
namespace expected_people_test {

constexpr double kEye = 1.3;   // m, of a level camera
constexpr double kStep = 0.1;  // s between images

DepthCamera levelCamera() { return smallCameraAt({0.0, 0.0, kEye}, {1.0, 0.0, kEye}); }

/// Legs and a trunk 3 m away, `right` (m) of the axis; a head only with `has_head`.
void draw(DepthImage& image, double right, bool has_head) {
  constexpr double kAway = 3.0, kHips = 0.8, kShoulders = 1.4, kVertex = 1.7;  // m
  const DepthCamera camera = levelCamera();
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      const Vector3d p = camera.at(u, v, kAway);
      const double up = kEye - p.y(), aside = std::abs(p.x() - right);
      const bool is_leg = up > 0.1 && up < kHips && aside > 0.03 && aside < 0.17;
      const bool is_trunk = up >= kHips && up < kShoulders && aside < 0.22;
      const bool is_head = has_head && up >= kShoulders && up < kVertex && aside < 0.09;
      if (is_leg || is_trunk || is_head)
        image.z[static_cast<std::size_t>(v * image.width + u)] =
            static_cast<float>(is_leg ? kAway + 0.06 : kAway);
    }
}

/// Two people; where each is in image i, and from which image on a head is seen.
struct Scene {
  std::array<int, 2> head_from{0, 0};
  std::array<int, 2> there_from{0, 0};
  int hidden_from{0}, hidden_until{0};  ///< images in which the left one is not there
  DepthImage image(int i) const {
    DepthImage image(levelCamera().width, levelCamera().height);
    for (std::size_t k = 0; k < 2; ++k)
      if (i >= there_from[k] && (k == 1 || i < hidden_from || i >= hidden_until))
        draw(image, k == 0 ? -0.6 : 0.6, i >= head_from[k]);
    return image;
  }
};

constexpr int kImages = 20;

/// In each image the ids of the people, from left to right. Person k + 1 is foreseen before image arrives[k].
std::vector<std::vector<int>> look(const Scene& scene, PeopleFinder& finder,
                                   std::array<int, 2> arrives = {0, 0}, double step = kStep) {
  std::vector<std::vector<int>> ids;
  for (int i = 0; i < kImages; ++i) {
    std::vector<FoundPerson> people = finder.find(step * i, scene.image(i)).persons;
    EXPECT_TRUE(std::is_sorted(people.begin(), people.end(),
                               [](const FoundPerson& a, const FoundPerson& b) { return a.id < b.id; }));
    std::sort(people.begin(), people.end(),
              [](const FoundPerson& a, const FoundPerson& b) { return a.centroid.x() < b.centroid.x(); });
    ids.emplace_back();
    for (const FoundPerson& person : people) {
      ids.back().push_back(person.id);
      EXPECT_EQ(person.foreseen, i < arrives.at(static_cast<std::size_t>(person.id - 1))) << i;
    }
  }
  return ids;
}

TEST(ExpectedPeople, AreFoundBeforeTheirHeads) {
  const Scene scene{.head_from = {6, 0}};
  PeopleFinder first(levelCamera());
  const auto before = look(scene, first);
  EXPECT_EQ(before[0], (std::vector<int>{1}));
  EXPECT_EQ(before[6], (std::vector<int>{2, 1}));
  ASSERT_EQ(first.arrivals().size(), 2u);
  PeopleFinder second(levelCamera());
  second.expect(first.seen());
  for (const std::vector<int>& ids : look(scene, second, {0, 6})) EXPECT_EQ(ids, (std::vector<int>{2, 1}));
}

TEST(ExpectedPeople, KeepTheirNumbersInAnotherOrder) {
  // The right one is found first, and the left one could have been before.
  const Scene scene{.head_from = {8, 4}, .there_from = {0, 3}};
  PeopleFinder first(levelCamera()), second(levelCamera());
  const auto before = look(scene, first);
  EXPECT_EQ(before[4], (std::vector<int>{1}));
  EXPECT_EQ(before[8], (std::vector<int>{2, 1}));
  second.expect(first.seen());
  const auto after = look(scene, second, {4, 8});
  EXPECT_EQ(after[0], (std::vector<int>{2}));
  EXPECT_EQ(after[2], (std::vector<int>{2}));
  EXPECT_EQ(after[3], (std::vector<int>{2, 1}));
  EXPECT_EQ(after.back(), (std::vector<int>{2, 1}));
}

TEST(ExpectedPeople, AreNotWhereNobodyIsYet) {
  const Scene scene{.head_from = {8, 0}, .there_from = {8, 0}};
  PeopleFinder first(levelCamera()), second(levelCamera());
  const auto before = look(scene, first);
  second.expect(first.seen());
  EXPECT_EQ(look(scene, second), before);
}

TEST(ExpectedPeople, AreFoundAtMostTheForesightEarlier) {
  constexpr int kLate = 15;
  constexpr double kSlow = 0.4;                                 // s between images
  const PeopleFinderOptions options{.learn_after = kInfinity};  // who stands still is no background
  const Scene scene{.head_from = {kLate, 0}};
  PeopleFinder first(levelCamera(), options), second(levelCamera(), options);
  look(scene, first, {0, 0}, kSlow);
  second.expect(first.seen());
  const auto after = look(scene, second, {0, kLate}, kSlow);
  const int earliest = kLate - static_cast<int>(std::lround(FollowedPeople::kForesight / kSlow));
  ASSERT_GT(earliest, 0);
  for (int i = 0; i < kImages; ++i)
    EXPECT_EQ(after[static_cast<std::size_t>(i)].size(), i < earliest ? 1u : 2u) << i;
}

// Hidden for a while, as by somebody who passes, before the arrival.
TEST(ExpectedPeople, KeepTheirNumbersIfTheyAreLostBefore) {
  constexpr double kSlow = 0.4;  // s between images; they are forgotten after five
  const Scene scene{.head_from = {15, 0}, .hidden_from = 8, .hidden_until = 14};
  const PeopleFinderOptions options{.learn_after = kInfinity};
  PeopleFinder first(levelCamera(), options), second(levelCamera(), options);
  look(scene, first, {0, 0}, kSlow);
  second.expect(first.seen());
  const auto after = look(scene, second, {0, 15}, kSlow);
  EXPECT_EQ(after[7], (std::vector<int>{2, 1}));
  EXPECT_EQ(after[13], (std::vector<int>{1}));
  for (std::size_t i = 14; i < kImages; ++i) EXPECT_EQ(after[i], (std::vector<int>{2, 1})) << i;
}

}  // namespace expected_people_test
}  // namespace abstand::tracking

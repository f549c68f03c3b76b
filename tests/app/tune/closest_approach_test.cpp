#include "app/tune/closest_approach.hpp"

#include <gtest/gtest.h>

namespace abstand::tune {
namespace closest_approach_test {

/// A hand with these clearances (m), a second apart; infinitely uncertain where it was not seen.
TunedRecording handOf(const std::vector<double>& clearance) {
  TunedRecording recording;
  recording.pass.links = {"link"};
  PartClearance part{};
  part.part = "hand_left";
  for (std::size_t i = 0; i < clearance.size(); ++i) {
    part.track.t.push_back(static_cast<double>(i));
    part.track.clearance.push_back(clearance[i]);
    part.track.between.push_back(kInfinity);
    part.distance.push_back(0.5);
    part.bound.push_back(0.0);
    part.uncertainty.push_back(0.5 - clearance[i]);
    part.link.push_back(0);
  }
  recording.pass.parts.push_back(part);
  return recording;
}

ClosestApproach::Verdict verdictOf(const std::vector<double>& clearance) {
  return closestApproaches({handOf(clearance)}, 0.0).front().verdict();
}

TEST(ClosestApproach, OfAPartThatIsSomewhereNotSeenIsNotKnown) {
  using Verdict = ClosestApproach::Verdict;
  EXPECT_EQ(verdictOf({0.3, 0.2}), Verdict::kApart);
  EXPECT_EQ(verdictOf({0.3, 0.0}), Verdict::kTouchPossible);
  EXPECT_EQ(verdictOf({0.3, -kInfinity, 0.2}), Verdict::kNotKnown);
  EXPECT_EQ(verdictOf({0.3, -kInfinity}), Verdict::kNotKnown) << "the last frame, behind which is no time";
  EXPECT_EQ(verdictOf({-kInfinity}), Verdict::kNotKnown) << "never seen";
}

}  // namespace closest_approach_test
}  // namespace abstand::tune

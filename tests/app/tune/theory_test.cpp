// Margins against closed forms: what a robot needs to stop, and how far a person comes meanwhile.
#include <gtest/gtest.h>

#include "app/tune/margin_table.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::tune {
namespace theory_test {

// m: the engine's distances are within 1e-5 m of the true ones near contact, and searches between times end
// within 1e-4 m.
constexpr double kEngine = 3e-4;

struct Theory {
  testing::SlideSpeeds speeds;
  BrakingOptions braking;
  double limit{0.0};
  const char* name;

  /// m: person's way until rest, robot's way while it reacts, and while it brakes.
  double needed() const {
    const double stopping = speeds.robot / braking.deceleration;
    return limit + speeds.person * (braking.reaction_time + stopping) + speeds.robot * braking.reaction_time +
           0.5 * speeds.robot * stopping;
  }
  /// m: the distance falls by so much from frame to frame.
  double perFrame() const { return (speeds.robot + speeds.person) / speeds.rate; }
};

class TuneTheory : public ::testing::TestWithParam<Theory> {};

TEST_P(TuneTheory, SmallestSafeMarginMatchesStoppingDistance) {
  const Theory& theory = GetParam();
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, theory.speeds);
  TuneOptions options;
  options.pass.braking = theory.braking;
  options.pass.limit = theory.limit;
  const TunedRecording tuned = tuneRecording(*session, options, {}, "slide");
  const PartClearance* torso = nullptr;
  for (const PartClearance& p : tuned.pass.parts)
    if (p.part == "torso") torso = &p;
  ASSERT_TRUE(torso);
  const margin::SafeMargin safe = margin::smallestSafeMargin(torso->track, options.margins());
  ASSERT_TRUE(safe.decided);
  // The last frame whose stop comes too late is at most `needed` away; the margin has to be larger than the
  // clearance of the frame before.
  EXPECT_LT(safe.sampling, theory.perFrame() + kEngine);
  EXPECT_GT(safe.margin + kEngine, theory.needed());
  EXPECT_LT(safe.margin - safe.sampling, theory.needed() + kEngine);
  // Margins a millimetre to either side.
  EXPECT_EQ(margin::outcome(torso->track, safe.margin + 1e-3, options.margins()).missed_stops, 0);
  EXPECT_GT(margin::outcome(torso->track, theory.needed() - kEngine, options.margins()).missed_stops, 0);
}

INSTANTIATE_TEST_SUITE_P(EachTermByItself, TuneTheory,
                         ::testing::Values(
                             // Almost no braking: the way in the reaction time alone.
                             Theory{{.robot = 0.8}, {0.25, 1000.0}, 0.0, "reaction"},
                             // The braking way alone: v^2 / (2 a).
                             Theory{{.robot = 0.8}, {0.0, 2.0}, 0.0, "braking"},
                             // A person who comes while a slow robot reacts.
                             Theory{
                                 {.robot = 0.01, .person = 1.2}, {0.25, 1000.0}, 0.0, "person_in_reaction"},
                             // A person who comes while the robot brakes.
                             Theory{{.robot = 0.4, .person = 0.6}, {0.0, 1.0}, 0.0, "person_in_braking"},
                             Theory{{.robot = 0.8}, {0.0, 1000.0}, 0.05, "limit"},
                             Theory{{.robot = 0.5, .person = 0.7, .rate = 250.0}, {0.1, 1.5}, 0.02, "all"}),
                         [](const auto& theory) { return theory.param.name; });

TEST(TuneTheory, StandingRobotMissesNothing) {
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.0, .person = 0.8});
  const TunedRecording tuned = tuneRecording(*session, {}, {}, "slide");
  for (const PartClearance& p : tuned.pass.parts) {
    EXPECT_FALSE(margin::smallestSafeMargin(p.track, {}).decided) << p.part;
    EXPECT_LT(*std::min_element(p.track.clearance.begin(), p.track.clearance.end()),
              p.part == "torso" ? 0.0 : 3.0);
  }
}

TEST(TuneTheory, HandStoppingShortNeedsNoStop) {
  // The person comes 0.9 m and stands; the robot rests behind 1.0 m: 2.4 - 0.9 - 1.0 is left of the way.
  const testing::ScratchFolder folder;
  const auto session = testing::openSlide(folder, {.robot = 0.25, .person = 0.9, .stops_at = 1.0});
  const TunedRecording tuned = tuneRecording(*session, {}, {}, "slide");
  const MarginTable table = marginTable({tuned}, {0.0, 0.1, 0.45, 2.0}, {});
  for (const ProposedMargin& p : table.proposed) {
    EXPECT_EQ(p.margin, 0.0) << p.part;
    EXPECT_FALSE(p.decided_by) << p.part;
  }
  for (const MarginRow& row : table.rows) {
    EXPECT_EQ(row.outcome.missed_stops, 0) << row.part << " " << row.margin;
    EXPECT_EQ(row.outcome.false_stops, row.outcome.stops) << row.part << " " << row.margin;
  }
  const margin::MarginOutcome& widest = table.rows.back().outcome;
  EXPECT_EQ(table.rows.back().part, kWholeBody);
  EXPECT_EQ(widest.stops, 1);
  EXPECT_GT(widest.stoppedShare(), 0.5);
}

}  // namespace theory_test
}  // namespace abstand::tune

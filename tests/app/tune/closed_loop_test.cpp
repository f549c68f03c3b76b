// Stops, false stops and missed stops of margins against the loop that is played frame by frame.
#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "app/tune/margin_table.hpp"
#include "tests/app/tune/frame_by_frame.hpp"
#include "tests/app/tune/margin_clips.hpp"

namespace abstand::testing {
namespace closed_loop_test {

const std::vector<double> kMargins{0.0, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4};
// s, of sums of times.
constexpr double kRounding = 1e-9;

struct Agreement {
  long rows{0};
  long exact{0};  ///< rows in which no clearance is within the tolerance of the limit
  long safer{0};  ///< of these, rows with another count, on the safe side
  long stops{0}, false_stops{0}, missed_stops{0};
};

std::size_t firstJudged(const tune::TunedRecording& tuned, const FrameByFrame::Parts& parts,
                        const margin::MarginOptions& options) {
  std::size_t first = 0;
  for (const tune::PartClearance& p : tuned.pass.parts)
    for (const humanmodel::BodyPart part : parts)
      if (p.part == humanmodel::partName(part))
        first = std::max(first, margin::firstJudgedFrame(p.track, options));
  return first;
}

/// Where a margin can be judged from: the stop at every frame before comes too late, for one part each.
void checkBeginning(FrameByFrame& loop, const tune::TunedRecording& tuned, const FrameByFrame::Parts& parts,
                    const margin::MarginOptions& options) {
  for (const humanmodel::BodyPart part : parts) {
    const std::size_t first = firstJudged(tuned, {part}, options);
    for (std::size_t i = 0; i < first; ++i) EXPECT_NE(loop.stopped({part}, i), Touch::kNo) << i;
    if (first == loop.frames()) continue;
    EXPECT_NE(loop.stopped({part}, first), Touch::kYes) << first;
  }
}

/// The certified clearance of every stop that was told is none that samples contradict, and hardly smaller.
void checkStops(const FrameByFrame& loop, const tune::TunedRecording& tuned, double limit) {
  for (const auto& [frame, sampled] : loop.stops())
    for (const tune::PartClearance& p : tuned.pass.parts) {
      const Sampled& s = sampled[humanmodel::index(*humanmodel::parsePart(p.part))];
      if (s.measured == kInfinity) continue;
      const double least = std::min(s.certain, limit + tune::BrakingClearance::kExact);
      EXPECT_LE(p.track.braking[frame], s.measured + FrameByFrame::kPath) << p.part << " " << frame;
      EXPECT_GE(p.track.braking[frame], least - FrameByFrame::kTolerance - FrameByFrame::kSearch)
          << p.part << " " << frame;
    }
}

void compare(const MarginClip& clip, Agreement& agreement) {
  SCOPED_TRACE(clip.name);
  const ScratchFolder folder;
  const auto session = clip.open(folder);
  const tune::TuneOptions options = clip.tune();
  const tune::TunedRecording tuned = tune::tuneRecording(*session, options, clip.run(), clip.name);
  FrameByFrame loop(*session,
                    {clip.braking.reaction_time, clip.braking.deceleration, clip.limit, clip.restart_time},
                    clip.run());
  ASSERT_EQ(loop.frames(), tuned.frames);
  FrameByFrame::Parts all;
  for (const tune::PartClearance& p : tuned.pass.parts) {
    all.push_back(*humanmodel::parsePart(p.part));
    // The same frames, seen twice.
    for (std::size_t i = 0; i < loop.frames(); ++i)
      ASSERT_EQ(p.track.clearance[i], loop.clearance({all.back()}, i)) << p.part << " " << i;
  }
  checkBeginning(loop, tuned, all, options.margins());
  for (const tune::MarginRow& row : tune::marginTable({tuned}, kMargins, options).rows) {
    const FrameByFrame::Parts parts =
        row.part == tune::kWholeBody ? all : FrameByFrame::Parts{*humanmodel::parsePart(row.part)};
    const std::size_t first = firstJudged(tuned, parts, options.margins());
    if (first == loop.frames()) continue;
    const FrameByFrame::Judged judged = loop.judge(parts, row.margin, first);
    const margin::MarginOutcome& o = row.outcome;
    const std::string where = row.part + " at " + std::to_string(row.margin);
    EXPECT_EQ(o.stops, judged.stops) << where;
    EXPECT_NEAR(o.stopped_time, judged.stopped_time, kRounding) << where;
    EXPECT_TRUE(judged.false_stops.holdsSafely(o.false_stops))
        << where << ": " << o.false_stops << ", " << judged.false_stops.safe_least << " to "
        << judged.false_stops.safe_most;
    EXPECT_TRUE(judged.missed_stops.holdsSafely(o.missed_stops))
        << where << ": " << o.missed_stops << ", " << judged.missed_stops.safe_least << " to "
        << judged.missed_stops.safe_most;
    ++agreement.rows;
    const bool exact = judged.false_stops.exact() && judged.missed_stops.exact();
    agreement.exact += exact;
    agreement.safer +=
        exact && !(judged.false_stops.holds(o.false_stops) && judged.missed_stops.holds(o.missed_stops));
    agreement.stops += o.stops;
    agreement.false_stops += o.false_stops;
    agreement.missed_stops += o.missed_stops;
  }
  checkStops(loop, tuned, clip.limit);
}

/// Over all clips of a kind. They tell margins apart, and few decisions are left to tolerances.
void compareAll(const std::vector<MarginClip>& clips) {
  Agreement a;
  for (const MarginClip& clip : clips) compare(clip, a);
  EXPECT_GT(a.stops, 50);
  EXPECT_GT(a.false_stops, 20);
  EXPECT_GT(a.missed_stops, 20);
  EXPECT_GT(static_cast<double>(a.exact), 0.9 * static_cast<double>(a.rows));
  EXPECT_LT(static_cast<double>(a.safer), 0.02 * static_cast<double>(a.exact));
  std::cout << clips.size() << " clips, " << a.rows << " rows, " << a.exact << " without tolerance, of them "
            << a.safer << " safer; " << a.stops << " stops, " << a.false_stops << " false, " << a.missed_stops
            << " missed\n";
}

TEST(MarginsAgainstClosedLoop, AgreeForWalkingPeople) {
  ASSERT_EQ(walkingClips().size(), 8u);
  compareAll(walkingClips());
}

TEST(MarginsAgainstClosedLoop, AgreeForReachingPeople) {
  ASSERT_EQ(reachingClips().size(), 6u);
  compareAll(reachingClips());
}

TEST(MarginsAgainstClosedLoop, AgreeForShippedRobots) {
  ASSERT_EQ(robotClips().size(), 6u);
  compareAll(robotClips());
}

TEST(MarginsAgainstClosedLoop, AgreeForRealCaptures) {
  const std::vector<MarginClip> clips = capturedClips();
  if (clips.empty()) GTEST_SKIP() << debianBvh("Boxing_Toes.bvh");
  compareAll(clips);
}

}  // namespace closed_loop_test
}  // namespace abstand::testing

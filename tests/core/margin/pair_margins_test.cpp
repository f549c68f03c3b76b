#include "core/margin/pair_margins.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.hpp"
#include "core/margin/safe_margin.hpp"
#include "tests/core/margin/naive_outcome.hpp"
#include "tests/core/margin/same_outcome.hpp"

namespace abstand::margin {
namespace pair_margins_test {

/// Clearances of some pairs over one recording, with stretches far away, near, inside and not seen.
struct PairTracks {
  std::vector<ClearanceTrack> of;
  std::vector<std::vector<double>> robot_speed, person_speed;

  std::size_t frames() const { return of.front().frames(); }
  PairFrame frame(std::size_t i, std::vector<double> (&lists)[3]) const {
    PairFrame frame{of.front().t[i], {}, {}, {}, kInfinity, kInfinity};
    for (auto& list : lists) list.clear();
    for (std::size_t p = 0; p < of.size(); ++p) {
      lists[0].push_back(of[p].clearance[i]);
      lists[1].push_back(robot_speed[p][i]);
      lists[2].push_back(person_speed[p][i]);
      frame.between = std::min(frame.between, of[p].between[i]);
      frame.braking = std::min(frame.braking, of[p].braking[i]);
    }
    frame.clearance = lists[0], frame.robot_speed = lists[1], frame.person_speed = lists[2];
    return frame;
  }
};

PairTracks tracksOf(std::uint32_t seed, std::size_t pairs, int frames) {
  std::mt19937 random(seed);
  std::normal_distribution<double> step(0.0, 0.03);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  PairTracks tracks;
  for (std::size_t p = 0; p < pairs; ++p) {
    ClearanceTrack track;
    std::vector<double> robot, person;
    double c = 0.8;
    for (int i = 0; i < frames; ++i) {
      c = std::clamp(c + step(random), -0.1, 2.0);
      track.t.push_back(0.01 * i);
      track.clearance.push_back(uniform(random) < 0.001 ? -kInfinity : c);
      track.between.push_back(uniform(random) < 0.005 ? c - 0.3 : c - 0.005);
      track.braking.push_back(uniform(random) < 0.05 ? c - 0.4 : kInfinity);
      robot.push_back(4.0 * uniform(random) - 2.0);
      person.push_back(4.0 * uniform(random) - 2.0);
    }
    track.between.back() = kInfinity;
    tracks.of.push_back(std::move(track));
    tracks.robot_speed.push_back(std::move(robot));
    tracks.person_speed.push_back(std::move(person));
  }
  return tracks;
}

std::vector<MarginOutcome> outcomesOf(const PairTracks& tracks,
                                      const std::vector<std::vector<PairMargin>>& sets,
                                      const MarginOptions& options) {
  PairMarginSets all(sets, options);
  std::vector<double> lists[3];
  for (std::size_t i = 0; i < tracks.frames(); ++i) all.add(tracks.frame(i, lists));
  return all.finish();
}

/// The frames as one set sees them: inside where some pair is within its own margin.
std::vector<MarginFrame> framesOf(const PairTracks& tracks, const std::vector<PairMargin>& set) {
  std::vector<MarginFrame> frames;
  std::vector<double> lists[3];
  for (std::size_t i = 0; i < tracks.frames(); ++i) {
    const PairFrame frame = tracks.frame(i, lists);
    MarginFrame all{frame.t, false, kInfinity, frame.between, frame.braking};
    for (std::size_t p = 0; p < set.size(); ++p) {
      const double robot = std::max(0.0, tracks.robot_speed[p][i]),
                   person = std::max(0.0, tracks.person_speed[p][i]);
      const double needed = set[p].margin + set[p].robot_time * robot + set[p].person_time * person;
      all.inside = all.inside || tracks.of[p].clearance[i] < needed;
      all.clearance = std::min(all.clearance, tracks.of[p].clearance[i]);
    }
    frames.push_back(all);
  }
  return frames;
}

/// Sets without and with terms of speed, in no order.
std::vector<std::vector<PairMargin>> randomSets(std::uint32_t seed, std::size_t pairs, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<std::vector<PairMargin>> sets;
  for (int s = 0; s < count; ++s) {
    sets.emplace_back();
    const double most = s % 4 == 3 ? 3.0 : 0.9, time = s % 2 == 0 ? 0.0 : 0.2;
    for (std::size_t p = 0; p < pairs; ++p)
      sets.back().push_back({most * uniform(random), time * uniform(random), time * uniform(random)});
  }
  return sets;
}

TEST(PairMarginSets, MatchDefinitionFrameByFrame) {
  for (const int frames : {1, 2, 63, 64, 65, 900})
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
      const PairTracks tracks = tracksOf(seed, 5, frames);
      const std::vector<std::vector<PairMargin>> sets = randomSets(seed, tracks.of.size(), 12);
      for (const MarginOptions& options : {MarginOptions{}, MarginOptions{0.05, 0.2}}) {
        const std::vector<MarginOutcome> outcomes = outcomesOf(tracks, sets, options);
        for (std::size_t s = 0; s < sets.size(); ++s) {
          SCOPED_TRACE(testing::Message() << frames << " frames, seed " << seed << ", set " << s);
          expectEqual(outcomes[s], naiveOutcome(framesOf(tracks, sets[s]), options));
        }
      }
    }
}

TEST(PairMarginSets, UniformMarginMatchesLeastTrack) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const PairTracks tracks = tracksOf(seed, 3, 700);
    const ClearanceTrack* all[] = {&tracks.of[0], &tracks.of[1], &tracks.of[2]};
    const ClearanceTrack least = leastOf(all);
    std::vector<std::vector<PairMargin>> sets;
    std::vector<double> margins;
    for (double m = 0.0; m < 2.2; m += 0.07) {
      margins.push_back(m);
      sets.push_back(std::vector<PairMargin>(3, {m, 0.0, 0.0}));
    }
    const std::vector<MarginOutcome> together = outcomesOf(tracks, sets, {}),
                                     of_smallest = outcomes(least, margins, {});
    for (std::size_t s = 0; s < sets.size(); ++s) {
      expectEqual(together[s], outcome(least, margins[s], {}));
      expectEqual(of_smallest[s], together[s]);
    }
  }
}

TEST(PairMarginSets, StopIfAnyPairIsInsideItsMargin) {
  PairTracks tracks;
  tracks.of.push_back({{0, 1, 2, 3}, {0.5, 0.3, 0.3, 0.5}, {0.3, 0.3, 0.3, kInfinity}, {0.2, 0.2, 0.2, 0.2}});
  tracks.of.push_back(
      {{0, 1, 2, 3}, {0.9, 0.9, 0.6, 0.9}, {0.6, 0.6, 0.6, kInfinity}, {0.5, 0.5, -0.1, 0.5}});
  tracks.robot_speed = tracks.person_speed = {{0, 0, 0, 0}, {0, 0, 0, 0}};
  const std::vector<MarginOutcome> got = outcomesOf(
      tracks, {{{0.2, 0, 0}, {0.5, 0, 0}}, {{0.4, 0, 0}, {0.5, 0, 0}}, {{0.2, 0, 0}, {0.7, 0, 0}}}, {});
  EXPECT_EQ(got[0].stops, 0);
  EXPECT_EQ(got[1].stops, 1);
  EXPECT_EQ(got[1].missed_stops, 0);
  EXPECT_EQ(got[1].stopped_time, 2.0);
  EXPECT_EQ(got[2].stops, 1);
  EXPECT_EQ(got[2].missed_stops, 1);
  EXPECT_EQ(got[2].stopped_time, 1.0);
}

TEST(PairMarginSets, ReportStops) {
  const PairTracks tracks = tracksOf(7, 3, 500);
  PairMarginSets sets({{{0.3, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, {});
  long stops[2] = {0, 0}, missed[2] = {0, 0};
  sets.onStop([&](std::size_t set, const Stop& stop) {
    ++stops[set];
    missed[set] += stop.missed;
    EXPECT_LE(stop.begin, stop.end);
  });
  std::vector<double> lists[3];
  for (std::size_t i = 0; i < tracks.frames(); ++i) sets.add(tracks.frame(i, lists));
  const std::vector<MarginOutcome> outcomes = sets.finish();
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(stops[s], outcomes[s].stops);
    EXPECT_EQ(missed[s], outcomes[s].missed_stops - outcomes[s].unseen);
  }
  EXPECT_GT(stops[0], 0);
}

TEST(PairMarginSets, RejectInvalidSets) {
  EXPECT_THROW(PairMarginSets({}, {}), UsageError);
  EXPECT_THROW(PairMarginSets({{{0.1, 0, 0}}, {}}, {}), UsageError);
  EXPECT_THROW(PairMarginSets({{{-0.1, 0, 0}}}, {}), UsageError);
  EXPECT_THROW(PairMarginSets({{{0.1, kInfinity, 0}}}, {}), UsageError);
}

TEST(SafeMarginWatch, MatchesSmallestSafeMarginFromFirstJudgedFrame) {
  const MarginOptions options{0.01, 0.0};
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const PairTracks tracks = tracksOf(200 + seed, 1, 300);
    const ClearanceTrack& track = tracks.of.front();
    SafeMarginWatch watch(options);
    for (std::size_t i = 0; i < track.frames(); ++i)
      watch.add(track.clearance[i], track.between[i], track.braking[i]);
    const std::size_t first = firstJudgedFrame(track, options);
    const SafeMargin expected = smallestSafeMargin(from(track, first), options);
    EXPECT_TRUE(watch.judged());
    EXPECT_EQ(watch.value().decided, expected.decided);
    EXPECT_EQ(watch.value().margin, expected.margin);
    EXPECT_EQ(watch.value().sampling, expected.sampling);
    if (expected.decided) {
      EXPECT_EQ(watch.value().frame, expected.frame + first);
    }
  }
}

}  // namespace pair_margins_test
}  // namespace abstand::margin

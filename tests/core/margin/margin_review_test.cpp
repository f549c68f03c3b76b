#include "core/margin/margin_review.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "core/margin/outcome_stream.hpp"
#include "core/margin/safe_margin.hpp"
#include "tests/core/margin/same_outcome.hpp"
#include "tests/core/margin/stored_pairs.hpp"

namespace abstand::margin {
namespace margin_review_test {

using Kind = ReviewEvent::Kind;

std::vector<ReviewEvent> eventsOf(const MarginReview& review, std::size_t part, Kind kind) {
  std::vector<ReviewEvent> events;
  for (const ReviewEvent& event : review.events)
    if (event.part == part && event.kind == kind) events.push_back(event);
  return events;
}

/// Frame by frame and pair by pair, without a store.
struct Reference {
  const StoredPairs& pairs;
  std::span<const double> margins;

  double marginOf(std::size_t pair) const {
    const auto [part, link] = pairs.layout->pairs[pair];
    return margins[pairs.layout->parts[part].object] + margins[pairs.layout->links[link].object];
  }
  bool inside(std::size_t frame, std::size_t part, double factor = 1.0) const {
    for (std::size_t p = 0; p < pairs.pairs(); ++p)
      if (pairs.layout->pairs[p].part == part && pairs.at(frame, p).clearance < factor * marginOf(p))
        return true;
    return false;
  }
  MarginOutcome outcome(const MarginOptions& options) const {
    std::vector<ClearanceTrack> tracks;
    std::size_t first = 0;
    for (std::size_t k = 0; k < pairs.layout->parts.size(); ++k) {
      tracks.push_back(pairs.track(k));
      first = std::max(first, firstJudgedFrame(tracks.back(), options));
    }
    if (first >= pairs.t.size()) return {};
    OutcomeStream stream(options);
    for (std::size_t i = first; i < pairs.t.size(); ++i) {
      MarginFrame all{pairs.t[i], false, kInfinity, kInfinity, kInfinity};
      for (std::size_t k = 0; k < tracks.size(); ++k) {
        all.inside = all.inside || inside(i, k);
        all.clearance = std::min(all.clearance, tracks[k].clearance[i]);
        all.between = std::min(all.between, tracks[k].between[i]);
        all.braking = std::min(all.braking, tracks[k].braking[i]);
      }
      stream.add(all);
    }
    return stream.finish();
  }
};

/// Margins of `parts` parts and then of links. Links differ by up to `spread` (m).
std::vector<double> someMargins(std::mt19937& random, std::size_t parts, std::size_t links, double spread) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> margins;
  for (std::size_t k = 0; k < parts; ++k) margins.push_back(0.6 * uniform(random));
  for (std::size_t l = 0; l < links; ++l) margins.push_back(0.05 + spread * uniform(random));
  return margins;
}

TEST(MarginReview, MatchesFrameByFrameOutcome) {
  for (const std::size_t frames : {1u, 256u, 257u, 1400u})
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
      const StoredPairs pairs = storedPairs(seed, 4, 3, frames);
      std::mt19937 random(seed);
      for (const MarginOptions& options : {MarginOptions{}, MarginOptions{0.03125, 0.2}}) {
        const ClearanceStore store = pairs.store(options.limit);
        for (const double spread : {0.0, 0.0, 0.2, ClearanceChunk::kBeside}) {
          const std::vector<double> margins = someMargins(random, 4, 3, spread);
          SCOPED_TRACE(testing::Message() << frames << " frames, seed " << seed << ", spread " << spread);
          const MarginReview result = review(store, margins, {options, 2.0});
          expectEqual(result.outcome, Reference{pairs, margins}.outcome(options));
        }
      }
    }
}

TEST(MarginReview, IsConservativeWhereLinkMarginsDiffer) {
  const StoredPairs pairs = storedPairs(4, 3, 3, 900);
  std::mt19937 random(4);
  for (int n = 0; n < 20; ++n) {
    const std::vector<double> margins = someMargins(random, 3, 3, 0.8);
    const Reference reference{pairs, margins};
    const MarginReview result = review(pairs.store(), margins, {});
    std::vector<bool> inside(3 * 900, false);
    for (const ReviewEvent& event : result.events)
      if (event.kind == Kind::kIntrusion)
        for (std::size_t i = event.begin; i < event.end; ++i) inside[event.part * 900 + i] = true;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 900; ++i)
        if (reference.inside(i, k)) {
          EXPECT_TRUE(inside[k * 900 + i]) << "part " << k << ", frame " << i;
        }
  }
}

TEST(MarginReview, FindsIntrusionsOfEachPart) {
  for (std::uint32_t seed = 20; seed < 26; ++seed) {
    const StoredPairs pairs = storedPairs(seed, 3, 2, 1300);
    const ClearanceStore store = pairs.store();
    for (const double margin : {0.0, 0.125, 0.5, 3.0}) {
      const MarginReview result = review(store, std::vector<double>{margin, margin, margin, 0.0, 0.0}, {});
      for (std::size_t k = 0; k < 3; ++k) {
        const ClearanceTrack track = pairs.track(k);
        const std::vector<Intrusion> expected = intrusions(track, margin, {});
        const std::vector<ReviewEvent> found = eventsOf(result, k, Kind::kIntrusion);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t n = 0; n < found.size(); ++n) {
          EXPECT_EQ(found[n].begin, expected[n].begin);
          EXPECT_EQ(found[n].end, expected[n].end);
          EXPECT_EQ(found[n].t0, track.t[expected[n].begin]);
          EXPECT_EQ(found[n].t1, track.t[std::min<std::size_t>(expected[n].end, 1299)]);
          EXPECT_EQ(found[n].min_clearance, expected[n].min_clearance);
          EXPECT_EQ(found[n].braking, expected[n].braking);
          EXPECT_EQ(found[n].false_stop, expected[n].false_stop);
          EXPECT_EQ(found[n].missed, expected[n].missed);
        }
        std::vector<std::size_t> between;
        for (std::size_t i = 0; i < 1300; ++i)
          if (track.clearance[i] >= margin && track.between[i] <= 0.0) between.push_back(i);
        const std::vector<ReviewEvent> unseen = eventsOf(result, k, Kind::kBetweenFrames);
        ASSERT_EQ(unseen.size(), between.size());
        for (std::size_t n = 0; n < unseen.size(); ++n) EXPECT_EQ(unseen[n].begin, between[n]);
      }
    }
  }
}

TEST(MarginReview, FindsNearMisses) {
  for (std::uint32_t seed = 40; seed < 46; ++seed) {
    const StoredPairs pairs = storedPairs(seed, 3, 2, 1300);
    const std::vector<double> margins{0.05, 0.2, 0.3, 0.02, 0.1};
    const Reference reference{pairs, margins};
    const MarginReview result = review(pairs.store(), margins, {});
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<std::pair<std::size_t, std::size_t>> expected, found;
      for (std::size_t i = 0; i < 1300; ++i) {
        if (!reference.inside(i, k, 2.0)) continue;
        const std::size_t begin = i;
        bool inside = false;
        for (; i < 1300 && reference.inside(i, k, 2.0); ++i) inside = inside || reference.inside(i, k);
        if (!inside) expected.emplace_back(begin, i);
      }
      for (const ReviewEvent& event : eventsOf(result, k, Kind::kNear)) {
        found.emplace_back(event.begin, event.end);
        EXPECT_EQ(event.min_clearance, pairs.track(k).clearance[event.nearest]);
      }
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(MarginReviewer, IncrementalReviewMatchesFullReview) {
  const StoredPairs pairs = storedPairs(9, 4, 3, 1300);
  const ClearanceStore all = pairs.store();
  ClearanceStore store(pairs.layout);
  MarginReviewer reviewer;
  std::mt19937 random(9);
  std::vector<double> margins = someMargins(random, 4, 3, 0.1);
  std::size_t chunks = 0;
  for (int n = 0; n < 60; ++n) {
    if (n % 12 == 0 && chunks < all.chunks().size()) store.add(all.chunks()[chunks++]);
    if (n % 5) margins[random() % margins.size()] = 0.001 * static_cast<double>(random() % 500);
    const MarginReview& kept = reviewer.review(store, margins, {});
    const MarginReview fresh = review(store, margins, {});
    expectEqual(kept.outcome, fresh.outcome);
    ASSERT_EQ(kept.events.size(), fresh.events.size());
    for (std::size_t i = 0; i < fresh.events.size(); ++i) {
      EXPECT_EQ(kept.events[i].begin, fresh.events[i].begin);
      EXPECT_EQ(kept.events[i].part, fresh.events[i].part);
      EXPECT_EQ(kept.events[i].kind, fresh.events[i].kind);
    }
  }
}

TEST(MarginReview, OrdersEventsByTime) {
  const MarginReview result =
      review(storedPairs(1, 3, 2, 900).store(), std::vector<double>{0.3, 0.3, 0.3, 0.0, 0.0}, {});
  ASSERT_FALSE(result.events.empty());
  EXPECT_TRUE(std::is_sorted(result.events.begin(), result.events.end(), [](const auto& a, const auto& b) {
    return std::tie(a.t0, a.part) < std::tie(b.t0, b.part);
  }));
  for (const ReviewEvent& event : result.events) {
    EXPECT_LE(event.t0, event.t_nearest);
    EXPECT_LE(event.t_nearest, event.t1);
  }
}

TEST(MarginReview, IsEmptyWithoutFrames) {
  const ClearanceStore store(storedPairs(1, 2, 2, 1).layout);
  const MarginReview result = review(store, std::vector<double>{0.1, 0.1, 0.1, 0.1}, {});
  EXPECT_TRUE(result.events.empty());
  EXPECT_EQ(result.outcome.time, 0.0);
}

}  // namespace margin_review_test
}  // namespace abstand::margin

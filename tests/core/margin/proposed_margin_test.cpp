// Proposals and outcomes of parts over a store are those of their tracks.
#include "core/margin/proposed_margin.hpp"

#include <gtest/gtest.h>

#include "core/margin/part_curve.hpp"
#include "tests/core/margin/same_outcome.hpp"
#include "tests/core/margin/stored_pairs.hpp"

namespace abstand::margin {
namespace proposed_margin_test {

TEST(ProposedMargin, IsSmallestSafeMarginPerPart) {
  int decided = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const StoredPairs pairs = storedPairs(seed, 3, 2, 700);
    const ClearanceStore store = pairs.store();
    const auto proposals = proposeMargins(store, {});
    ASSERT_EQ(proposals.size(), 3u);
    for (std::size_t part = 0; part < 3; ++part) {
      const ClearanceTrack track = pairs.track(part);
      const std::size_t first = firstJudgedFrame(track, {});
      ASSERT_EQ(proposals[part].judged, first < track.frames());
      if (first >= track.frames()) continue;
      const SafeMargin safe = smallestSafeMargin(from(track, first), {});
      ASSERT_EQ(proposals[part].decided_by.has_value(), safe.decided) << seed;
      if (!safe.decided) continue;
      ++decided;
      EXPECT_EQ(proposals[part].margin, roundedUpMargin(safe.margin)) << seed;
      EXPECT_EQ(proposals[part].decided_by->t, track.t[first + safe.frame]) << seed;
    }
  }
  EXPECT_GT(decided, 0);
}

TEST(PartOutcome, MatchesOutcomeOfTrack) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const StoredPairs pairs = storedPairs(seed, 3, 2, 700);
    const ClearanceStore store = pairs.store();
    for (std::size_t part = 0; part < 3; ++part) {
      const ClearanceTrack track = pairs.track(part);
      const ClearanceTrack judged = from(track, firstJudgedFrame(track, {}));
      if (judged.frames() == 0) continue;
      for (const double margin : {0.0, 0.03, 0.125, 0.4}) {
        std::vector<double> margins(5, 0.0);
        margins[part] = margin;
        const auto of = partMargins(store.layout(), margins);
        expectEqual(partOutcome(store, part, of[part], {}), outcome(judged, margin, {}));
      }
    }
  }
}

}  // namespace proposed_margin_test
}  // namespace abstand::margin

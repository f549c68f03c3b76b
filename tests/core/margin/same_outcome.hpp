// Two outcomes, bit by bit.
#pragma once

#include <gtest/gtest.h>

#include "core/margin/margin_outcome.hpp"

namespace abstand::margin {

inline void expectEqual(const MarginOutcome& a, const MarginOutcome& b) {
  EXPECT_EQ(a.stops, b.stops);
  EXPECT_EQ(a.false_stops, b.false_stops);
  EXPECT_EQ(a.missed_stops, b.missed_stops);
  EXPECT_EQ(a.unseen, b.unseen);
  EXPECT_EQ(a.stopped_time, b.stopped_time);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.min_clearance, b.min_clearance);
  EXPECT_EQ(a.lead_time, b.lead_time);
}

}  // namespace abstand::margin

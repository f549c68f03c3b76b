// Which times of files are those of a clock.
#pragma once

namespace abstand {

/// s: times from the first one on, and below the second, count from 1970 UTC: 2001 to the year 5138. Times
/// that count from the start of a recording are smaller, for it lasts less than 31 years.
inline constexpr double kEarliestClock = 1e9, kLatestClock = 1e11;

}  // namespace abstand

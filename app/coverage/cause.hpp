// Why a point of a surface is not seen.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace abstand::coverage {

/// In the order in which they are examined. A point beyond the image or the range counts there even if
/// something is in front of it.
enum class Cause : std::uint8_t {
  kSeen,
  kUnknown,      ///< the recording does not show where the part is
  kOutOfImage,   ///< beside the image or behind the camera
  kOutOfRange,   ///< nearer or farther than the sensor measures
  kRobot,        ///< a robot is in front
  kThing,        ///< another object of the scene is in front
  kSelf,         ///< the same person, or what that person holds, is in front
  kOtherPerson,  ///< somebody else is in front
};
inline constexpr std::size_t kCauses = 8;

/// As in JSON and tables.
inline constexpr std::array<std::string_view, kCauses> kCauseNames{
    "seen", "unknown", "out_of_image", "out_of_range", "robot", "thing", "self", "other_person"};

/// Shares of a surface by cause; their sum is 1.
using Shares = std::array<float, kCauses>;

inline float shareOf(const Shares& shares, Cause cause) { return shares[static_cast<std::size_t>(cause)]; }

}  // namespace abstand::coverage

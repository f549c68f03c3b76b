// Reasons and responses of stops.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::safety {

enum class StopReason : std::uint8_t {
  kDistance,    ///< a distance is below its limit (m)
  kSeparation,  ///< the speed exceeds what the separation permits; value and limit in m/s
  kEnergy,      ///< a link's kinetic energy exceeds what the repulsive potential can absorb (J)
  kStaleInput,  ///< joint values are older than allowed (s)
  kLostPerson,  ///< a person's pose is older than allowed (s), or unreliable
  kLostLink,    ///< the connection to the robot is lost
  kTorque,      ///< a torque was limited (N m or N)
  kJointSpeed,  ///< a joint is faster than allowed (rad/s or m/s)
  kSpeedBound,  ///< an object exceeded the speed bound that certificates rely on (m/s)
  kUser,
  kBraking  ///< while braking, a person could come nearer than allowed (m)
};
inline constexpr std::size_t kStopReasons = 11;

/// In ascending order. kSlow: reduced speed. kProtective: controlled braking; may resume when the reason is
/// gone. kEmergency: brakes engage; only a person can release it.
enum class StopResponse : std::uint8_t { kNone, kSlow, kProtective, kEmergency };
inline constexpr std::size_t kStopResponses = 4;

/// Name in files and log lines: "distance", "lost person"; in files with `_` for blanks.
std::string_view reasonName(StopReason reason);
std::string_view reasonKey(StopReason reason);
std::string_view responseName(StopResponse response);
std::optional<StopResponse> parseResponse(std::string_view text);
/// Names of all responses, in ascending order.
std::vector<std::string> responseNames();

/// A present cause, and the pair or joint it refers to (-1: none).
struct StopCause {
  StopReason reason{StopReason::kUser};
  double value{kNaN}, limit{kNaN};  ///< measured and allowed value, in the reason's unit
  int pair{-1};                     ///< index of a pair,
  int joint{-1};                    ///< or of a joint
};

/// Response to each reason.
struct StopPolicy {
  std::array<StopResponse, kStopReasons> response{
      StopResponse::kProtective, StopResponse::kSlow,       StopResponse::kEmergency,
      StopResponse::kProtective, StopResponse::kProtective, StopResponse::kProtective,
      StopResponse::kNone,       StopResponse::kProtective, StopResponse::kProtective,
      StopResponse::kEmergency,  StopResponse::kProtective};
  StopResponse of(StopReason reason) const { return response[static_cast<std::size_t>(reason)]; }
};

}  // namespace abstand::safety

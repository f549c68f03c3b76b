// Why a robot slows down or stops, and what it does then.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/math/transform.hpp"

namespace abstand::safety {

enum class StopReason : std::uint8_t {
  kDistance,    ///< a distance is below its limit (m)
  kSeparation,  ///< the speed is more than the separation permits; value and limit in m/s
  kEnergy,      ///< a link's kinetic energy is more than the potential in front of it can take (J)
  kStaleInput,  ///< joint values are older than allowed (s)
  kLostPerson,  ///< a person's pose is older than allowed (s), or no longer trusted
  kLostLink,    ///< the connection to the robot is gone
  kTorque,      ///< a torque was limited (N m or N)
  kJointSpeed,  ///< a joint is faster than allowed (rad/s or m/s)
  kSpeedBound,  ///< an object broke the bound on its speed that certificates rest on (m/s)
  kUser,
  kBraking  ///< on the way to a standstill a person could come nearer than allowed (m)
};
inline constexpr std::size_t kStopReasons = 11;

/// In rising order. kSlow: the speed is scaled down. kProtective: the robot brakes under control and stays in
/// control, may go on when the reason is gone. kEmergency: brakes engage; only a person may let it go on.
enum class StopResponse : std::uint8_t { kNone, kSlow, kProtective, kEmergency };
inline constexpr std::size_t kStopResponses = 4;

/// As in files and log lines: "distance", "lost person"; with `_` for blanks in files.
std::string_view reasonName(StopReason reason);
std::string_view reasonKey(StopReason reason);
std::string_view responseName(StopResponse response);
std::optional<StopResponse> parseResponse(std::string_view text);

/// Who or what a cause is about; -1: nothing in particular.
struct StopCause {
  StopReason reason{StopReason::kUser};
  double value{kNaN}, limit{kNaN};  ///< what was found and what was allowed, in the reason's unit
  int pair{-1};                     ///< index of a pair,
  int joint{-1};                    ///< or of a joint
};

/// What is done for which reason.
struct StopPolicy {
  std::array<StopResponse, kStopReasons> response{
      StopResponse::kProtective, StopResponse::kSlow,       StopResponse::kEmergency,
      StopResponse::kProtective, StopResponse::kProtective, StopResponse::kProtective,
      StopResponse::kNone,       StopResponse::kProtective, StopResponse::kProtective,
      StopResponse::kEmergency,  StopResponse::kProtective};
  StopResponse of(StopReason reason) const { return response[static_cast<std::size_t>(reason)]; }
};

}  // namespace abstand::safety

// What a user should know of a scene before believing what it shows.
#pragma once

#include <cstdint>
#include <string>

namespace abstand::scene {

/// When a reservation fails `check`.
enum class Severity : std::uint8_t {
  kNote,    ///< never: a person who reads the verdict should know it
  kStrict,  ///< with --strict: the distances may be wrong, or are those of a guess
  kAlways   ///< something was not known at all, and unknown is never safe
};

/// A reservation about a scene that is open, or another remark about it.
struct SceneNote {
  std::string kind;  ///< as of Reservation (app/run/reservations.hpp), or "remark"
  std::string text;  ///< one line
  Severity fails{Severity::kNote};
};

}  // namespace abstand::scene

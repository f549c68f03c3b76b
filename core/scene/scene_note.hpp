// Remarks about a scene for its user.
#pragma once

#include <cstdint>
#include <string>

namespace abstand::scene {

/// Whether a reservation makes `check` fail.
enum class Severity : std::uint8_t {
  kNote,    ///< never: information for the reader of the verdict
  kStrict,  ///< with --strict: the distances may be wrong, or are based on a guess
  kAlways   ///< always: something is unknown, and unknown is never safe
};

/// A reservation about a scene that is open, or another remark about it.
struct SceneNote {
  std::string kind;  ///< as of Reservation (app/run/reservations.hpp), or "remark"
  std::string text;  ///< one line
  Severity fails{Severity::kNote};
};

}  // namespace abstand::scene

// The fourteen rigid parts of a person: names, sides and hierarchy.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace abstand::humanmodel {

/// Parents precede their children, so iteration in this order builds a body from the torso outwards.
enum class BodyPart : std::uint8_t {
  kTorso,
  kHead,
  kBicepsLeft,
  kBicepsRight,
  kForearmLeft,
  kForearmRight,
  kHandLeft,
  kHandRight,
  kThighLeft,
  kThighRight,
  kCalfLeft,
  kCalfRight,
  kFootLeft,
  kFootRight,
  kCount
};
inline constexpr std::size_t kBodyPartCount = static_cast<std::size_t>(BodyPart::kCount);

/// A part without its side: left and right are equal.
enum class PartKind : std::uint8_t { kTorso, kHead, kBiceps, kForearm, kHand, kThigh, kCalf, kFoot, kCount };
inline constexpr std::size_t kPartKindCount = static_cast<std::size_t>(PartKind::kCount);

constexpr std::size_t index(BodyPart part) { return static_cast<std::size_t>(part); }
constexpr std::size_t index(PartKind kind) { return static_cast<std::size_t>(kind); }

constexpr PartKind kindOf(BodyPart part) {
  return static_cast<PartKind>(index(part) < 2 ? index(part) : index(part) / 2 + 1);
}

/// +1 left, -1 right, 0 for torso and head.
constexpr int sideOf(BodyPart part) { return index(part) < 2 ? 0 : (index(part) % 2 == 0 ? 1 : -1); }

/// The part that carries this one; nullopt for the torso.
std::optional<BodyPart> parentOf(BodyPart part);

/// Pairs that share a body joint, parent first: neck, shoulders, elbows, wrists, hips, knees and ankles.
const std::array<std::pair<BodyPart, BodyPart>, kBodyPartCount - 1>& adjacentParts();

/// "torso", "biceps_left", ... as in scene files.
std::string_view partName(BodyPart part);
/// Names of all parts, in their order.
std::span<const std::string_view, kBodyPartCount> partNames();
std::optional<BodyPart> parsePart(std::string_view name);

}  // namespace abstand::humanmodel

// Names and hierarchy of the fourteen parts.
#include "humanmodel/body_part.hpp"

namespace abstand::humanmodel {
namespace {

constexpr std::array<std::string_view, kBodyPartCount> kNames{
    "torso",      "head",       "biceps_left", "biceps_right", "forearm_left", "forearm_right", "hand_left",
    "hand_right", "thigh_left", "thigh_right", "calf_left",    "calf_right",   "foot_left",     "foot_right"};

constexpr auto kAdjacent = [] {
  using enum BodyPart;
  return std::array<std::pair<BodyPart, BodyPart>, kBodyPartCount - 1>{{
      {kTorso, kHead},
      {kTorso, kBicepsLeft},
      {kTorso, kBicepsRight},
      {kBicepsLeft, kForearmLeft},
      {kBicepsRight, kForearmRight},
      {kForearmLeft, kHandLeft},
      {kForearmRight, kHandRight},
      {kTorso, kThighLeft},
      {kTorso, kThighRight},
      {kThighLeft, kCalfLeft},
      {kThighRight, kCalfRight},
      {kCalfLeft, kFootLeft},
      {kCalfRight, kFootRight},
  }};
}();

}  // namespace

std::optional<BodyPart> parentOf(BodyPart part) {
  for (const auto& [parent, child] : kAdjacent)
    if (child == part) return parent;
  return std::nullopt;
}

const std::array<std::pair<BodyPart, BodyPart>, kBodyPartCount - 1>& adjacentParts() { return kAdjacent; }

std::string_view partName(BodyPart part) { return kNames[index(part)]; }

std::span<const std::string_view, kBodyPartCount> partNames() { return kNames; }

std::optional<BodyPart> parsePart(std::string_view name) {
  for (std::size_t i = 0; i < kBodyPartCount; ++i)
    if (kNames[i] == name) return static_cast<BodyPart>(i);
  return std::nullopt;
}

}  // namespace abstand::humanmodel

#include "app/cli/track_people.hpp"

#include <cmath>

#include "core/base/error.hpp"

namespace abstand::cli {

std::optional<bool> awayOf(const std::string& facing) {
  if (facing == "auto") return std::nullopt;
  if (facing == "camera" || facing == "away") return facing == "away";
  throw UsageError("--facing: found " + facing + ", expected camera, away or auto");
}

void addFacing(nlohmann::ordered_json& person, const Facing& facing) {
  person["facing"] = facing.away ? "away" : "camera";
  person["facing_ratio"] =
      std::isnan(facing.ratio) ? nlohmann::ordered_json() : nlohmann::ordered_json(facing.ratio);
}

nlohmann::ordered_json peopleJson(const ClipTrack& track) {
  auto people = nlohmann::ordered_json::array();
  for (const ClipPerson& p : track.people) {
    people.push_back({{"id", p.id},
                      {"tracked", p.found},
                      {"height_estimate", p.body.height},
                      {"residual_mm", 1e3 * p.residual}});
    addFacing(people.back(), p.facing);
  }
  return people;
}

}  // namespace abstand::cli

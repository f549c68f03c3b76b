#include "app/cli/track_people.hpp"

#include <cmath>

#include "app/cli/json_values.hpp"
#include "core/base/error.hpp"
#include "tracking/tracker/tracked_recording.hpp"

namespace abstand::cli {

std::optional<bool> awayOf(const std::string& facing) {
  if (facing == "auto") return std::nullopt;
  if (facing == "camera" || facing == "away") return facing == "away";
  throw UsageError("--facing: found " + facing + ", expected camera, away or auto");
}

void addFacing(nlohmann::ordered_json& person, const tracking::Facing& facing) {
  person["facing"] = facing.away ? "away" : "camera";
  person["facing_decided"] = facing.decided();
  person["facing_ratio"] =
      std::isnan(facing.ratio) ? nlohmann::ordered_json() : nlohmann::ordered_json(facing.ratio);
}

void addStature(nlohmann::ordered_json& person, const tracking::Stature& stature) {
  constexpr std::array kSources{"given", "measured", "interval"};
  const nlohmann::ordered_json unknown;
  person["height_estimate"] = stature.known() ? nlohmann::ordered_json(stature.used) : unknown;
  person["height_interval"] = stature.known() ? unknown : nlohmann::ordered_json(stature.interval);
  person["height_source"] = kSources[static_cast<std::size_t>(stature.source)];
  person["height_used"] = stature.used > 0.0 ? nlohmann::ordered_json(stature.used) : unknown;
}

namespace {

/// Things in the hands; `extent` (m) beyond the hand.
nlohmann::ordered_json heldJson(const tracking::ClipPerson& person) {
  auto held = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < person.held.size(); ++k)
    if (person.held[k] > 0)
      held.push_back({{"hand", k == 0 ? "left" : "right"},
                      {"images", person.held[k]},
                      {"extent", person.held_extent[k]}});
  return held;
}

}  // namespace

nlohmann::ordered_json peopleJson(const tracking::ClipTrack& track) {
  auto people = nlohmann::ordered_json::array();
  for (const tracking::ClipPerson& p : track.people) {
    people.push_back({{"id", p.id}, {"tracked", p.found}, {"residual_mm", 1e3 * p.residual}});
    addStature(people.back(), p.stature);
    addFacing(people.back(), p.facing);
    people.back()["held"] = heldJson(p);
    people.back()["warnings"] = tracking::trackWarnings(p);
  }
  return people;
}

nlohmann::ordered_json cameraJson(const std::string& name, const tracking::DepthFacts& facts,
                                  const tracking::CameraShare& share) {
  return {{"file", name},
          {"camera_reason", facts.camera_reason},
          {"images", share.images},
          {"images_with_people", share.people},
          {"moments_without", share.without},
          {"images_repeated", share.repeated},
          {"moved_at", numberOrNull(share.moved_at)},
          {"hung_at", numberOrNull(share.hung_at)},
          {"disagrees_since", numberOrNull(share.apart_since)},
          {"disagreement", share.apart},
          {"late_since", numberOrNull(share.late_since)},
          {"late", share.late}};
}

std::string cameraText(std::size_t number, const std::string& name, const tracking::CameraShare& share,
                       std::size_t times) {
  return format("camera %zu: %s, %zu images, people in %zu; no image at %zu of %zu times", number,
                name.c_str(), share.images, share.people, share.without, times);
}

int endBeforeFound(const CommandLine& line, std::size_t images) {
  line.print({{"frames", images},
              {"tracked", 0},
              {"people", nlohmann::ordered_json::array()},
              {"interrupted", true}},
             format("interrupted after %zu images, before the person was found\n", images));
  return kInterrupted;
}

}  // namespace abstand::cli

#include "app/tune/watched_pairs.hpp"

#include <map>

#include "humanmodel/body_part.hpp"

namespace abstand::tune {

std::vector<WatchedPair> watchedPairs(const session::Session& session) {
  const scene::Scene& scene = session.scene();
  std::map<std::size_t, session::HumanDriver::Body> part_of;
  std::map<std::size_t, std::size_t> robot_of;
  for (const auto& human : session.humans())
    for (const session::HumanDriver::Body& body : human->bodies()) part_of.emplace(body.object.index(), body);
  for (std::size_t r = 0; r < session.mechanisms().size(); ++r)
    for (const auto& link : session.mechanisms()[r]->links())
      if (link.object) robot_of[link.object->index()] = r;
  std::vector<WatchedPair> watched;
  for (std::size_t i = 0; i < scene.pairs().size(); ++i) {
    const std::size_t a = scene.pairs()[i].a.index(), b = scene.pairs()[i].b.index();
    const bool part_is_a = part_of.count(a) > 0;
    const auto part = part_of.find(part_is_a ? a : b);
    const auto robot = robot_of.find(part_is_a ? b : a);
    if (part == part_of.end() || robot == robot_of.end()) continue;
    watched.push_back({PairId(static_cast<std::uint32_t>(i)), part->first, robot->first, robot->second,
                       part_is_a, part->second.part, part->second.tool});
  }
  return watched;
}

std::string partText(const std::string& part, const std::string& tool) {
  return tool.empty() ? part : part + " (" + tool + ")";
}

void pauseOthers(const std::vector<WatchedPair>& watched, session::Session& session) {
  scene::Scene& scene = session.scene();
  std::vector<bool> asked(scene.pairs().size(), false);
  for (const WatchedPair& pair : watched) asked[pair.id.index()] = true;
  for (std::size_t i = 0; i < asked.size(); ++i)
    scene.setPaused(PairId(static_cast<std::uint32_t>(i)), !asked[i], 0.0);
}

}  // namespace abstand::tune

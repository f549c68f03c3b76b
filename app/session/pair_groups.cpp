#include "app/session/pair_groups.hpp"

#include <algorithm>
#include <map>

namespace abstand::session {
namespace {

constexpr const char* kRest = "rest";

using PairIndex = std::map<std::pair<std::string, std::string>, PairId>;

PairIndex indexOf(const scene::Scene& scene) {
  PairIndex index;
  for (std::uint32_t i = 0; i < scene.pairs().size(); ++i) {
    const scene::Pair& pair = scene.pairs()[i];
    const auto [a, b] = std::minmax(scene.object(pair.a).spec.name, scene.object(pair.b).spec.name);
    index.emplace(std::pair(a, b), PairId(i));
  }
  return index;
}

std::string nameOf(const scene::Scene& scene, PairId id) {
  const scene::Pair& pair = scene.pairs()[id.index()];
  return "`" + scene.object(pair.a).spec.name + "`, `" + scene.object(pair.b).spec.name + "`";
}

/// In the order of their first pairs in the scene.
std::vector<PairGroup> groupsByBodies(const scene::Scene& scene) {
  std::vector<PairGroup> groups;
  std::map<std::string, std::size_t> place;
  for (std::uint32_t i = 0; i < scene.pairs().size(); ++i) {
    const scene::Pair& pair = scene.pairs()[i];
    const auto [a, b] = std::minmax({pair.a.index(), pair.b.index()});
    const std::string name = scene.objects()[a].spec.group + " - " + scene.objects()[b].spec.group;
    const auto [it, fresh] = place.emplace(name, groups.size());
    if (fresh) groups.push_back({name, {}});
    groups[it->second].pairs.emplace_back(i);
  }
  return groups;
}

}  // namespace

std::vector<PairGroup> makePairGroups(const scene::Scene& scene, const scene_file::ThreadGroups& threads,
                                      std::vector<std::string>& remarks) {
  if (threads.empty()) return groupsByBodies(scene);
  const PairIndex index = indexOf(scene);
  std::vector<bool> grouped(scene.pairs().size());
  std::vector<PairGroup> groups;
  std::size_t unknown = 0;
  std::string first_unknown;
  for (const auto& names : threads) {
    PairGroup& group = groups.emplace_back();
    group.name = "group " + std::to_string(groups.size());
    for (const auto& [a, b] : names) {
      const auto found = index.find(std::minmax(a, b));
      if (found != index.end()) {
        group.pairs.push_back(found->second);
        grouped[found->second.index()] = true;
      } else if (unknown++ == 0) {
        first_unknown = "`" + a + "`, `" + b + "`";
      }
    }
    std::sort(group.pairs.begin(), group.pairs.end());
  }
  if (unknown > 0)
    remarks.push_back("threads: " + std::to_string(unknown) +
                      " of the named pairs are not checked in this scene, the first is " + first_unknown);
  PairGroup rest{kRest, {}};
  for (std::uint32_t i = 0; i < grouped.size(); ++i)
    if (!grouped[i]) rest.pairs.emplace_back(i);
  if (rest.pairs.empty()) return groups;
  remarks.push_back("threads: " + std::to_string(rest.pairs.size()) + " of " +
                    std::to_string(grouped.size()) + " pairs are in no group, the first is " +
                    nameOf(scene, rest.pairs.front()) + ": they run in the group `rest`");
  groups.push_back(std::move(rest));
  return groups;
}

}  // namespace abstand::session

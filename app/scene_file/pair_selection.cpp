#include "app/scene_file/pair_selection.hpp"

#include <algorithm>
#include <unordered_map>

namespace abstand::scene_file {
namespace {

class Bodies {
 public:
  explicit Bodies(const std::vector<SelectableBody>& bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      names_.push_back(bodies[i].name);
      index_.emplace(bodies[i].name, static_cast<int>(i));
    }
  }

  std::pair<int, int> find(const std::pair<std::string, std::string>& names, const SourcePos& pos) const {
    const auto [a, b] = std::minmax({indexOf(names.first, pos), indexOf(names.second, pos)});
    if (a == b)
      throw ParseError(pos,
                       "found a pair of `" + names.first + "` with itself, expected two different bodies");
    return {a, b};
  }

 private:
  int indexOf(const std::string& name, const SourcePos& pos) const {
    if (const auto it = index_.find(name); it != index_.end()) return it->second;
    const auto nearest = nearestName(name, names_);
    throw ParseError(pos, "found `" + name + "` in the pairs, expected the name of a body of this scene",
                     nearest.empty() ? "" : "did you mean `" + nearest + "`?");
  }

  std::vector<std::string> names_;
  std::unordered_map<std::string, int> index_;
};

bool byDefault(const SelectableBody& a, const SelectableBody& b, const PairsDescription& rules) {
  if (a.group != b.group) return true;
  return a.person && b.person ? rules.within_people : rules.standard == PairDefault::kAll;
}

}  // namespace

std::vector<std::pair<int, int>> selectPairs(const std::vector<SelectableBody>& bodies,
                                             const PairsDescription& rules,
                                             const std::vector<std::pair<int, int>>& adjacent) {
  const std::size_t n = bodies.size();
  const Bodies names(bodies);
  std::vector<bool> chosen(n * n, false);
  const auto at = [&](std::pair<int, int> p) {
    return chosen[static_cast<std::size_t>(std::min(p.first, p.second)) * n +
                  static_cast<std::size_t>(std::max(p.first, p.second))];
  };
  const auto posOf = [](const std::vector<SourcePos>& positions, std::size_t i) {
    return i < positions.size() ? positions[i] : SourcePos{};
  };

  if (rules.standard != PairDefault::kNone)
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b) chosen[a * n + b] = byDefault(bodies[a], bodies[b], rules);
  if (rules.exclude_adjacent) {
    for (const auto& p : adjacent) {
      ABSTAND_CHECK(p.first >= 0 && p.second >= 0 && p.first < static_cast<int>(n) &&
                    p.second < static_cast<int>(n));
      at(p) = false;
    }
  }
  for (const auto& p : rules.dropped) at(names.find({p.a, p.b}, {})) = false;
  for (std::size_t i = 0; i < rules.exclude.size(); ++i)
    at(names.find(rules.exclude[i], posOf(rules.exclude_pos, i))) = false;
  for (std::size_t i = 0; i < rules.include.size(); ++i)
    at(names.find(rules.include[i], posOf(rules.include_pos, i))) = true;

  std::vector<std::pair<int, int>> pairs;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      if (chosen[a * n + b]) pairs.emplace_back(static_cast<int>(a), static_cast<int>(b));
  return pairs;
}

}  // namespace abstand::scene_file

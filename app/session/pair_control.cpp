#include "app/session/pair_control.hpp"

#include <algorithm>
#include <array>

namespace abstand::session {
namespace {

constexpr std::array<std::string_view, 5> kOutcomes{
    "done", "no such group", "no such pair", "the pair is in a group already", "the pair is in no group"};

}  // namespace

std::string_view outcomeName(PairControl::Outcome outcome) {
  return kOutcomes[static_cast<std::size_t>(outcome)];
}

PairControl::PairControl(Session& session) : session_(session) {
  const auto& groups = session.pairGroups();
  states_.assign(groups.size(), view::PairGroupState::kRunning);
  group_of_.assign(session.scene().pairs().size(), kNoGroup);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    sizes_.push_back(groups[g].pairs.size());
    for (const PairId pair : groups[g].pairs) group_of_[pair.index()] = static_cast<int>(g);
  }
  for (std::uint32_t i = 0; i < group_of_.size(); ++i) apply(PairId(i), 0.0);
}

const std::string& PairControl::name(int group) const {
  return session_.pairGroups()[static_cast<std::size_t>(group)].name;
}

void PairControl::apply(PairId pair, double t) {
  const int group = group_of_[pair.index()];
  session_.scene().setPaused(pair, group == kNoGroup || state(group) != view::PairGroupState::kRunning, t);
}

PairControl::Outcome PairControl::setState(int group, view::PairGroupState state, double t) {
  if (group < 0 || group >= groups()) return Outcome::kNoGroup;
  states_[static_cast<std::size_t>(group)] = state;
  for (std::uint32_t i = 0; i < group_of_.size(); ++i)
    if (group_of_[i] == group) apply(PairId(i), t);
  return Outcome::kDone;
}

void PairControl::setAll(view::PairGroupState state, double t) {
  std::fill(states_.begin(), states_.end(), state);
  for (std::uint32_t i = 0; i < group_of_.size(); ++i) apply(PairId(i), t);
}

PairControl::Outcome PairControl::add(int group, std::optional<PairId> pair, double t) {
  if (group < 0 || group >= groups()) return Outcome::kNoGroup;
  if (!pair) return Outcome::kNoPair;
  int& now = group_of_[pair->index()];
  if (now != kNoGroup) return Outcome::kInGroup;
  now = group;
  ++sizes_[static_cast<std::size_t>(group)];
  --without_group_;
  apply(*pair, t);
  return Outcome::kDone;
}

PairControl::Outcome PairControl::remove(std::optional<PairId> pair, double t) {
  if (!pair) return Outcome::kNoPair;
  int& now = group_of_[pair->index()];
  if (now == kNoGroup) return Outcome::kNotInGroup;
  --sizes_[static_cast<std::size_t>(now)];
  ++without_group_;
  now = kNoGroup;
  apply(*pair, t);
  return Outcome::kDone;
}

int PairControl::find(std::string_view name) const {
  for (int g = 0; g < groups(); ++g)
    if (this->name(g) == name) return g;
  return kNoGroup;
}

std::optional<PairId> PairControl::findPair(int a, int b) const {
  const scene::Scene& scene = session_.scene();
  if (a < 0 || b < 0 || a >= static_cast<int>(scene.objectCount())) return std::nullopt;
  for (const PairId id : scene.pairsOf(ObjectId(static_cast<std::uint32_t>(a)))) {
    const scene::Pair& pair = scene.pairs()[id.index()];
    const auto x = static_cast<int>(pair.a.index()), y = static_cast<int>(pair.b.index());
    if ((x == a && y == b) || (x == b && y == a)) return id;
  }
  return std::nullopt;
}

void PairControl::capture(view::SceneSnapshot& out) const {
  out.groups.resize(states_.size());
  for (std::size_t g = 0; g < states_.size(); ++g) out.groups[g] = {states_[g], sizes_[g]};
  out.pair_group.assign(group_of_.begin(), group_of_.end());
}

}  // namespace abstand::session

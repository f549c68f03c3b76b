// Groups of pairs that a person or another program pauses, stops and starts while a session runs.
#pragma once

#include <cstdint>
#include <optional>

#include "app/session/session.hpp"

namespace abstand::session {

/// What is not running is stale: Scene::setPaused. A pair that was removed belongs to no group and stays
/// stale until it is added to one. At first every group of Session::pairGroups() runs. One thread, that of
/// the session; nothing allocates or throws but the constructor.
class PairControl {
 public:
  static constexpr int kNoGroup = -1;

  /// The session must outlive it. Every pair runs at first, whatever was before.
  explicit PairControl(Session& session);

  /// How an order went.
  enum class Outcome : std::uint8_t {
    kDone,
    kNoGroup,    ///< no group has this number
    kNoPair,     ///< the scene has no such pair
    kInGroup,    ///< the pair to be added is in a group already
    kNotInGroup  ///< the pair to be removed is in no group
  };

  /// `t`: s, from which on it holds.
  Outcome setState(int group, view::PairGroupState state, double t);
  /// All groups at once.
  void setAll(view::PairGroupState state, double t);
  /// A pair is in one group at most; in a running one it is queried in the next cycle.
  Outcome add(int group, std::optional<PairId> pair, double t);
  Outcome remove(std::optional<PairId> pair, double t);

  int groups() const { return static_cast<int>(states_.size()); }
  const std::string& name(int group) const;
  view::PairGroupState state(int group) const { return states_[static_cast<std::size_t>(group)]; }
  std::size_t size(int group) const { return sizes_[static_cast<std::size_t>(group)]; }  ///< pairs in it
  std::size_t withoutGroup() const { return without_group_; }
  /// The group with this name, kNoGroup when there is none.
  int find(std::string_view name) const;
  /// The pair of the scene with these two objects, in either order.
  std::optional<PairId> findPair(int a, int b) const;
  /// Fills groups and pair_group. No allocation once `out` has its sizes.
  void capture(view::SceneSnapshot& out) const;

 private:
  void apply(PairId pair, double t);

  Session& session_;
  std::vector<view::PairGroupState> states_;
  std::vector<std::size_t> sizes_;
  std::vector<int> group_of_;  ///< of each pair
  std::size_t without_group_{0};
};

/// In English, for messages and protocols: "done", "no such group" ...
std::string_view outcomeName(PairControl::Outcome outcome);

}  // namespace abstand::session

// Pausing, stopping and starting groups of pairs while a session runs.
#pragma once

#include <cstdint>
#include <optional>

#include "app/session/session.hpp"

namespace abstand::session {

/// Pairs that are not running are stale: Scene::setPaused. A removed pair belongs to no group and stays stale
/// until added to one. Initially every group of Session::pairGroups() runs. The session's thread only; only
/// the constructor allocates or throws.
class PairControl {
 public:
  static constexpr int kNoGroup = -1;

  /// The session must outlive this object. Every pair runs initially, regardless of its state before.
  explicit PairControl(Session& session);

  /// Result of a command.
  enum class Outcome : std::uint8_t {
    kDone,
    kNoGroup,    ///< the group does not exist
    kNoPair,     ///< the scene has no such pair
    kInGroup,    ///< add: the pair is in a group already
    kNotInGroup  ///< remove: the pair is not in a group
  };

  /// `t`: s, time from which on it applies.
  Outcome setState(int group, view::PairGroupState state, double t);
  /// All groups at once.
  void setAll(view::PairGroupState state, double t);
  /// Adds a pair; it can be in one group only. In a running group it is queried in the next cycle.
  Outcome add(int group, std::optional<PairId> pair, double t);
  Outcome remove(std::optional<PairId> pair, double t);

  int groups() const { return static_cast<int>(states_.size()); }
  const std::string& name(int group) const;
  view::PairGroupState state(int group) const { return states_[static_cast<std::size_t>(group)]; }
  std::size_t size(int group) const { return sizes_[static_cast<std::size_t>(group)]; }  ///< number of pairs
  std::size_t withoutGroup() const { return without_group_; }
  /// Index of the group with this name, or kNoGroup.
  int find(std::string_view name) const;
  /// The pair of the scene with these two objects, in either order.
  std::optional<PairId> findPair(int a, int b) const;
  /// Sets groups and pair_group. No allocation once `out` has its sizes.
  void capture(view::SceneSnapshot& out) const;

 private:
  void apply(PairId pair, double t);

  Session& session_;
  std::vector<view::PairGroupState> states_;
  std::vector<std::size_t> sizes_;
  std::vector<int> group_of_;  ///< for each pair
  std::size_t without_group_{0};
};

/// English text for messages and protocols: "done", "no such group" ...
std::string_view outcomeName(PairControl::Outcome outcome);

}  // namespace abstand::session

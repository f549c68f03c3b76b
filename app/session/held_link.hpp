// What a robot holds: it stays on the surface while the hand is pressed into it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/session/robot_pairs.hpp"
#include "core/control/contact_manifold.hpp"

namespace abstand::session {

/// The link of a mechanism that its file calls `held`, moved by the god-object of the law `proxy`
/// (god_object.hpp) in place of the hand's frame: where it would go into something, it stays on the surface,
/// and the hand feels the spring between the two. Loop thread only; nothing allocates or throws but the
/// constructor.
class HeldLink {
 public:
  /// The mechanism's held link, or nothing. Throws UsageError for a reaction with a `proxy` and no held link.
  static std::optional<std::size_t> find(const scene_file::MechanismDescription& description,
                                         const control::ReactionDescription& reaction);

  /// From now on the driver leaves the link alone. The proxy of `reaction` starts at the hand in the first
  /// place(). All must outlive it.
  HeldLink(MechanismDriver& driver, std::size_t link, const scene::Scene& scene,
           std::span<const RobotPairs::Own> own, control::Reaction& reaction);
  ~HeldLink();
  HeldLink(const HeldLink&) = delete;
  HeldLink& operator=(const HeldLink&) = delete;

  /// Puts the link where the proxy is; after the driver placed the others.
  void place(double t, scene::Scene& scene);
  /// For Reaction::update(): the hand, and what is near the held link, of the scene's step() just now. Holds
  /// until the next call.
  const control::HeldObject& look(const scene::Scene& scene);
  /// Adds J^T of the spring's wrench on the hand, as of the last update.
  void addEfforts(std::span<double> efforts) const;
  int frame() const { return frame_; }
  const Wrench& wrench() const { return reaction_.proxy()->wrench(); }       ///< on the hand, world
  const Vector3d& point() const { return reaction_.proxy()->handCentre(); }  ///< that it is about, world

 private:
  struct Near {
    PairId id;
    bool held_is_a;
    control::ContactManifold contacts;
  };
  Transform hand() const;

  MechanismDriver& driver_;
  control::Reaction& reaction_;
  std::size_t link_;
  int frame_;
  ObjectId object_;
  std::vector<Near> near_;
  std::vector<control::ContactConstraint> constraints_;
  control::HeldObject held_;
  bool started_{false};
};

}  // namespace abstand::session

// Link held by a robot, moved by the god-object method.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/session/robot_pairs.hpp"
#include "core/control/contact_manifold.hpp"

namespace abstand::session {

/// The link of a mechanism marked `held` in the scene. The god-object of the law `proxy` (god_object.hpp)
/// moves it instead of the hand's frame: it stays on surfaces that the hand would push it into, and a spring
/// between both acts on the hand. Loop thread only; only the constructor allocates or throws.
class HeldLink {
 public:
  /// Index of the mechanism's held link, or nullopt. Throws UsageError for a reaction with a `proxy` without
  /// a held link.
  static std::optional<std::size_t> find(const scene_file::MechanismDescription& description,
                                         const control::ReactionDescription& reaction);

  /// The driver no longer moves the link. The proxy of `reaction` starts at the hand in the first place().
  /// All arguments must outlive this object.
  HeldLink(MechanismDriver& driver, std::size_t link, const scene::Scene& scene,
           std::span<const RobotPairs::Own> own, control::Reaction& reaction);
  ~HeldLink();
  HeldLink(const HeldLink&) = delete;
  HeldLink& operator=(const HeldLink&) = delete;

  /// Sets the link to the proxy's pose; call after the driver has placed the others.
  void place(double t, scene::Scene& scene);
  /// Input of Reaction::update(): pose in the hand and contacts near the held link, after the scene's step().
  /// Valid until the next call.
  const control::HeldObject& update(const scene::Scene& scene);
  /// Adds J^T of the spring's wrench on the hand, from the last update.
  void addEfforts(std::span<double> efforts) const;
  int frame() const { return frame_; }
  const Wrench& wrench() const { return reaction_.proxy()->wrench(); }       ///< on the hand, world
  const Vector3d& point() const { return reaction_.proxy()->handCentre(); }  ///< its reference point, world

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

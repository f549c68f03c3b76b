// What the window needs from a running session: values to show, and commands.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/scene/scene_note.hpp"
#include "core/view/snapshot.hpp"
#include "ui/model/analysis_port.hpp"
#include "ui/model/body_inside.hpp"
#include "ui/model/depth_cloud.hpp"
#include "ui/model/depth_port.hpp"
#include "ui/model/live_status.hpp"
#include "ui/model/time_range.hpp"

namespace abstand::ui {

struct PreparedMeshes;

/// Joints of a robot (rad, m), within their limits, and how far (m) the point that was asked for then is from
/// where it shall be.
struct Reached {
  std::vector<double> joints;
  double distance{0.0};
};

/// The window's only way to a session. All calls come from the GUI thread, none may wait for the session's
/// own thread: commands are handed over and obeyed soon after, snapshots are the newest there is. Times are
/// simulation time in seconds between outline().start and outline().end; the session clamps.
class SessionPort {
 public:
  virtual ~SessionPort() = default;

  /// Constant as long as the session lives.
  virtual const view::SceneOutline& outline() const = 0;
  /// What to know of the scene before believing it; constant likewise.
  virtual const std::vector<scene::SceneNote>& notes() const = 0;
  /// Of outline().meshes, where they were prepared while the session was opened; else null.
  virtual std::shared_ptr<const PreparedMeshes> meshes() const { return nullptr; }
  /// What is computed with, of an object; nothing: not known.
  virtual std::optional<BodyInside> inside(int object) const {
    static_cast<void>(object);
    return {};
  }
  /// The joints that bring the point `p_B` (m, frame of the body) of an object to `p_W` (m, world), or as
  /// near as no small motion is nearer, starting at `joints` of its robot; nothing: no joint moves the
  /// object.
  virtual std::optional<Reached> reach(int object, const Vector3d& p_B, const Vector3d& p_W,
                                       const std::vector<double>& joints) const {
    static_cast<void>(object), static_cast<void>(p_B), static_cast<void>(p_W), static_cast<void>(joints);
    return {};
  }
  /// Of a session that shows what another program computed: commands that would change it have no effect.
  /// Nothing: it computes itself.
  virtual std::optional<LiveStatus> live() const { return {}; }
  /// Shows the newest moment again, and follows.
  virtual void toLive() {}
  /// All times that can be shown. Differs from the outline's in a session that goes on without end, where it
  /// moves now and then; the plot samples of the new range then come again.
  virtual TimeRange span() const { return {outline().start, outline().end}; }
  /// Copies the newest snapshot; false, and `out` untouched, when nothing is new since the last call.
  virtual bool takeSnapshot(view::SceneSnapshot& out) = 0;
  /// Appends every plot sample since the last call, in the order of the cycles.
  virtual void drainPlot(std::vector<view::PlotSample>& out) = 0;

  /// Of the whole recording; null: there is none. Lives as long as the session.
  virtual AnalysisPort* analysis() { return nullptr; }
  /// Of people whose recording is one of depth images; null: there are none. Lives as long as the session.
  virtual DepthPort* depth() { return nullptr; }
  /// Points of these images; null as depth().
  virtual CloudPort* clouds() { return nullptr; }

  virtual void play(bool on) = 0;
  /// Moves by this many frame periods (negative: back) and stays paused.
  virtual void step(int frames) = 0;
  virtual void seek(double t) = 0;
  /// 1: as recorded.
  virtual void setSpeed(double factor) = 0;
  virtual void setLoop(bool on) = 0;
  /// Robots with a reaction react, from the present time on; off: they follow their motion. At first: on.
  virtual void setReact(bool on) = 0;
  /// Lets every robot that waits for a reset go on, if nothing asks it to stop.
  virtual void resetStops() = 0;
  /// Safety margin of one object (index of the outline), metres.
  virtual void setMargin(int object, double metres) = 0;
  /// Margin (m) of all pairs of a class, which replaces the sums of the objects' margins; nullopt: the sums
  /// again.
  virtual void setClassMargin(view::PairClass pair_class, std::optional<double> metres) = 0;
  /// Torques of the robots' reactions reach their motors; off: robots only follow their motion and stop. At
  /// first: on.
  virtual void setTorques(bool on) = 0;
  /// A group of SceneOutline::pair_groups. Pairs of one that does not run are stale.
  virtual void setGroup(int group, view::PairGroupState state) = 0;
  /// Puts a pair (index of the outline) that is in no group into one, or takes it out of its group.
  virtual void addPair(int group, int pair) = 0;
  virtual void removePair(int pair) = 0;
  /// A joint (index of the outline; rad or m) by hand, within its limits; its robot ignores its motion from
  /// then on, and its reaction rests.
  virtual void poseJoint(int joint, double value) = 0;
  /// Gives a robot (index of SceneOutline::robots) that was posed by hand back to its motion.
  virtual void followMotion(int robot) = 0;
  /// Puts a thing (index of the outline) at a pose in the world; nullopt: as in the scene file.
  virtual void placeThing(int object, const std::optional<Transform>& X_WB) = 0;
  /// Laws and numbers of a robot (index of SceneOutline::reacting), from the next cycle on; active stops stay
  /// until they are reset. The reaction fits the robot (control::changedReaction).
  virtual void setReaction(int robot, const control::ReactionDescription& reaction) = 0;
  /// The user pulls the point `p_B` (m, frame of the body) of an object (index of the outline) to `target_W`
  /// (m, world) with the force of MoverSnapshot::poke, which acts on the reaction of its robot like that of a
  /// contact. To be sent again at least ten times a second: a poke that is not renewed ends by itself.
  virtual void poke(int object, const Vector3d& p_B, const Vector3d& target_W) = 0;
  virtual void endPoke() = 0;
};

}  // namespace abstand::ui

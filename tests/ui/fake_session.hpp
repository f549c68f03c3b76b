// A session that is only made up: a moving arm, a moving person, a table; for tests and the demo.
#pragma once

#include <string>
#include <vector>

#include "ui/model/session_port.hpp"

namespace abstand::ui {

/// Deterministic: time moves by advance() only. Distances are those of the bodies' enclosing spheres, forces
/// are proportional to the overlap of the margins; the pictures matter here, not the physics.
class FakeSession : public SessionPort {
 public:
  FakeSession();

  const view::SceneOutline& outline() const override { return outline_; }
  const std::vector<scene::SceneNote>& notes() const override { return scene_notes; }
  AnalysisPort* analysis() override { return recording; }
  bool takeSnapshot(view::SceneSnapshot& out) override;
  void drainPlot(std::vector<view::PlotSample>& out) override;
  void play(bool on) override;
  void step(int frames) override;
  void seek(double t) override;
  void setSpeed(double factor) override { speed = factor; }
  void setLoop(bool on) override { loop = on; }
  void setReact(bool on) override;
  void resetStops() override;
  void setMargin(int object, double metres) override;
  void setClassMargin(view::PairClass pair_class, std::optional<double> metres) override;
  void setTorques(bool on) override;
  void setGroup(int group, view::PairGroupState state) override;
  void addPair(int group, int pair) override;
  void removePair(int pair) override;
  void poseJoint(int joint, double value) override;
  void followMotion(int robot) override;
  void placeThing(int object, const std::optional<Transform>& X_WB) override;
  void setReaction(int robot, const control::ReactionDescription& reaction) override;
  void poke(int object, const Vector3d& p_B, const Vector3d& target_W) override;
  void endPoke() override;

  /// Computes every frame of `seconds` of wall time, when playing.
  void advance(double seconds);
  double time() const { return snapshot_.t; }
  bool playing() const { return snapshot_.playing; }
  int indexOf(const std::string& name) const;
  void setPoseState(int object, scene::PoseState state);
  void setPoseUncertainty(int object, double metres);
  void setWork(const scene::StepCounts& work);
  /// Lets the arm react; `update` may change what is said of it.
  template <class Update>
  void setRobot(Update update) {
    snapshot_.robots.resize(1);
    update(snapshot_, snapshot_.robots[0]);
    fresh_ = true;
  }

  AnalysisPort* recording{nullptr};  ///< of the whole recording; lives in the owner
  std::vector<scene::SceneNote> scene_notes;
  std::vector<control::ReactionDescription> reactions;  ///< as they came
  double speed{1.0};
  bool loop{false};
  std::vector<std::string> log;  ///< commands as they came: "seek 1.5", "margin 3 0.04" ...

 private:
  void addRobot();
  void addPerson();
  void addThings();
  int addObject(const std::string& name, const std::string& group, bool human, geometry::TriangleMesh mesh,
                double radius);
  void compute(double t);
  void group();
  void place(double t);
  void relate();

  view::SceneOutline outline_;
  view::SceneSnapshot snapshot_;
  std::vector<double> radii_;
  std::vector<double> hand_;  ///< joints of the arm by hand; empty: it moves
  std::vector<view::PlotSample> samples_;
  bool fresh_{true};
  long margin_edits_{0};
};

}  // namespace abstand::ui

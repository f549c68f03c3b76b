// SessionPort of moments that another program computed: a running `abstand serve`, or a recording of one.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/studio/inside_of_body.hpp"
#include "app/studio/live_port.hpp"
#include "app/studio/viewer_review.hpp"
#include "app/viewer/live_record.hpp"
#include "app/viewer/viewer_link.hpp"
#include "core/scene/cycle_statistics.hpp"
#include "ui/model/session_port.hpp"

namespace abstand::studio {

/// Why moments of `card` cannot be shown with the bodies of `outline`: other names, pairs or joints; empty:
/// they can.
QString whyNotShown(const moment::SceneCard& card, const view::SceneOutline& outline);

/// Shows the newest moment, or an earlier one after a seek. From there it plays on, and follows again when it
/// has caught up. While the connection is stale, every pose in it is.
class ViewerPort final : public ui::SessionPort {
 public:
  struct Parts {
    std::shared_ptr<viewer::LiveRecord> record;
    std::unique_ptr<viewer::ViewerLink> link;  ///< null: moments of a file
    view::SceneOutline outline;                ///< as the scene is here
    view::SceneSnapshot sized;                 ///< a snapshot of it
    std::vector<scene::SceneNote> notes;
    std::shared_ptr<const ui::PreparedMeshes> meshes;
    Structures structures;
    bool other_file{false};
    std::function<void()> reset;  ///< of the stops of the robots; null: only the server decides
  };
  /// `clock`: s, steady; that of the link.
  explicit ViewerPort(Parts parts, std::function<double()> clock = viewer::steadySeconds);

  const view::SceneOutline& outline() const override { return my_.outline; }
  const std::vector<scene::SceneNote>& notes() const override { return my_.notes; }
  std::shared_ptr<const ui::PreparedMeshes> meshes() const override { return my_.meshes; }
  std::optional<ui::BodyInside> inside(int object) const override;
  std::optional<ui::LiveStatus> live() const override;
  void toLive() override;
  ui::TimeRange span() const override { return span_; }
  ui::AnalysisPort* analysis() override { return review_.empty() ? nullptr : &review_; }
  bool takeSnapshot(view::SceneSnapshot& out) override;
  void drainPlot(std::vector<view::PlotSample>& out) override;
  void play(bool on) override;
  void step(int frames) override;
  void seek(double t) override;
  void resetStops() override;
  void setSpeed(double factor) override;
  void setLoop(bool) override {}
  // The server decides.
  void setReact(bool) override {}
  void setMargin(int, double) override {}
  void setClassMargin(view::PairClass, std::optional<double>) override {}
  void setTorques(bool) override {}
  void setGroup(int, view::PairGroupState) override {}
  void addPair(int, int) override {}
  void removePair(int) override {}
  void poseJoint(int, double) override {}
  void followMotion(int) override {}
  void placeThing(int, const std::optional<Transform>&) override {}
  void setReaction(int, const control::ReactionDescription&) override {}
  void poke(int, const Vector3d&, const Vector3d&) override {}
  void endPoke() override {}

  const viewer::LiveRecord& record() const { return *my_.record; }

 private:
  void moveSpan();
  double shownTime() const;
  void restart(double t);
  bool decode(view::SceneSnapshot& out);

  Parts my_;
  ViewerReview review_;
  std::function<double()> clock_;
  ui::TimeRange span_;
  moment::Moment moment_;
  viewer::LiveRecord::Copy copy_;
  scene::CycleStatistics cycles_{kInfinity};
  bool follows_{true};  ///< shows the newest moment
  bool playing_{true};
  double from_t_{0.0}, from_clock_{0.0}, speed_{1.0};  ///< of what is played again
  double shown_t_{kNaN};
  int steps_{0};      ///< that were asked for
  bool asked_{true};  ///< another moment, or another state, shall be shown
  bool was_stale_{false};
  long step_{0};
};

}  // namespace abstand::studio

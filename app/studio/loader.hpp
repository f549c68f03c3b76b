// Loads sessions on threads of their own.
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "app/analysis/analysis_runner.hpp"
#include "app/loop/live_session.hpp"
#include "app/studio/body_previews.hpp"
#include "app/studio/default_placement.hpp"
#include "app/studio/live_port.hpp"
#include "core/robot_file/mesh_reference.hpp"
#include "core/scene/scene_note.hpp"
#include "ui/document/work.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/viewport/prepared_meshes.hpp"

namespace abstand::studio {

/// What a load gives.
struct Loaded {
  std::unique_ptr<loop::LiveSession> live;  ///< null where it failed
  std::vector<scene::SceneNote> notes;
  std::shared_ptr<const ui::PreparedMeshes> meshes;
  std::optional<analysis::AnalysisRequest> analysis;  ///< of a scene with people beside robots
  Structures structures;                              ///< by object
  SceneBodies bodies;                                 ///< without the options of the work
  std::vector<DepthPerson> depth;                     ///< whose recording is one of depth images
  RobotReach reach;
  std::vector<DefaultPlacement> beside;    ///< robots that no file places; likewise
  std::optional<DefaultPlacement> placed;  ///< of a person that no file places; part of `work`
  QStringList files;                       ///< absolute paths of what the scene was read from
  QString problem;                         ///< why it failed
  ui::Work work;                           ///< what was loaded
  QStringList left_out;  ///< a sentence for each file that could not be read and is not in `work`
};

/// One load at a time counts, the newest. An older one is abandoned: it is told to end, and nobody waits for
/// it before the program ends. GUI thread only.
class Loader : public QObject {
  Q_OBJECT

 public:
  explicit Loader(robot_file::PackagePaths packages, QObject* parent = nullptr);
  /// Waits for all loads, which are told to end.
  ~Loader() override;

  struct Options {
    bool lenient{false};  ///< a file that cannot be read is left out, and the others are loaded
    bool places{false};   ///< where robot and recording come from different files, defaultPlacement() holds
  };
  /// Scene, recording, added files and reading of `work`; the session starts at `t`.
  void start(const ui::Work& work, double t, Options options);
  void abandon();
  bool isLoading() const { return current_ != nullptr; }

 Q_SIGNALS:
  void progressed(const abstand::ui::Opening& opening);
  /// The newest load has ended.
  void finished(std::shared_ptr<abstand::studio::Loaded> loaded);

 private:
  struct Job;
  void removeEnded();

  const robot_file::PackagePaths packages_;
  std::shared_ptr<Job> current_;
  std::vector<std::shared_ptr<Job>> jobs_;  // with their threads, those that were abandoned too
};

}  // namespace abstand::studio

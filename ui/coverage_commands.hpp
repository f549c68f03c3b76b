// View > Plan a depth camera.
#pragma once

#include <QObject>
#include <QPointer>
#include <vector>

#include "ui/document/sensor_plan.hpp"
#include "ui/model/coverage_report.hpp"

class QTimer;
class QWidget;

namespace abstand::ui {

class CoverageDialog;
class Document;
class Playback;
class Viewport;

/// The planned sensor is part of the document and has its field of view in the 3D view. While the dialog is
/// open, somebody else computes what the sensor would not see, again after each change: of wanted() until
/// done(), fail() or cancelled(); the newest one counts. The dialog belongs to `window`. GUI thread only.
class CoverageCommands : public QObject {
  Q_OBJECT

 public:
  static constexpr int kGatherMs = 200;  ///< changes that follow each other sooner are one

  struct Parts {
    Document& document;
    Viewport& viewport;
    Playback& playback;
  };
  CoverageCommands(const Parts& parts, QWidget* window);

  void setKinds(std::vector<SensorKind> kinds) { kinds_ = std::move(kinds); }
  /// Another session is shown; `can`: its recording can be examined.
  void open(bool can);
  /// Shows the dialog. A document without a sensor gets one where the 3D view is seen from.
  void plan();
  void showProgress(int done, int all);
  void done(const CoverageReport& report);
  void fail(const QString& problem);
  /// Answers cameraFileWanted(). `X_W`: the optical frame in the world; nullopt: the file has no pose, and
  /// that of the plan stays.
  void takeCamera(const SensorLens& lens, const std::optional<Transform>& X_W);
  /// Null: closed.
  CoverageDialog* dialog() const;

 Q_SIGNALS:
  void wanted(const abstand::ui::SensorPlan& plan);
  void cancelled();
  /// The camera of a file that the user chose.
  void cameraFileWanted(const QString& file);

 private:
  void edit(const QString& text, const SensorPlan& plan, const QString& merge_key = {});
  void placeAtView();
  void askFile();
  void remove();
  void follow();
  void showSensor();
  void ask();

  Parts parts_;
  QWidget* window_;
  std::vector<SensorKind> kinds_;
  QPointer<CoverageDialog> dialog_;
  bool can_{false};
  QTimer* gather_;
};

}  // namespace abstand::ui

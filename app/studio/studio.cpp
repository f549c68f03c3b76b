#include "app/studio/studio.hpp"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStatusBar>
#include <QTimer>
#include <filesystem>
#include <utility>

#include "app/studio/avi_file.hpp"
#include "app/studio/heap_care.hpp"
#include "app/studio/import_reader.hpp"
#include "app/studio/pair_file.hpp"
#include "app/studio/studio_request.hpp"
#include "app/studio/viewer_port.hpp"
#include "core/base/output_file.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "humanmodel/body_part.hpp"
#include "ui/calibration_commands.hpp"
#include "ui/coverage_commands.hpp"
#include "ui/document/document.hpp"
#include "ui/exchange_commands.hpp"
#include "ui/file_commands.hpp"
#include "ui/import_commands.hpp"
#include "ui/live_camera_commands.hpp"
#include "ui/live_commands.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/person_editor.hpp"
#include "ui/panels/separation_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/project_commands.hpp"
#include "ui/report_commands.hpp"
#include "ui/speed_commands.hpp"
#include "ui/verification_commands.hpp"
#include "ui/video_recorder.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::studio {

namespace {

constexpr int kSettledMs = 5000;  // after an opening

/// Those of the project's table; null where it is not installed.
std::shared_ptr<const contact::ContactLimits> contactLimits() {
  const std::filesystem::path file = contact::defaultContactLimits();
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown)) return nullptr;
  return std::make_shared<contact::ContactLimits>(contact::loadContactLimits(file, humanmodel::partNames()));
}

}  // namespace

Studio::Studio(ui::MainWindow& window, const robot_file::PackagePaths& packages)
    : window_(window), packages_(packages), loader_(packages) {
  window.videos().setMaker(makeAviFile);
  window.panels().separation->setLimits(contactLimits());
  connect(&window, &ui::MainWindow::openSceneRequested, this,
          [this](const QString& path) { openScene(path, QString(), 0.0); });
  connect(&window, &ui::MainWindow::openRecordingRequested, this, &Studio::openRecording);
  connect(&window.files(), &ui::FileCommands::batchWanted, this, &Studio::openBatch);
  connect(&window, &ui::MainWindow::openProjectRequested, this, &Studio::openProject);
  connect(&window, &ui::MainWindow::personRequested, this, &Studio::changePerson);
  connect(&window, &ui::MainWindow::reloadRequested, this, &Studio::reload);
  connect(&window.reports(), &ui::ReportCommands::wanted, this, &Studio::makeReport);
  connect(&window.reports(), &ui::ReportCommands::cancelled, this, [this] { report_.reset(); });
  connect(&window.speeds(), &ui::SpeedCommands::wanted, this, &Studio::proposeSpeeds);
  connect(&window.speeds(), &ui::SpeedCommands::cancelled, this, [this] { speeds_.reset(); });
  connectVerification();
  window.imports().setReader(readForImport);
  window.panels().inspector->person()->setPreviewer(
      [this](const QString& person, const ui::PersonOptions& options) {
        const auto body = bodies_.find(person.toStdString());
        return bodyPreview(body != bodies_.end() ? body->second : humanmodel::HumanOptions(), options);
      });
  connectExchange();
  connectCoverage();
  connectCalibration();
  connectLive();
  connectLiveCamera();
  connect(&watch_, &FileWatch::changed, this, [this](const QStringList& changed) {
    // What a server computes does not depend on the file any more.
    if (!record_ && (!request_ || request_->kind == Request::Kind::kFollow)) readAgain(changed);
  });
  connect(&window, &ui::MainWindow::cancelRequested, this, &Studio::cancel);
  connect(&window, &ui::MainWindow::closeRequested, this, &Studio::close);
  connect(&window.projects(), &ui::ProjectCommands::failed, this,
          [this](const QString&, const QString& problem) { Q_EMIT failed(problem); });
  connect(&window.document(), &ui::Document::workChanged, this,
          [this](const ui::Work& before, const ui::Work& after) { followWork(before, after); });
  connect(&loader_, &Loader::progressed, &window, &ui::MainWindow::showOpening);
  connect(&loader_, &Loader::finished, this, [this](const auto& loaded) { take(*loaded); });
  // When what was shown before, and what the opening needed, is free.
  connect(this, &Studio::ready, this, [this] { QTimer::singleShot(kSettledMs, this, releaseFreeHeap); });
}

Studio::~Studio() { window_.setSession(nullptr); }

/// As it is shown, with the pairs and the assumptions that need no other session.
ui::Work Studio::tunedWork() const {
  ui::Work work = shown_;
  work.moved = window_.document().work().moved;
  work.things = window_.document().work().things;
  work.what_if = window_.document().work().what_if;
  return work;
}

void Studio::makeReport(const ui::ReportRequest& request) {
  report_ = std::make_unique<ReportJob>(commandLineProgram(), tunedWork(), request, packages_);
  connect(report_.get(), &ReportJob::done, &window_.reports(), &ui::ReportCommands::done);
  connect(report_.get(), &ReportJob::failed, &window_.reports(), &ui::ReportCommands::fail);
  report_->start();
}

void Studio::proposeSpeeds(const ui::SpeedRequest& request) {
  ui::Work work = tunedWork();
  work.separation = window_.document().work().separation;
  speeds_ = std::make_unique<SpeedJob>(commandLineProgram(), work, request, packages_);
  connect(speeds_.get(), &SpeedJob::done, &window_.speeds(), &ui::SpeedCommands::done);
  connect(speeds_.get(), &SpeedJob::failed, &window_.speeds(), &ui::SpeedCommands::fail);
  speeds_->start();
}

void Studio::connectVerification() {
  ui::VerificationCommands& commands = window_.verification();
  commands.setFamilies(VerificationJob::families());
  connect(&commands, &ui::VerificationCommands::wanted, &verification_, &VerificationJob::start);
  connect(&commands, &ui::VerificationCommands::cancelled, &verification_, &VerificationJob::cancel);
  connect(&verification_, &VerificationJob::news, &commands, &ui::VerificationCommands::add);
  connect(&verification_, &VerificationJob::failed, &commands, &ui::VerificationCommands::fail);
  connect(&commands, &ui::VerificationCommands::pageWanted, this, [this, &commands](const QString& file) {
    try {
      verification_.savePage(file);
      commands.say(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
    } catch (const std::exception& e) {
      commands.say(QString::fromUtf8(e.what()));
    }
  });
}

void Studio::fail(const QString& problem) {
  window_.showProblem(tr("Cannot open"), problem);
  Q_EMIT failed(problem);
}

void Studio::connectLive() {
  const ui::LiveCommands& live = window_.live();
  connect(&live, &ui::LiveCommands::connectWanted, this, &Studio::connectTo);
  connect(&live, &ui::LiveCommands::disconnectWanted, this, &Studio::disconnectLive);
  connect(&live, &ui::LiveCommands::saveWanted, this, [this](const QString& file) {
    if (record_) saving_.start(record_, file);
  });
  connect(&window_, &ui::MainWindow::openMomentsRequested, this,
          [this](const QString& file) { openMoments(file, QString()); });
  connect(&opening_, &LiveOpening::found, this, &Studio::openLive);
  connect(&opening_, &LiveOpening::failed, this, [this](const QString& problem) {
    if (!record_) camera_.stop();
    window_.hideOpening();
    fail(problem);
  });
  connect(&saving_, &MomentSaving::done, this,
          [this](const QString& file) { window_.say(tr("Saved %1").arg(file)); });
  connect(&saving_, &MomentSaving::failed, this,
          [this](const QString& problem) { window_.showProblem(tr("Cannot save"), problem); });
}

void Studio::connectLiveCamera() {
  ui::LiveCameraCommands& commands = window_.liveCamera();
  connect(&commands, &ui::LiveCameraCommands::wanted, this, [this](const ui::LiveCameraRequest& request) {
    ui::LiveCameraRequest absolute = request;
    absolute.scene = absolutePath(request.scene);
    camera_.start(commandLineProgram(), absolute, packages_);
  });
  connect(&commands, &ui::LiveCameraCommands::cancelled, &camera_, &LiveCamera::stop);
  connect(&camera_, &LiveCamera::progressed, &commands, &ui::LiveCameraCommands::say);
  connect(&camera_, &LiveCamera::failed, &commands, &ui::LiveCameraCommands::fail);
  connect(&camera_, &LiveCamera::sees, this, [this](const QString& address, const QString& scene) {
    window_.liveCamera().succeed();
    window_.say(tr("Joint values of robots are received at %1 (UDP)").arg(address));
    connectTo(address, scene);
  });
  connect(&camera_, &LiveCamera::lessSeen, this, [this](const QString& sentence) {
    window_.showProblem(tr("A live depth camera fails"), sentence);
  });
  connect(&camera_, &LiveCamera::remarked, this, [this](const QString& sentence) { window_.say(sentence); });
  connect(&camera_, &LiveCamera::ended, this, [this](const QString& problem) {
    window_.showProblem(tr("The live depth camera ended"), problem);
  });
}

void Studio::connectTo(const QString& address, const QString& scene) {
  window_.showOpening({});
  opening_.connectTo(address, absolutePath(scene));
}

void Studio::openMoments(const QString& file, const QString& scene) {
  window_.showOpening({});
  opening_.readFile(absolutePath(file), absolutePath(scene));
}

void Studio::openLive(std::shared_ptr<LiveSource> source, const QString& scene) {
  auto request = std::make_unique<Request>();
  request->kind = Request::Kind::kNew;
  request->project.work.view = window_.document().work().view;
  request->project.work.scene = absolutePath(scene);
  request->live = std::move(source);
  load(std::move(*request));
}

void Studio::disconnectLive() {
  if (!record_) return;
  Request request;
  request.project = window_.document().project();
  request.project.viewpoint.t = 0.0;
  load(std::move(request));
}

void Studio::connectExchange() {
  const ui::ExchangeCommands& exchange = window_.exchange();
  connect(&exchange, &ui::ExchangeCommands::rangeWanted, this,
          [this](const QString& person, const ui::TimeRange& range, const QString& file) {
            range_.start(shown_, packages_, person.toStdString(), range, file);
          });
  connect(&range_, &RangeJob::done, this,
          [this](const QString& file) { window_.say(tr("Saved %1").arg(file)); });
  connect(&range_, &RangeJob::failed, this,
          [this](const QString& problem) { window_.showProblem(tr("Save range"), problem); });
  connect(&exchange, &ui::ExchangeCommands::pairsWanted, this, &Studio::openPairs);
  connect(&exchange, &ui::ExchangeCommands::savePairsWanted, this, &Studio::savePairs);
}

void Studio::connectCoverage() {
  ui::CoverageCommands& commands = window_.coverage();
  commands.setKinds(sensorKinds());
  connect(&commands, &ui::CoverageCommands::wanted, this, [this](const ui::SensorPlan& plan) {
    ui::Work work = shown_;
    work.things = window_.document().work().things;
    work.sensor.reset();
    coverage_.start(work, packages_, plan);
  });
  connect(&commands, &ui::CoverageCommands::cameraFileWanted, this, [this](const QString& file) {
    try {
      const FileCamera camera = cameraOfFile(file);
      window_.coverage().takeCamera(camera.lens, camera.X_W);
    } catch (const std::exception& e) {
      window_.showProblem(tr("Open camera file"), QString::fromUtf8(e.what()));
    }
  });
  connect(&commands, &ui::CoverageCommands::cancelled, &coverage_, &CoverageDesk::cancel);
  connect(&coverage_, &CoverageDesk::progressed, &commands, &ui::CoverageCommands::showProgress);
  connect(&coverage_, &CoverageDesk::done, &commands, &ui::CoverageCommands::done);
  connect(&coverage_, &CoverageDesk::failed, &commands, &ui::CoverageCommands::fail);
}

void Studio::connectCalibration() {
  ui::CalibrationCommands& commands = window_.calibration();
  connect(&commands, &ui::CalibrationCommands::wanted, this, [this](const ui::CalibrationRequest& request) {
    calibration_ = std::make_unique<CalibrationJob>(commandLineProgram(), tunedWork(), request, packages_);
    connect(calibration_.get(), &CalibrationJob::done, &window_.calibration(),
            &ui::CalibrationCommands::done);
    connect(calibration_.get(), &CalibrationJob::failed, &window_.calibration(),
            &ui::CalibrationCommands::fail);
    calibration_->start();
  });
  connect(&commands, &ui::CalibrationCommands::cancelled, this, [this] { calibration_.reset(); });
}

void Studio::openPairs(const QString& robot, const QString& file) {
  try {
    const robot_file::Srdf srdf = robot_file::loadSrdf(QFile::encodeName(file).toStdString());
    std::size_t count = 0;
    window_.document().edit(tr("pairs of %1").arg(QFileInfo(file).fileName()), [&](ui::Work& work) {
      count = disablePairs(srdf, port_->outline(), robot.toStdString(), work);
    });
    window_.say(tr("%1 of %2 pairs of the file are checked here and no longer are")
                    .arg(count)
                    .arg(srdf.disabled.size()));
  } catch (const std::exception& e) {
    window_.showProblem(tr("Cannot open"), QString::fromUtf8(e.what()));
  }
}

/// An SRDF that is there already keeps what else it has.
void Studio::savePairs(const QString& robot, const QString& file) {
  try {
    const robot_file::Srdf srdf =
        uncheckedPairs(port_->outline(), window_.document().work(), robot.toStdString());
    const std::string name = QFile::encodeName(file).toStdString();
    QFile present(file);
    const bool there = present.open(QIODevice::ReadOnly);
    writeFile(name, there ? robot_file::mergedSrdfText(present.readAll().toStdString(), name, srdf)
                          : robot_file::srdfText(srdf));
    window_.say(tr("Saved %1").arg(file));
  } catch (const std::exception& e) {
    window_.showProblem(tr("Cannot save"), QString::fromUtf8(e.what()));
  }
}

}  // namespace abstand::studio

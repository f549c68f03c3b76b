#include "app/studio/studio.hpp"

#include <QApplication>
#include <QFile>
#include <QFileInfo>
#include <QStatusBar>
#include <QTimer>
#include <filesystem>
#include <utility>

#include "app/studio/avi_file.hpp"
#include "app/studio/import_reader.hpp"
#include "app/studio/pair_file.hpp"
#include "app/studio/viewer_port.hpp"
#include "core/base/output_file.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "humanmodel/body_part.hpp"
#include "ui/document/document.hpp"
#include "ui/exchange_commands.hpp"
#include "ui/file_commands.hpp"
#include "ui/import_commands.hpp"
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
#include "ui/video_recorder.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::studio {

namespace {

bool isLoadedAlike(const ui::Work& a, const ui::Work& b) {
  return a.scene == b.scene && a.recording == b.recording && a.reading == b.reading && a.people == b.people &&
         a.added == b.added && a.added_files == b.added_files;
}

constexpr int kNoticeMs = 8000, kSettleMs = 500;

/// Those of the project's table; null where it is not installed.
std::shared_ptr<const contact::ContactLimits> contactLimits() {
  const std::filesystem::path file = contact::defaultContactLimits();
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown)) return nullptr;
  return std::make_shared<contact::ContactLimits>(contact::loadContactLimits(file, humanmodel::partNames()));
}

QString absolute(const QString& path) { return path.isEmpty() ? path : QFileInfo(path).absoluteFilePath(); }

}  // namespace

/// What becomes of the document when the load has succeeded.
struct Studio::Request {
  enum class Kind {
    kNew,        ///< `project` takes its place
    kRecording,  ///< an edit: the recording of `project`
    kPerson,     ///< an edit: `person` as in `project`
    kFiles,      ///< an edit: scene, added files and recording of `project`
    kFollow      ///< nothing: it is as it should be
  };
  Kind kind{Kind::kFollow};
  ui::Project project;
  QString file;
  bool modified{false};
  QString person{};
  std::shared_ptr<LiveSource> live{};  ///< moments of a server in this scene
  ui::Work before{};                   ///< of the document when the request was made
  bool lenient{false};                 ///< files that cannot be read are left out
};

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
  window.imports().setReader(readForImport);
  window.panels().inspector->person()->setPreviewer(
      [this](const QString& person, const ui::PersonOptions& options) {
        const auto body = bodies_.find(person.toStdString());
        return bodyPreview(body != bodies_.end() ? body->second : humanmodel::HumanOptions(), options);
      });
  connectExchange();
  connectLive();
  connect(&files_, &QFileSystemWatcher::fileChanged, this, [this](const QString& file) {
    window_.statusBar()->showMessage(
        tr("%1 has changed. Reload it with Ctrl+R").arg(QFileInfo(file).fileName()), kNoticeMs);
    // An editor replaces a file: for a moment there is none.
    QTimer::singleShot(kSettleMs, this, &Studio::watchFiles);
  });
  connect(&window, &ui::MainWindow::cancelRequested, this, &Studio::cancel);
  connect(&window, &ui::MainWindow::closeRequested, this, &Studio::close);
  connect(&window.projects(), &ui::ProjectCommands::failed, this,
          [this](const QString&, const QString& problem) { Q_EMIT failed(problem); });
  connect(&window.document(), &ui::Document::workChanged, this,
          [this](const ui::Work& before, const ui::Work& after) { followWork(before, after); });
  connect(&loader_, &Loader::progressed, &window, &ui::MainWindow::showOpening);
  connect(&loader_, &Loader::finished, this, [this](const auto& loaded) { take(*loaded); });
}

Studio::~Studio() { window_.setSession(nullptr); }

void Studio::load(Request request) {
  if (!loader_.isLoading()) QApplication::setOverrideCursor(Qt::BusyCursor);
  request.before = window_.document().work();
  request_ = std::make_unique<Request>(std::move(request));
  window_.showOpening({});
  loader_.start(request_->project.work, request_->project.viewpoint.t, request_->lenient);
}

void Studio::openScene(const QString& scene, const QString& recording, double t) {
  const ui::Work& work = window_.document().work();
  if (port_ && absolute(scene) == work.scene && recording.isEmpty()) return reload();
  Request request;
  request.kind = Request::Kind::kNew;
  request.project.work.view = work.view;
  request.project.work.scene = absolute(scene);
  request.project.work.recording = absolute(recording);
  request.project.viewpoint.t = t;
  load(std::move(request));
}

void Studio::reload() {
  if (!port_) return;
  Request request;
  request.project = window_.document().project();
  request.project.viewpoint.t = window_.playback().time();
  load(std::move(request));
}

void Studio::openRecording(const QString& recording) {
  // Into the scene that is on its way, where one is.
  if (request_ && request_->kind == Request::Kind::kNew) {
    Request request = std::move(*request_);
    request.project.work.recording = absolute(recording);
    request.modified |= !request.file.isEmpty();
    return load(std::move(request));
  }
  Request request;
  request.kind = port_ ? Request::Kind::kRecording : Request::Kind::kNew;
  request.project = window_.document().project();
  request.project.work.recording = absolute(recording);
  request.project.viewpoint.t = 0.0;
  load(std::move(request));
}

void Studio::openBatch(const ui::FileBatch& batch) {
  const auto loadWith = [&](Request request) {
    request.lenient = true;
    ui::Work& work = request.project.work;
    if (!batch.scene.isEmpty()) work.scene = absolute(batch.scene);
    if (!batch.recording.isEmpty()) work.recording = absolute(batch.recording);
    for (const QString& file : batch.added) work.added_files << absolute(file);
    load(std::move(request));
  };
  // Into the scene that is on its way, where one is.
  if (request_ && request_->kind == Request::Kind::kNew && !batch.fresh) {
    Request request = std::move(*request_);
    request.modified |= !request.file.isEmpty();
    return loadWith(std::move(request));
  }
  Request request;
  if (batch.fresh || !port_) {
    request.kind = Request::Kind::kNew;
    request.project.work.view = window_.document().work().view;
  } else {
    request.kind = Request::Kind::kFiles;
    request.project = window_.document().project();
    request.project.viewpoint.t = batch.recording.isEmpty() ? window_.playback().time() : 0.0;
  }
  loadWith(std::move(request));
}

void Studio::changePerson(const QString& name, const ui::PersonOptions& options) {
  if (!port_) return;
  Request request;
  request.kind = Request::Kind::kPerson;
  request.person = name;
  request.project = window_.document().project();
  if (options == ui::PersonOptions())
    request.project.work.people.remove(name);
  else
    request.project.work.people[name] = options;
  request.project.viewpoint.t = window_.playback().time();
  load(std::move(request));
}

void Studio::openProject(const ui::Project& project, const QString& file, bool modified) {
  Request request;
  request.kind = Request::Kind::kNew;
  request.project = project;
  request.file = file;
  request.modified = modified;
  if (!project.work.showsNothing()) return load(std::move(request));
  close();
  window_.document().open(project, file, modified);
}

void Studio::cancel() {
  opening_.abandon();
  window_.hideOpening();
  if (!loader_.isLoading()) return;
  QApplication::restoreOverrideCursor();
  loader_.abandon();
  window_.hideOpening();
  giveUp(*std::exchange(request_, nullptr));
}

/// The document asks for what could not be loaded: nothing is shown rather than something else.
void Studio::giveUp(const Request& request) {
  if (request.kind != Request::Kind::kFollow || isLoadedAlike(shown_, window_.document().work())) return;
  window_.setSession(nullptr);
  port_.reset();
  record_.reset();
  shown_ = {};
}

void Studio::close() {
  cancel();
  window_.setSession(nullptr);
  analysis_.close();
  port_.reset();
  record_.reset();
  shown_ = {};
  ui::Project empty;
  empty.work.view = window_.document().work().view;
  window_.document().open(empty, QString(), false);
}

void Studio::followWork(const ui::Work& before, const ui::Work& after) {
  analysis_.follow(after);
  window_.review().setLeftOut(analysis_.leftOut());
  if (isLoadedAlike(before, after) || isLoadedAlike(after, request_ ? request_->project.work : shown_))
    return;
  Request request;
  request.project = window_.document().project();
  if (port_) request.project.viewpoint.t = window_.playback().time();
  load(std::move(request));
}

/// As it is shown, with the pairs and the assumptions that need no other session.
ui::Work Studio::tunedWork() const {
  ui::Work work = shown_;
  work.moved = window_.document().work().moved;
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
    window_.hideOpening();
    fail(problem);
  });
  connect(&saving_, &MomentSaving::done, this,
          [this](const QString& file) { window_.say(tr("Saved %1").arg(file)); });
  connect(&saving_, &MomentSaving::failed, this,
          [this](const QString& problem) { window_.showProblem(tr("Cannot save"), problem); });
}

void Studio::connectTo(const QString& address, const QString& scene) {
  window_.showOpening({});
  opening_.connectTo(address, absolute(scene));
}

void Studio::openMoments(const QString& file, const QString& scene) {
  window_.showOpening({});
  opening_.readFile(absolute(file), absolute(scene));
}

void Studio::openLive(std::shared_ptr<LiveSource> source, const QString& scene) {
  auto request = std::make_unique<Request>();
  request->kind = Request::Kind::kNew;
  request->project.work.view = window_.document().work().view;
  request->project.work.scene = absolute(scene);
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

/// A file that was replaced is watched no longer: all are added again.
void Studio::watchFiles() {
  if (!files_.files().isEmpty()) files_.removePaths(files_.files());
  for (const QString& file : QStringList{shown_.scene, shown_.recording} + shown_.added_files)
    if (QFileInfo::exists(file)) files_.addPath(file);
}

void Studio::editDocument(const Request& request) {
  ui::Document& document = window_.document();
  const ui::Work& wanted = request.project.work;
  switch (request.kind) {
    case Request::Kind::kNew:
      return document.open(request.project, request.file, request.modified);
    case Request::Kind::kRecording:
      return document.edit(tr("open recording %1").arg(QFileInfo(wanted.recording).fileName()),
                           [&](ui::Work& work) { work.recording = wanted.recording; });
    case Request::Kind::kFiles: {
      const ui::Work& shown = document.work();
      const int count = (wanted.scene != shown.scene) + (wanted.recording != shown.recording) +
                        (wanted.added_files.size() - shown.added_files.size());
      return document.edit(tr("open %n files", nullptr, count), [&](ui::Work& work) {
        work.scene = wanted.scene;
        work.recording = wanted.recording;
        work.added_files = wanted.added_files;
      });
    }
    case Request::Kind::kPerson:
      return document.edit(tr("change the person %1").arg(request.person),
                           [&](ui::Work& work) { work.people = wanted.people; });
    case Request::Kind::kFollow:
      break;
  }
}

std::unique_ptr<ui::SessionPort> Studio::portOf(Loaded& loaded, const Request& request) {
  record_ = request.live ? request.live->record : nullptr;
  if (!request.live) {
    std::unique_ptr<FeedPort> feed = analysis_.open(std::move(loaded.analysis), request.project.work);
    return std::make_unique<LivePort>(LivePort::Parts{
        std::move(loaded.live), std::move(loaded.notes), std::move(feed), std::move(loaded.meshes),
        std::move(loaded.structures), std::move(loaded.depth), std::move(loaded.reach)});
  }
  ViewerPort::Parts parts;
  parts.record = record_;
  parts.link = std::move(request.live->link);
  parts.outline = loaded.live->outline();
  loaded.live->takeSnapshot(parts.sized);
  parts.notes = std::move(loaded.notes);
  parts.meshes = std::move(loaded.meshes);
  parts.structures = std::move(loaded.structures);
  try {
    const QByteArray scene = QFile::encodeName(request.project.work.scene);
    parts.other_file = moment::sceneKey(scene.toStdString()) != record_->card()->scene;
  } catch (const std::exception&) {
    parts.other_file = true;
  }
  return std::make_unique<ViewerPort>(std::move(parts));
}

void Studio::take(Loaded& loaded) {
  QApplication::restoreOverrideCursor();
  const std::unique_ptr<Request> request = std::move(request_);
  window_.hideOpening();
  if (!loaded.live) {
    giveUp(*request);
    return fail(loaded.problem);
  }
  if (!loaded.left_out.isEmpty()) {
    request->project.work.scene = loaded.work.scene;
    request->project.work.recording = loaded.work.recording;
    request->project.work.added_files = loaded.work.added_files;
    window_.showProblem(tr("Not opened"), loaded.left_out.join(QLatin1Char('\n')));
    Q_EMIT leftOut(loaded.left_out);
  }
  ui::Document& document = window_.document();
  const bool is_new = request->kind == Request::Kind::kNew;
  // Work that was done while it was loading.
  if (is_new && !(document.work() == request->before) && !window_.projects().mayDiscard()) return;
  const ui::Work& wanted = request->project.work;
  // The clock has gone on while it was loading.
  const bool goes_on =
      port_ && !is_new && !record_ && wanted.scene == shown_.scene && wanted.recording == shown_.recording;
  const bool was_playing = window_.playback().playing();
  const double t = window_.playback().time();
  if (goes_on) document.setViewpoint({window_.viewport().cameraView(), t});
  if (const QString why =
          request->live ? whyNotShown(*request->live->record->card(), loaded.live->outline()) : QString();
      !why.isEmpty())
    return fail(tr("%1 cannot be shown with this scene. %2").arg(request->live->name, why));
  window_.setSession(nullptr);
  analysis_.close();
  port_ = portOf(loaded, *request);
  bodies_ = std::move(loaded.bodies);
  shown_ = wanted;
  watchFiles();
  editDocument(*request);
  window_.setSession(port_.get());
  analysis_.follow(document.work());
  window_.review().setLeftOut(analysis_.leftOut());
  window_.files().sessionShown();
  if (goes_on) {
    window_.playback().seek(t);
    if (was_playing) window_.playback().setPlaying(true);
  }
  Q_EMIT ready();
}

}  // namespace abstand::studio

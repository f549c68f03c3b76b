// What the window opens: requests, and what becomes of the document.
#include <QApplication>
#include <QFileInfo>
#include <utility>

#include "app/studio/studio_request.hpp"
#include "app/studio/viewer_port.hpp"
#include "ui/document/document.hpp"
#include "ui/file_commands.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/project_commands.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::studio {

namespace {

QString fileNamesOf(const QStringList& files) {
  QStringList names;
  for (const QString& file : files) names << QFileInfo(file).fileName();
  return names.join(QStringLiteral(", "));
}

}  // namespace

bool isLoadedAlike(const ui::Work& a, const ui::Work& b) {
  return a.scene == b.scene && a.recording == b.recording && a.reading == b.reading && a.people == b.people &&
         a.placed == b.placed && a.added == b.added && a.added_files == b.added_files;
}

void Studio::load(Request request) {
  if (!loader_.isLoading()) QApplication::setOverrideCursor(Qt::BusyCursor);
  request.before = window_.document().work();
  request_ = std::make_unique<Request>(std::move(request));
  window_.showOpening({});
  loader_.start(request_->project.work, request_->project.viewpoint.t, {request_->lenient, request_->places});
}

void Studio::openScene(const QString& scene, const QString& recording, double t) {
  const ui::Work& work = window_.document().work();
  if (port_ && absolutePath(scene) == work.scene && recording.isEmpty()) return reload();
  Request request;
  request.kind = Request::Kind::kNew;
  request.project.work.view = work.view;
  request.project.work.scene = absolutePath(scene);
  request.project.work.recording = absolutePath(recording);
  request.project.viewpoint.t = t;
  request.places = true;
  load(std::move(request));
}

void Studio::reload() { readAgain({}); }

void Studio::readAgain(const QStringList& changed) {
  if (!port_) return;
  Request request;
  request.changed = changed;
  request.project = window_.document().project();
  request.project.viewpoint.t = window_.playback().time();
  load(std::move(request));
}

/// The recording is one of those to choose from, where there are such.
void Studio::takeRecording(const QString& recording, ui::Work& work) {
  work.recording = absolutePath(recording);
  if (!work.recordings.isEmpty() && !work.recordings.contains(work.recording))
    work.recordings << work.recording;
}

void Studio::openRecording(const QString& recording) {
  // Into the scene that is on its way, where one is.
  if (request_ && request_->kind == Request::Kind::kNew) {
    Request request = std::move(*request_);
    takeRecording(recording, request.project.work);
    request.modified |= !request.file.isEmpty();
    return load(std::move(request));
  }
  Request request;
  request.kind = port_ ? Request::Kind::kRecording : Request::Kind::kNew;
  request.project = window_.document().project();
  takeRecording(recording, request.project.work);
  request.project.viewpoint.t = 0.0;
  request.places = true;
  load(std::move(request));
}

void Studio::openBatch(const ui::FileBatch& batch) {
  const auto loadWith = [&](Request request) {
    request.lenient = request.places = true;
    ui::Work& work = request.project.work;
    if (!batch.scene.isEmpty()) work.scene = absolutePath(batch.scene);
    if (!batch.recordings.isEmpty()) work.recordings.clear();
    for (const QString& file : batch.recordings) work.recordings << absolutePath(file);
    if (!batch.recording.isEmpty()) takeRecording(batch.recording, work);
    for (const QString& file : batch.added) work.added_files << absolutePath(file);
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
  if (!record_) camera_.stop();
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
  camera_.stop();
  window_.setSession(nullptr);
  analysis_.close();
  coverage_.close();
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

void Studio::editDocument(const Request& request) {
  ui::Document& document = window_.document();
  const ui::Work& wanted = request.project.work;
  switch (request.kind) {
    case Request::Kind::kNew:
      return document.open(request.project, request.file, request.modified);
    case Request::Kind::kRecording:
      return document.edit(tr("open recording %1").arg(QFileInfo(wanted.recording).fileName()),
                           [&](ui::Work& work) {
                             work.recording = wanted.recording;
                             work.recordings = wanted.recordings;
                             work.placed = wanted.placed;
                           });
    case Request::Kind::kFiles: {
      const ui::Work& shown = document.work();
      const int count = (wanted.scene != shown.scene) + (wanted.recording != shown.recording) +
                        (wanted.added_files.size() - shown.added_files.size());
      return document.edit(tr("open %n files", nullptr, count), [&](ui::Work& work) {
        work.scene = wanted.scene;
        work.recording = wanted.recording;
        work.recordings = wanted.recordings;
        work.added_files = wanted.added_files;
        work.placed = wanted.placed;
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
  if (request.live->name == camera_.address()) {
    camera_.takeJoints(parts.sized.joint_positions);
    if (camera_.canReset()) parts.reset = [this] { camera_.resetStops(); };
  }
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
    return request->changed.isEmpty() ? fail(loaded.problem) : sayUnread(*request, loaded.problem);
  }
  if (!loaded.left_out.isEmpty()) {
    request->project.work.scene = loaded.work.scene;
    request->project.work.recording = loaded.work.recording;
    request->project.work.recordings = loaded.work.recordings;
    request->project.work.added_files = loaded.work.added_files;
    window_.showProblem(tr("Not opened"), loaded.left_out.join(QLatin1Char('\n')));
    Q_EMIT leftOut(loaded.left_out);
  }
  request->project.work.placed = loaded.work.placed;
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
  if (goes_on) document.setViewpoint({window_.viewport().cameraView(), t, document.viewpoint().layout});
  if (const QString why =
          request->live ? whyNotShown(*request->live->record->card(), loaded.live->outline()) : QString();
      !why.isEmpty())
    return fail(tr("%1 cannot be shown with this scene. %2").arg(request->live->name, why));
  if (!request->live || request->live->name != camera_.address()) camera_.stop();
  window_.setSession(nullptr);
  analysis_.close();
  coverage_.open(loaded.live->outline(), loaded.structures);
  port_ = portOf(loaded, *request);
  bodies_ = std::move(loaded.bodies);
  shown_ = wanted;
  watch_.watch(QStringList{shown_.scene, shown_.recording} + shown_.added_files + loaded.files);
  editDocument(*request);
  window_.setSession(port_.get());
  analysis_.follow(document.work());
  window_.review().setLeftOut(analysis_.leftOut());
  window_.files().sessionShown();
  if (goes_on) {
    window_.playback().seek(t);
    if (was_playing) window_.playback().setPlaying(true);
  }
  sayOpened(*request, loaded);
  Q_EMIT ready();
}

/// What nobody asked for is said, too.
void Studio::sayOpened(const Request& request, const Loaded& loaded) {
  for (const DefaultPlacement& robot : loaded.beside)
    window_.say(tr("%1 was placed beside %2: see Inspector, Place")
                    .arg(QString::fromStdString(robot.person), QString::fromStdString(robot.robot)));
  if (loaded.placed)
    window_.say(tr("%1 was placed in front of %2: see Inspector, Place")
                    .arg(QString::fromStdString(loaded.placed->person),
                         QString::fromStdString(loaded.placed->robot)));
  else if (!request.changed.isEmpty())
    window_.say(tr("%1 has changed and was read again").arg(fileNamesOf(request.changed)));
}

void Studio::sayUnread(const Request& request, const QString& problem) {
  window_.say(tr("%1 has changed and cannot be read; what is shown stays. %2")
                  .arg(fileNamesOf(request.changed), problem));
}

}  // namespace abstand::studio

#include "app/studio/loader.hpp"

#include <QFile>
#include <QMetaObject>
#include <algorithm>
#include <filesystem>
#include <set>

#include "app/depth/open_session.hpp"
#include "app/run/scene_notes.hpp"
#include "app/studio/opening_progress.hpp"
#include "app/studio/scene_of_file.hpp"
#include "app/studio/scene_of_work.hpp"
#include "app/studio/unreadable_files.hpp"
#include "core/base/error.hpp"

namespace abstand::studio {

struct Loader::Job {
  std::atomic<bool> cancelled{false}, ended{false};
  std::jthread thread;
};

namespace {

/// How the recording is read.
session::SessionOptions optionsOf(const ui::Work& work) {
  session::SessionOptions options;
  options.recording = QFile::encodeName(work.recording).toStdString();
  options.person_speed = work.reading.speed;
  if (work.reading.cut_things) options.cut_things = true;
  return options;
}

scene::SceneNote defaultNote() {
  return {"placement",
          "the files of person and robot do not say how they stand to each other; the person stands in front "
          "of the robot by default",
          scene::Severity::kStrict};
}

/// Runs on the load's thread. Sets `bodies`.
std::unique_ptr<session::Session> makeSession(const ui::Work& work, const robot_file::PackagePaths& packages,
                                              const std::atomic<bool>& cancelled,
                                              const OpeningProgress::Show& show, SceneBodies& bodies) {
  scene_file::SceneDescription scene = sceneOf(work, packages);
  session::SessionOptions options = optionsOf(work);
  for (const scene_file::HumanDescription& human : scene.humans) bodies[human.name] = human.body;
  applyWork(work, scene);
  OpeningProgress progress(show);
  options.tracked = [&progress](std::size_t done, std::size_t all) { progress.read(done, all); };
  options.planned = [&progress](std::size_t structures) { progress.plan(structures); };
  options.monitor.progress = [&progress](double fraction, std::string_view name) {
    progress.hear(fraction, name);
  };
  options.keep_fits = true;
  options.monitor.cancelled = [&cancelled] { return cancelled.load(); };
  return depth::openSession(std::move(scene), options);
}

/// Where neither a scene file nor the user says where robots stand.
void placeRobots(session::Session& session, Loaded& loaded) {
  if (hasSceneFile(loaded.work)) return;
  std::set<std::string> placed;
  for (const QString& name : loaded.work.placed.keys()) placed.insert(name.toStdString());
  loaded.beside = placeRobotsBeside(session, placed);
  for (const DefaultPlacement& robot : loaded.beside)
    loaded.work.placed[QString::fromStdString(robot.person)] = robot.placement;
}

/// Where neither a scene file nor the user says where the person stands. True: it stands by default.
bool place(session::Session& session, Loaded& loaded, bool places) {
  if (hasSceneFile(loaded.work)) return false;
  const std::optional<DefaultPlacement> found = defaultPlacement(session);
  if (!found) return false;
  const QString name = QString::fromStdString(found->person);
  if (const auto present = loaded.work.placed.find(name); present != loaded.work.placed.end())
    return isSame(*present, found->placement);
  if (!places) return false;
  const auto& humans = session.description().humans;
  const auto human = std::find_if(humans.begin(), humans.end(),
                                  [&](const auto& each) { return each.name == found->person; });
  session.placePerson(static_cast<std::size_t>(human - humans.begin()), found->placement.xyz,
                      found->placement.rpy.z());
  loaded.work.placed[name] = found->placement;
  loaded.placed = found;
  return true;
}

QStringList filesOf(const scene_file::SceneDescription& scene) {
  QStringList files;
  const auto add = [&](const std::filesystem::path& file) {
    const QString path = QFile::decodeName(file.c_str());
    if (!path.isEmpty() && !files.contains(path)) files << path;
  };
  add(scene.file);
  add(scene.pairs.file);
  for (const auto& robot : scene.mechanisms) {
    for (const auto& file : {robot.file, robot.motion, robot.srdf}) add(file);
    for (const auto& link : robot.links) add(link.mesh);
  }
  for (const auto& human : scene.humans) add(human.recording.file);
  for (const auto& thing : scene.objects) add(thing.mesh);
  return files;
}

}  // namespace

Loader::Loader(robot_file::PackagePaths packages, QObject* parent)
    : QObject(parent), packages_(std::move(packages)) {}

Loader::~Loader() {
  abandon();
  // Each thread is joined by its job.
  jobs_.clear();
}

void Loader::abandon() {
  if (current_) current_->cancelled = true;
  current_.reset();
}

void Loader::removeEnded() {
  std::erase_if(jobs_, [](const auto& job) { return job->ended.load(); });
}

void Loader::start(const ui::Work& work, double t, Options options) {
  abandon();
  removeEnded();
  auto job = std::make_shared<Job>();
  current_ = job;
  jobs_.push_back(job);
  // The thread outlives neither the job nor the loader; what it has posted may outlive the job.
  job->thread = std::jthread([this, job = job.get(), weak = std::weak_ptr<Job>(job), work, t, options] {
    const auto post = [this, weak](auto&& call) {
      const auto if_current = [this, weak, call] {
        if (current_ && weak.lock() == current_) call();
      };
      QMetaObject::invokeMethod(this, if_current, Qt::QueuedConnection);
    };
    auto loaded = std::make_shared<Loaded>();
    try {
      const auto show = [&](const ui::Opening& opening) {
        post([this, opening] { Q_EMIT progressed(opening); });
      };
      loaded->work = work;
      const auto make = [&] {
        loaded->bodies.clear();
        return makeSession(loaded->work, packages_, job->cancelled, show, loaded->bodies);
      };
      std::unique_ptr<session::Session> session;
      try {
        session = make();
      } catch (const std::exception&) {
        if (!options.lenient || job->cancelled) throw;
        loaded->left_out = leaveOutUnreadable(loaded->work, packages_);
        if (loaded->left_out.isEmpty() || loaded->work.showsNothing()) throw;
        session = make();
      }
      if (options.places) placeRobots(*session, *loaded);
      const bool by_default = place(*session, *loaded, options.places);
      loaded->files = filesOf(session->description());
      loaded->notes = run::notesOf(*session);
      if (by_default) loaded->notes.insert(loaded->notes.begin(), defaultNote());
      loaded->analysis = analysis::requestFor(*session, optionsOf(loaded->work));
      loaded->depth = depthPeople(*session);
      loaded->reach = RobotReach(*session);
      for (const scene::Object& object : session->scene().objects())
        loaded->structures.push_back(object.spec.structure);
      if (job->cancelled) throw UsageError("abandoned");
      loaded->live = std::make_unique<loop::LiveSession>(std::move(session), t);
      loaded->meshes = ui::prepareMeshes(loaded->live->outline().meshes);
    } catch (const std::exception& e) {
      loaded->problem = QString::fromUtf8(e.what());
    }
    post([this, loaded] {
      current_.reset();
      Q_EMIT finished(loaded);
    });
    job->ended = true;
  });
}

}  // namespace abstand::studio

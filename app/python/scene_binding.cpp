// abstand.Scene.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <cmath>

#include "app/depth/open_session.hpp"
#include "app/python/array_view.hpp"
#include "app/python/interrupt_check.hpp"
#include "app/python/pose_rows.hpp"
#include "app/python/scene_columns.hpp"
#include "app/python/scene_objects.hpp"
#include "app/run/pose_watch.hpp"
#include "app/run/run_scene.hpp"
#include "app/session/times_between.hpp"
#include "core/base/error.hpp"

namespace abstand::python {
namespace {

/// abstand.Scene
struct SceneHandle {
  std::unique_ptr<session::Session> session;
  std::atomic<bool> busy{false};
};

/// Ensures that only one thread at a time steps a scene.
class Turn {
 public:
  explicit Turn(SceneHandle& scene) : scene_(scene) {
    if (scene.busy.exchange(true))
      throw std::runtime_error("another thread is using this Scene; use one Scene per thread");
  }
  ~Turn() { scene_.busy = false; }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  SceneHandle& scene_;
};

/// abstand.StepResult and abstand.SceneRun; their content is set as attributes.
struct StepResult {};
struct SceneRun {};

struct OpenArguments {
  std::optional<std::filesystem::path> recording, poses;
  int threads;
  bool cache, cold;
  double person_speed;
  std::vector<std::filesystem::path> package_paths;
  std::optional<double> tolerance;
};

std::unique_ptr<SceneHandle> openScene(const std::filesystem::path& path, const OpenArguments& args) {
  if (args.threads < 0 || args.threads > scene::Scene::kMaxThreads)
    throw UsageError("threads: found " + std::to_string(args.threads) + ", expected 0 to " +
                     std::to_string(scene::Scene::kMaxThreads));
  if (!(args.person_speed >= 0.01 && args.person_speed <= 100.0))
    throw UsageError("person_speed: expected 0.01 to 100");
  session::SessionOptions options;
  options.recording = args.recording.value_or("");
  options.poses = args.poses.value_or("");
  options.threads = args.threads;
  options.cache = args.cache;
  options.person_speed = args.person_speed;
  if (args.cold) options.remember = false;
  options.far_tolerance = args.tolerance;
  const py::gil_scoped_release release;
  auto handle = std::make_unique<SceneHandle>();
  buildInterruptibly([&](const structure::BuildMonitor& monitor) {
    options.monitor = monitor;
    handle->session = depth::openSession(scene_file::loadScene(path, {args.package_paths, true}), options);
  });
  return handle;
}

std::vector<std::string> allColumns() {
  std::vector<std::string> names;
  for (const SceneColumn& c : sceneColumns()) names.emplace_back(c.name);
  return names;
}

py::object step(SceneHandle& scene, double t, bool cold) {
  if (!std::isfinite(t)) throw UsageError("t: expected seconds");
  const Turn turn(scene);
  session::Session& session = *scene.session;
  SceneTable table(session, allColumns(), std::nullopt);
  {
    const py::gil_scoped_release release;
    if (cold) session.scene().startCold();
    session.step(t);
    table.store(session, 0);
  }
  py::object result = py::cast(StepResult());
  result.attr("t") = t;
  table.giveTo(result);
  return result;
}

std::vector<double> framesOf(const session::Session& session, std::optional<double> start,
                             std::optional<double> end, std::optional<double> rate) {
  if (rate && !(*rate >= 0.001 && *rate <= 1e6)) throw UsageError("rate: expected 0.001 to 1000000 Hz");
  return session::timesBetween(rate ? session.frameTimes(*rate) : session.frameTimes(), start, end);
}

/// Frames at any times, in blocks that start cold.
std::vector<run::Reservation> runTimes(session::Session& session, const std::vector<double>& times,
                                       SceneTable& table) {
  InterruptCheck interrupt;
  run::PoseWatch watch(session);
  for (std::size_t i = 0; i < times.size(); ++i) {
    interrupt.poll();
    if (i % run::kColdStart == 0) session.scene().startCold();
    session.step(times[i]);
    watch.cycle(times[i]);
    table.store(session, i);
  }
  std::vector<run::Reservation> out = run::reservationsOf(session);
  run::addReservations(out, watch.reservations());
  return out;
}

/// The frames of the scene, as in `abstand run --react off`.
std::vector<run::Reservation> runFrames(session::Session& session, const run::RunOptions& asked,
                                        SceneTable& table) {
  InterruptCheck interrupt;
  std::size_t row = 0;
  run::RunOptions options = asked;
  options.interrupted = [&] {
    interrupt.poll();
    return false;
  };
  options.on_cycle = [&](double, const std::vector<query::PairResult>&) { table.store(session, row++); };
  return run::runScene(session, options).reservations;
}

py::list reservationList(const std::vector<run::Reservation>& reservations) {
  using namespace py::literals;
  py::list out;
  for (const run::Reservation& r : reservations)
    out.append(py::dict("kind"_a = r.kind, "text"_a = r.text, "t0"_a = r.t0, "t1"_a = r.t1,
                        "share"_a = r.share, "fails"_a = run::severityName(r.fails)));
  return out;
}

py::object runScene(SceneHandle& scene, const std::optional<std::vector<double>>& times,
                    std::optional<double> start, std::optional<double> end, std::optional<double> rate,
                    const std::vector<std::string>& fields) {
  const Turn turn(scene);
  session::Session& session = *scene.session;
  if (times && (start || end || rate)) throw UsageError("times: expected no start, end or rate beside them");
  const std::vector<double> t = times ? *times : framesOf(session, start, end, rate);
  for (std::size_t i = 0; i < t.size(); ++i)
    if (!std::isfinite(t[i])) throw UsageError("times[" + std::to_string(i) + "]: expected seconds");
  SceneTable table(session, fields, t.size());
  std::vector<run::Reservation> reservations;
  {
    run::RunOptions options;
    options.start = start;
    options.end = end;
    options.rate = rate;
    const py::gil_scoped_release release;
    reservations = times ? runTimes(session, t, table) : runFrames(session, options, table);
  }
  py::object result = py::cast(SceneRun());
  result.attr("t") = arrayOf(t.data(), static_cast<py::ssize_t>(t.size()));
  result.attr("reservations") = reservationList(reservations);
  table.giveTo(result);
  return result;
}

void setPose(SceneHandle& scene, const std::string& name, const py::object& X, double t, double reach) {
  const Transform X_WB = PoseRows(X, "X").only();
  if (!std::isfinite(t)) throw UsageError("t: expected seconds");
  if (!(reach >= 0.0)) throw UsageError("reach: expected metres, 0 or more");
  const Turn turn(scene);
  scene::Scene& s = scene.session->scene();
  ObjectId id(0);
  const scene::Object* object = s.find(name, &id);
  if (object == nullptr) throw UsageError("name: the scene has no object '" + name + "'");
  if (object->spec.group != "objects" || scene.session->posed(id))
    throw UsageError("name: '" + name + "' is moved by the scene, expected one of its `objects`");
  s.setPose(id, X_WB, t);
  s.setPoseUncertainty(id, reach);
}

py::list pairNames(const SceneHandle& scene) {
  const scene::Scene& s = scene.session->scene();
  py::list out;
  for (const scene::Pair& p : s.pairs())
    out.append(py::make_tuple(s.object(p.a).spec.name, s.object(p.b).spec.name));
  return out;
}

py::array_t<std::int32_t> pairIndices(const SceneHandle& scene) {
  const auto& pairs = scene.session->scene().pairs();
  py::array_t<std::int32_t> out({static_cast<py::ssize_t>(pairs.size()), py::ssize_t{2}});
  std::int32_t* data = out.mutable_data();
  for (const scene::Pair& p : pairs) {
    *data++ = static_cast<std::int32_t>(p.a.index());
    *data++ = static_cast<std::int32_t>(p.b.index());
  }
  return out;
}

std::vector<std::string> objectTexts(const SceneHandle& scene, std::string scene::ObjectSpec::*which) {
  std::vector<std::string> out;
  for (const scene::Object& o : scene.session->scene().objects()) out.push_back(o.spec.*which);
  return out;
}

void bindFacts(py::class_<SceneHandle>& type) {
  type.def_property_readonly(
          "objects", [](const SceneHandle& s) { return objectTexts(s, &scene::ObjectSpec::name); },
          "Names of the bodies, in the order of the arrays of objects.")
      .def_property_readonly(
          "groups", [](const SceneHandle& s) { return objectTexts(s, &scene::ObjectSpec::group); },
          "The mechanism or person that each body belongs to, or 'objects'.")
      .def_property_readonly(
          "pairs", &pairNames,
          "(a, b), names of the two bodies of each pair, in the order of the arrays of pairs.")
      .def_property_readonly("pair_indices", &pairIndices,
                             "(pairs, 2) int32: the same as numbers of `objects`.")
      .def_property_readonly(
          "times",
          [](const SceneHandle& s) {
            const auto t = s.session->frameTimes();
            return arrayOf(t.data(), static_cast<py::ssize_t>(t.size()));
          },
          "(n,), s: the frames of the scene's recording or motion.")
      .def_property_readonly(
          "remarks", [](const SceneHandle& s) { return s.session->remarks(); },
          "Remarks on meshes, guesses and gaps; a list of lines.")
      .def_property_readonly(
          "reservations",
          [](const SceneHandle& s) { return reservationList(run::reservationsOf(*s.session)); },
          R"doc(What weakens every verdict about the scene, before a frame is run.

A list of dicts: kind, text, t0, t1, share, fails ('always', 'strict', 'never').)doc")
      .def_property_readonly(
          "memory", [](const SceneHandle& s) { return s.session->scene().memoryBytes(); },
          "Bytes of all structures.")
      .def("__repr__", [](const SceneHandle& s) {
        return "<abstand.Scene of " + std::to_string(s.session->scene().objectCount()) + " bodies and " +
               std::to_string(s.session->scene().pairs().size()) + " pairs>";
      });
}

constexpr const char* kSceneDoc = R"doc(A scene file with its robots, people and things, ready to step.

Scene(path, recording=None, poses=None, threads=0, cache=True, cold=False, person_speed=1.0, package_paths=(),
      tolerance=None)

recording: replaces that of every person. poses: a CSV that named bodies follow. threads: 0 is all cores; the bits do not depend on
it. cache: keep structures in the user's cache folder. cold: cold starts, each step depends on its poses alone (slower). tolerance:
0 to 0.1; with warm starts, a distance beyond 0.1 m may exceed the smallest one by this share, which `bound` includes; None: that of
the scene file, else 0.002. Robots with a `reaction` follow their motion.

One thread at a time; another one gets a RuntimeError. ParseError, UsageError.)doc";

constexpr const char* kStepResultDoc =
    R"doc(A scene at one moment, as arrays in the order of Scene.pairs and Scene.objects; world frame, SI.

t: s.
Of pairs: distance (m, signed), bound (m), reach (m, by how much the bodies may be nearer as their places are not known; inf:
anywhere), at_least (m, distance - bound - reach: what is certain), fresh (bool, both poses are known; only then, and by at_least,
may a distance count as safe), point_a, point_b (m), force (N, on a), torque_a, torque_b (N m, about the centres of mass), depth (m),
contacts (int32).
Of objects: X (4, 4), pose_states (uint8: 0 fresh, 1 inferred, 2 stale, 3 rejected), object_reach (m), object_force (N),
object_torque (N m), colliding (bool).
Of joints: joint_positions (rad, m), joint_efforts (N m, N: what the contacts cause).)doc";

constexpr const char* kRunDoc = R"doc(Runs the scene over its frames, or over `times`, and gives a SceneRun.

times: (n,), s; None: the frames from start to end (s) of the recording, or at `rate` (Hz), with the numbers of `abstand run
--react off`. Every 128 frames begin cold, so the bits depend on the frames alone. fields: names of StepResult's arrays; each comes
with a first dimension of n. Releases the GIL; Ctrl-C ends it.)doc";

}  // namespace

void bindScenes(py::module_& module) {
  py::class_<StepResult>(module, "StepResult", py::dynamic_attr(), kStepResultDoc);
  py::class_<SceneRun>(module, "SceneRun", py::dynamic_attr(),
                       R"doc(A scene over n moments: t (n,), and the arrays that were asked for.

They are those of StepResult with a first dimension of n. reservations: what weakens the run, a list of dicts as in
Scene.reservations; those whose `fails` is 'always' say that something was not known at all.)doc");
  py::class_<SceneHandle> type(module, "Scene", kSceneDoc);
  type.def(py::init([](const std::filesystem::path& path, std::optional<std::filesystem::path> recording,
                       std::optional<std::filesystem::path> poses, int threads, bool cache, bool cold,
                       double person_speed, std::vector<std::filesystem::path> package_paths,
                       std::optional<double> tolerance) {
             return openScene(path, {std::move(recording), std::move(poses), threads, cache, cold,
                                     person_speed, std::move(package_paths), tolerance});
           }),
           py::arg("path"), py::arg("recording") = py::none(), py::arg("poses") = py::none(),
           py::arg("threads") = 0, py::arg("cache") = true, py::arg("cold") = false,
           py::arg("person_speed") = 1.0, py::arg("package_paths") = std::vector<std::filesystem::path>(),
           py::arg("tolerance") = py::none())
      .def("step", &step, py::arg("t"), py::arg("cold") = false,
           R"doc(Moves everything to time t (s) and gives a StepResult. Releases the GIL.

cold: from nothing but the poses; else pairs start from their last answer, and numbers depend, within `bound`, on the steps before.)doc")
      .def("run", &runScene, py::arg("times") = py::none(), py::arg("start") = py::none(),
           py::arg("end") = py::none(), py::arg("rate") = py::none(),
           py::arg("fields") = std::vector<std::string>{"distance", "bound", "reach", "at_least", "fresh"},
           kRunDoc)
      .def("set_pose", &setPose, py::arg("name"), py::arg("X"), py::arg("t") = 0.0, py::arg("reach") = 0.0,
           R"doc(Puts one of the scene's `objects` to X (4, 4) from the next step on.

t: s, of that pose; velocities come from it. reach: m, by how much it may be elsewhere. UsageError for a body that the scene moves.)doc");
  bindFacts(type);
}

}  // namespace abstand::python

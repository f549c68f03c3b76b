// abstand.Human, abstand.JOINTS, abstand.PARTS.
#include <pybind11/stl.h>

#include <cmath>

#include "app/python/array_view.hpp"
#include "app/python/bodies.hpp"
#include "app/python/pose_rows.hpp"
#include "core/base/error.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "humanmodel/poser.hpp"

namespace abstand::python {
namespace {

namespace hm = abstand::humanmodel;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using States = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

constexpr auto kJoints = static_cast<py::ssize_t>(hm::kJointCount);
constexpr auto kParts = static_cast<py::ssize_t>(hm::kBodyPartCount);

/// abstand.HumanPoses: arrays of n times.
struct HumanPoses {
  explicit HumanPoses(std::size_t n);
  void store(std::size_t i, const hm::HumanPose& pose);
  py::array_t<double> X, age, spread, reach;
  py::array_t<std::uint8_t> states;
};

py::array_t<double> table(std::size_t n) {
  return py::array_t<double>({static_cast<py::ssize_t>(n), kParts});
}

HumanPoses::HumanPoses(std::size_t n)
    : X({static_cast<py::ssize_t>(n), kParts, py::ssize_t{4}, py::ssize_t{4}}),
      age(table(n)),
      spread(table(n)),
      reach(table(n)),
      states({static_cast<py::ssize_t>(n), kParts}) {}

void HumanPoses::store(std::size_t i, const hm::HumanPose& pose) {
  for (std::size_t k = 0; k < hm::kBodyPartCount; ++k) {
    const std::size_t at = i * hm::kBodyPartCount + k;
    double* matrix = X.mutable_data() + 16 * at;
    if (pose.state[k] == hm::PartState::kNone)
      std::fill_n(matrix, 16, kNaN);
    else
      storePose(pose.X_WP[k], matrix);
    states.mutable_data()[at] = static_cast<std::uint8_t>(pose.state[k]);
    age.mutable_data()[at] = pose.age[k];
    spread.mutable_data()[at] = pose.spread[k];
    reach.mutable_data()[at] = hm::partUncertainty(pose.age[k], pose.spread[k]);
  }
}

hm::HumanModel modelOf(std::optional<double> stature, const std::string& preset,
                       const std::optional<std::string>& sex, std::optional<double> mass,
                       std::optional<double> percentile) {
  hm::HumanOptions options;
  options.height = stature;
  options.mass = mass;
  options.percentile = percentile;
  if (preset != "anthropometric" && preset != "thesis")
    throw UsageError("preset: found '" + preset + "', expected anthropometric or thesis");
  if (preset == "thesis") options.preset = hm::HumanPreset::kThesis;
  if (sex && *sex != "f" && *sex != "m") throw UsageError("sex: found '" + *sex + "', expected f, m or None");
  if (sex) options.sex = *sex == "f" ? hm::Sex::kFemale : hm::Sex::kMale;
  return hm::makeHuman(options);
}

/// A frame from arrays: a missing joint, or one with a value that is not finite, is unknown.
hm::SkeletonFrame frameOf(double t, const double* joints, const std::uint8_t* states, const double* spread) {
  hm::SkeletonFrame frame;
  frame.t = t;
  for (std::size_t j = 0; j < hm::kJointCount; ++j) {
    const Vector3d p(joints[3 * j], joints[3 * j + 1], joints[3 * j + 2]);
    const auto state = states == nullptr ? hm::JointState::kTracked : static_cast<hm::JointState>(states[j]);
    if (!p.allFinite() || state == hm::JointState::kMissing) continue;
    frame.set(static_cast<hm::Joint>(j), p, state);
    if (spread != nullptr) frame.spread[j] = spread[j];
  }
  return frame;
}

void needShape(const py::array& array, const char* name, std::vector<py::ssize_t> shape) {
  bool right = array.ndim() == static_cast<py::ssize_t>(shape.size());
  for (py::ssize_t i = 0; right && i < array.ndim(); ++i)
    right = array.shape(i) == shape[static_cast<std::size_t>(i)];
  if (right) return;
  std::string text;
  for (const py::ssize_t n : shape) text += (text.empty() ? "" : ", ") + std::to_string(n);
  throw UsageError(std::string(name) + ": found an array of another shape, expected (" + text + ")");
}

void needStates(const States& states) {
  for (py::ssize_t i = 0; i < states.size(); ++i)
    if (states.data()[i] > static_cast<std::uint8_t>(hm::JointState::kTracked))
      throw UsageError("states: found " + std::to_string(states.data()[i]) +
                       ", expected 0 (missing), 1 (inferred) or 2 (tracked)");
}

py::array_t<double> poseOf(const hm::HumanModel& model, const std::optional<Doubles>& joints,
                           const std::optional<States>& states) {
  hm::SkeletonFrame frame = model.rest;
  if (joints) {
    needShape(*joints, "joints", {kJoints, 3});
    if (states) {
      needShape(*states, "states", {kJoints});
      needStates(*states);
    }
    frame = frameOf(0.0, joints->data(), states ? states->data() : nullptr, nullptr);
  }
  hm::HumanPose pose;
  hm::Poser(model).pose(frame, pose);
  HumanPoses out(1);
  out.store(0, pose);
  return py::reinterpret_borrow<py::array_t<double>>(out.X.attr("__getitem__")(0));
}

HumanPoses posesOf(const hm::HumanModel& model, const py::object& recording, double floor) {
  const auto t = py::cast<Doubles>(recording.attr("t"));
  const auto joints = py::cast<Doubles>(recording.attr("joints"));
  if (t.ndim() != 1) throw UsageError("t: expected an array (n,) of seconds");
  const py::ssize_t n = t.shape(0);
  needShape(joints, "joints", {n, kJoints, 3});
  std::optional<States> states;
  std::optional<Doubles> spread;
  if (py::hasattr(recording, "states")) {
    states = py::cast<States>(recording.attr("states"));
    needShape(*states, "states", {n, kJoints});
    needStates(*states);
  }
  if (py::hasattr(recording, "spread")) {
    spread = py::cast<Doubles>(recording.attr("spread"));
    needShape(*spread, "spread", {n, kJoints});
  }
  HumanPoses out(static_cast<std::size_t>(n));
  std::vector<hm::SkeletonFrame> frames;
  for (py::ssize_t i = 0; i < n; ++i)
    frames.push_back(frameOf(t.at(i), joints.data(i, 0, 0), states ? states->data(i, 0) : nullptr,
                             spread ? spread->data(i, 0) : nullptr));
  hm::Poser poser(model, false, floor);
  std::vector<hm::HumanPose> poses(frames.size());
  {
    const py::gil_scoped_release release;
    poser.calibrate(frames);
    hm::HumanPose pose;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      poser.pose(frames[i], pose);
      poses[i] = pose;
    }
  }
  for (std::size_t i = 0; i < poses.size(); ++i) out.store(i, poses[i]);
  return out;
}

py::array_t<double> restOf(const hm::HumanModel& model) {
  py::array_t<double> rest({kJoints, py::ssize_t{3}});
  for (std::size_t j = 0; j < hm::kJointCount; ++j)
    for (int k = 0; k < 3; ++k) rest.mutable_at(static_cast<py::ssize_t>(j), k) = model.rest.p[j][k];
  return rest;
}

template <class Name>
py::tuple namesOf(std::size_t count, Name name) {
  py::tuple names(count);
  for (std::size_t i = 0; i < count; ++i) names[i] = py::str(std::string(name(i)));
  return names;
}

void bindParts(py::module_& module) {
  py::class_<hm::HumanPart>(module, "HumanPart", R"doc(One of the fourteen rigid parts, in its own frame.

Origin at the centre of the shape, z from the distal to the proximal joint (up, when standing with the arms down), x forward,
y left; of a foot x points to the toes.)doc")
      .def_property_readonly(
          "name", [](const hm::HumanPart& p) { return std::string(hm::partName(p.part)); },
          "As in abstand.PARTS.")
      .def_property_readonly(
          "shape", [](const hm::HumanPart& p) { return ShapeBody{p.shape}; }, "An ellipsoid or a cuboid.")
      .def_readonly("length", &hm::HumanPart::length, "m, along the segment.")
      .def_readonly("contour", &hm::HumanPart::contour, "m, circumference at the thickest place.")
      .def_readonly("mass", &hm::HumanPart::mass, "kg.")
      .def_property_readonly(
          "centre_of_mass", [](const hm::HumanPart& p) { return vectorArray(p.com); }, "(3,), m.")
      .def_property_readonly(
          "inertia",
          [](const hm::HumanPart& p) {
            return arrayOf(p.inertia.data(), 9).reshape({3, 3});
          },
          "(3, 3), kg m^2, about the centre of mass.")
      .def_property_readonly(
          "proximal", [](const hm::HumanPart& p) { return std::string(hm::jointName(p.proximal)); },
          "Name of the joint that is nearer to the trunk.")
      .def_property_readonly(
          "distal", [](const hm::HumanPart& p) { return std::string(hm::jointName(p.distal)); },
          "Name of the joint that is farther from it.")
      .def("__repr__", [](const hm::HumanPart& p) {
        return "<abstand.HumanPart '" + std::string(hm::partName(p.part)) + "'>";
      });
  py::class_<HumanPoses>(module, "HumanPoses", "Poses of the fourteen parts at n times, as arrays.")
      .def_readonly("X", &HumanPoses::X, R"doc((n, 14, 4, 4): takes points of a part into the world.

NaN for a part that was not seen yet. A part that is held stands where it was seen last: look at `states` and `reach`.)doc")
      .def_readonly("states", &HumanPoses::states,
                    "(n, 14) uint8: 0 never seen, 1 held (stale), 2 inferred, 3 tracked. Only 3 is measured.")
      .def_readonly("age", &HumanPoses::age, "(n, 14), s since the part was last seen; inf before that.")
      .def_readonly("spread", &HumanPoses::spread, "(n, 14), m, standard deviation; 0: unknown.")
      .def_readonly("reach", &HumanPoses::reach,
                    R"doc((n, 14), m: by how much a part may be elsewhere, by its age at 2 m/s and its spread.

To be taken from a distance before it counts as safe; inf for a part that was never seen.)doc")
      .def("__len__", [](const HumanPoses& p) { return p.X.shape(0); });
}

constexpr const char* kHumanDoc = R"doc(A person of fourteen rigid parts, from the stature.

Human(stature=None, preset='anthropometric', sex=None, mass=None, percentile=None)

stature: m, 0.5 to 2.5; None: that of the percentile, else 1.75. preset: 'anthropometric' or 'thesis'. sex: 'f', 'm' or None, the mean
of both. mass: kg; None: the body mass index of the percentile, else of the mean person, at that stature. percentile: per cent, 1 to 99, of
ANSUR II (2012), of that sex or of both together: girths, breadths and depths that enclose those of so many people of that stature, and of
that mass where it is given; lengths stay means; only with 'anthropometric'. UsageError for what is out of range. Constant.)doc";

}  // namespace

void bindHumans(py::module_& module) {
  module.attr("JOINTS") =
      namesOf(hm::kJointCount, [](std::size_t i) { return hm::jointName(static_cast<hm::Joint>(i)); });
  module.attr("PARTS") =
      namesOf(hm::kBodyPartCount, [](std::size_t i) { return hm::partName(static_cast<hm::BodyPart>(i)); });
  bindParts(module);
  py::class_<hm::HumanModel>(module, "Human", kHumanDoc)
      .def(py::init(&modelOf), py::arg("stature") = py::none(), py::arg("preset") = "anthropometric",
           py::arg("sex") = py::none(), py::arg("mass") = py::none(), py::arg("percentile") = py::none())
      .def_readonly("stature", &hm::HumanModel::height, "m.")
      .def_readonly("mass", &hm::HumanModel::mass, "kg.")
      .def_property_readonly(
          "parts", [](const hm::HumanModel& h) { return h.parts; },
          "The fourteen HumanParts, in the order of abstand.PARTS.")
      .def_property_readonly(
          "rest", &restOf,
          R"doc((22, 3), m: the joints, in the order of abstand.JOINTS, of one who stands with the arms down.

Facing +x, feet on z = 0, pelvis over the origin. NaN for a joint that the model does not have.)doc")
      .def("pose", &poseOf, py::arg("joints") = py::none(), py::arg("states") = py::none(),
           R"doc((14, 4, 4): the poses of the parts for one moment by itself.

joints: (22, 3), m, world, in the order of abstand.JOINTS; NaN: not known; None: standing, as in `rest`. states: (22,), 0 missing,
1 inferred, 2 tracked. The pose of a part that the joints do not show is NaN. The joints' directions count; lengths are the
model's.)doc")
      .def("poses", &posesOf, py::arg("recording"), py::arg("floor") = 0.0,
           R"doc(HumanPoses: the parts at each frame of a Recording.

recording: of read_recording(), or anything with arrays t (n,), joints (n, 22, 3) and, if it has them, states (n, 22) and spread
(n, 22). A part that is not seen for a while is held, and marked so. floor: height of the floor, m. Releases the GIL.)doc")
      .def("__repr__", [](const hm::HumanModel& h) {
        return "<abstand.Human of " + std::string(py::str(py::float_(h.height))) + " m>";
      });
}

}  // namespace abstand::python

// abstand.read_recording, abstand.Recording.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/array_view.hpp"
#include "app/python/scene_objects.hpp"
#include "tracking/tracker/tracked_recording.hpp"

namespace abstand::python {
namespace {

using Frame = humanmodel::SkeletonFrame;
using tracking::Recording;

constexpr auto kJoints = static_cast<py::ssize_t>(humanmodel::kJointCount);

/// A view of one member over all frames, with `columns` values each.
template <class T, class Member>
py::array columnsOf(py::handle self, Member member, std::vector<py::ssize_t> columns,
                    std::vector<py::ssize_t> strides) {
  const auto& frames = py::cast<const Recording&>(self).frames;
  columns.insert(columns.begin(), static_cast<py::ssize_t>(frames.size()));
  strides.insert(strides.begin(), sizeof(Frame));
  const T* first = frames.empty() ? nullptr : reinterpret_cast<const T*>(&(frames.front().*member));
  return viewOf(first, std::move(columns), std::move(strides), self);
}

Recording read(const std::filesystem::path& path, const tracking::RecordingOptions& options,
               std::optional<double> stature) {
  Recording recording = tracking::openAnyRecording(path, options, stature);
  // Unknown values are set to NaN, whatever a reader left there.
  for (Frame& frame : recording.frames)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if (frame.state[j] == humanmodel::JointState::kMissing) frame.p[j].setConstant(kNaN);
  return recording;
}

py::object subjectOf(const tracking::SubjectFacts& s) {
  using namespace py::literals;
  if (s.empty()) return py::none();
  return py::dict("name"_a = s.name, "height"_a = s.height, "mass"_a = s.mass, "sizes"_a = s.sizes);
}

py::dict factsOf(const tracking::RecordingReport& r) {
  using namespace py::literals;
  return py::dict(
      "format"_a = r.format, "rate"_a = r.rate, "rate_reason"_a = r.rate_reason, "duration"_a = r.duration,
      "units"_a = r.units.name, "units_reason"_a = r.units.reason, "units_guessed"_a = r.units.guessed,
      "scale"_a = r.scale, "up"_a = r.up.axis, "up_reason"_a = r.up.reason, "up_guessed"_a = r.up.guessed,
      "sides"_a = r.sides.found, "sides_reason"_a = r.sides.reason, "stature"_a = r.stature,
      "stature_reason"_a = r.person.stature_reason, "subject"_a = subjectOf(r.person.subject),
      "joint_map"_a = r.joint_map, "joints"_a = r.joints, "mapped"_a = r.mapped,
      "not_mapped"_a = r.not_mapped, "missing_parts"_a = r.missing_parts,
      "frames_missing"_a = r.frames_missing, "gaps"_a = r.gaps, "swaps"_a = r.swaps,
      "lowest_foot"_a = r.lowest_foot, "repairs"_a = r.repairs, "joint_map_reason"_a = r.map_use.reason,
      "joints_guessed"_a = r.map_use.is_guess, "notes"_a = r.notes, "warnings"_a = r.warnings);
}

py::tuple jointNames() {
  py::tuple names(humanmodel::kJointCount);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    names[j] = py::str(std::string(humanmodel::jointName(static_cast<humanmodel::Joint>(j))));
  return names;
}

constexpr const char* kReadDoc =
    R"doc(Reads a recorded person: BVH, Acclaim, C3D, TRC, Kinect, CSV, JSON lines, depth images.

format, units, up, mirror, marker_set: 'auto' (mirror: 'none') or what `abstand skeleton --help` names; rate: Hz, 0: what the file
says; joint_map: a file; skeleton: the ASF of an AMC; stature: m, of the body that is fitted to depth images;
repair: bones that a conversion to BVH has lost are put in. What was guessed,
and why, is in `facts`. ParseError for the file, UsageError for the options. Releases the GIL.)doc";

}  // namespace

void bindRecordings(py::module_& module) {
  py::class_<Recording>(module, "Recording",
                        R"doc(A recorded person: canonical joints, metres, z up. Constant.

The arrays are read-only views without copies. A joint that is not known in a frame is NaN, and its state 0.)doc")
      .def_property_readonly(
          "t", [](py::handle self) { return columnsOf<double>(self, &Frame::t, {}, {}); }, "(n,), s, rising.")
      .def_property_readonly(
          "joints",
          [](py::handle self) {
            return columnsOf<double>(self, &Frame::p, {kJoints, 3}, {sizeof(Vector3d), sizeof(double)});
          },
          "(n, 22, 3), m, in the order of abstand.JOINTS; NaN where a joint is unknown.")
      .def_property_readonly(
          "states",
          [](py::handle self) { return columnsOf<std::uint8_t>(self, &Frame::state, {kJoints}, {1}); },
          "(n, 22) uint8: 0 missing, 1 inferred (guessed), 2 tracked.")
      .def_property_readonly(
          "spread",
          [](py::handle self) {
            return columnsOf<double>(self, &Frame::spread, {kJoints}, {sizeof(double)});
          },
          "(n, 22), m, standard deviation along the worst axis; 0: unknown.")
      .def_property_readonly(
          "names", [](const Recording&) { return jointNames(); }, "Names of the joints, as abstand.JOINTS.")
      .def_property_readonly(
          "facts", [](const Recording& r) { return factsOf(r.report); },
          "What was understood of the file, and why: format, rate, units, up, stature, mapped, gaps, ...")
      .def_property_readonly(
          "warnings", [](const Recording& r) { return r.report.warnings; },
          "What is doubtful about it, a list of lines.")
      .def("__len__", [](const Recording& r) { return r.frames.size(); })
      .def("__repr__", [](const Recording& r) {
        return "<abstand.Recording of " + std::to_string(r.frames.size()) + " frames, " + r.report.format +
               ">";
      });
  module.def(
      "read_recording",
      [](const std::filesystem::path& path, const std::string& format, const std::string& units,
         const std::string& up, double rate, const std::optional<std::filesystem::path>& joint_map,
         const std::string& mirror, const std::optional<std::filesystem::path>& skeleton,
         const std::string& marker_set, std::optional<double> stature, bool repair) {
        tracking::RecordingOptions options;
        options.format = format;
        options.units = units;
        options.up = up;
        options.rate = rate;
        options.joint_map = joint_map.value_or("");
        options.mirror = mirror;
        options.skeleton = skeleton.value_or("");
        options.marker_set = marker_set;
        options.repair = repair;
        const py::gil_scoped_release release;
        return read(path, options, stature);
      },
      py::arg("path"), py::kw_only(), py::arg("format") = "auto", py::arg("units") = "auto",
      py::arg("up") = "auto", py::arg("rate") = 0.0, py::arg("joint_map") = py::none(),
      py::arg("mirror") = "none", py::arg("skeleton") = py::none(), py::arg("marker_set") = "auto",
      py::arg("stature") = py::none(), py::arg("repair") = true, kReadDoc);
}

}  // namespace abstand::python

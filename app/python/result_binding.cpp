// abstand.read_result, abstand.Result.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/array_view.hpp"
#include "app/python/scene_objects.hpp"
#include "app/tune/result_file.hpp"
#include "app/tune/stored_pairs.hpp"

namespace abstand::python {
namespace {

/// A stored result with the values of its pairs in all frames.
struct PairResultFile {
  tune::StoredResult stored;
  tune::StoredPairs pairs;
  std::vector<double> closing_speed;  ///< m/s
  std::vector<std::int32_t> indices;  ///< of each pair: part, link
  std::vector<std::int32_t> tools;    ///< of each pair: index of the tool in the hand; -1: the part itself
  /// Of each frame and part: force (N), energy (J), pressure (Pa), share of the limit; index of the region,
  /// or -1.
  std::vector<double> contact;
  std::vector<std::int32_t> region;

  std::size_t frames() const { return stored.tuned.frames; }
  std::size_t width() const { return stored.tuned.pass.pairs.size(); }
  std::size_t parts() const { return stored.tuned.pass.parts.size(); }
};

PairResultFile readPairResult(const std::filesystem::path& path) {
  PairResultFile file{tune::readResult(path), {}, {}, {}, {}, {}, {}};
  file.pairs = tune::StoredPairReader(file.stored.tuned).rows(0, file.frames());
  for (std::size_t i = 0; i < file.pairs.robot_speed.size(); ++i)
    file.closing_speed.push_back(file.pairs.robot_speed[i] + file.pairs.person_speed[i]);
  for (const auto& pair : file.stored.tuned.pass.pairs) {
    file.indices.insert(file.indices.end(), {pair.part, pair.link});
    file.tools.push_back(pair.tool == tune::kNoTool ? -1 : pair.tool);
  }
  for (std::size_t i = 0; i < file.frames(); ++i)
    for (const tune::PartClearance& part : file.stored.tuned.pass.parts) {
      const tune::FrameContact& c = part.contact[i];
      file.contact.insert(file.contact.end(), {c.force, c.energy, c.pressure, c.share});
      file.region.push_back(c.region == tune::kNoRegion ? -1 : c.region);
    }
  return file;
}

/// A view (frames, pairs) or, with `columns` > 1, (frames, pairs, columns).
py::array tableOf(py::handle self, const std::vector<double>& values, py::ssize_t columns = 1) {
  const auto& file = py::cast<const PairResultFile&>(self);
  const auto frames = static_cast<py::ssize_t>(file.frames()), pairs = static_cast<py::ssize_t>(file.width());
  constexpr py::ssize_t kSize = sizeof(double);
  std::vector<py::ssize_t> shape{frames, pairs}, strides{pairs * columns * kSize, columns * kSize};
  if (columns > 1) shape.push_back(columns), strides.push_back(kSize);
  return viewOf(values.data(), std::move(shape), std::move(strides), self);
}

py::dict optionsOf(const PairResultFile& file) {
  using namespace py::literals;
  const tune::PassOptions& o = file.stored.options.pass;
  return py::dict("limit"_a = o.limit, "near"_a = o.near, "reaction_time"_a = o.braking.reaction_time,
                  "deceleration"_a = o.braking.deceleration, "calibration_error"_a = o.calibration_error,
                  "latency"_a = o.latency, "contact_limits"_a = file.stored.tuned.contact_limits,
                  "clamped"_a = file.stored.tuned.clamped);
}

constexpr const char* kResultDoc =
    R"doc(One recording beside robots, as `abstand tune --out` stored it: every pair of a body part and a link. Constant.

The arrays are read-only views, a row a frame and a column a pair; numbers are rounded to the safe side (docs/margins.md).)doc";
constexpr const char* kReadResultDoc =
    R"doc(Reads a result file of `abstand tune --out` (FOLDER/results/KEY.h5): the numbers of `abstand export --pairs-csv`.

ParseError where it is no such file, damaged, or of another version. Keeps the GIL.)doc";

using PairTable = std::vector<double> tune::StoredPairs::*;

void addContacts(py::class_<PairResultFile>& result) {
  result
      .def_property_readonly(
          "regions", [](const PairResultFile& f) { return f.stored.tuned.pass.regions; },
          "Names of the regions of the table of contact limits that occur in `contact`.")
      .def_property_readonly(
          "contact_region",
          [](py::handle self) {
            const auto& f = py::cast<const PairResultFile&>(self);
            constexpr py::ssize_t kSize = sizeof(std::int32_t);
            const auto frames = static_cast<py::ssize_t>(f.frames()),
                       parts = static_cast<py::ssize_t>(f.parts());
            return viewOf(f.region.data(), {frames, parts}, {parts * kSize, kSize}, self);
          },
          "(frames, parts) int32: index into `regions`; -1: nothing near closes in, or the part is not seen.")
      .def_property_readonly(
          "contact",
          [](py::handle self) {
            const auto& f = py::cast<const PairResultFile&>(self);
            constexpr py::ssize_t kSize = sizeof(double), kColumns = 4;
            const auto frames = static_cast<py::ssize_t>(f.frames()),
                       parts = static_cast<py::ssize_t>(f.parts());
            return viewOf(f.contact.data(), {frames, parts, kColumns},
                          {parts * kColumns * kSize, kColumns * kSize, kSize}, self);
          },
          "(frames, parts, 4): force (N), energy (J), pressure (Pa) and share of the limit of the hardest "
          "contact that "
          "could occur; zeros where nothing near closes in; an infinite share is an excluded or unknown "
          "contact.");
}

}  // namespace

void bindResults(py::module_& module) {
  py::class_<PairResultFile> result(module, "Result", kResultDoc);
  const auto table = [&](const char* name, PairTable member, const char* doc, py::ssize_t columns = 1) {
    result.def_property_readonly(
        name,
        [member, columns](py::handle self) {
          return tableOf(self, py::cast<const PairResultFile&>(self).pairs.*member, columns);
        },
        doc);
  };
  using tune::StoredPairs;
  result
      .def_property_readonly(
          "recording", [](const PairResultFile& f) { return f.stored.tuned.recording; }, "Name of the run.")
      .def_property_readonly(
          "parts",
          [](const PairResultFile& f) {
            std::vector<std::string> parts;
            for (const auto& p : f.stored.tuned.pass.parts) parts.push_back(p.part);
            return parts;
          },
          "Names of body parts.")
      .def_property_readonly(
          "links", [](const PairResultFile& f) { return f.stored.tuned.pass.links; }, "Names of links.")
      .def_property_readonly(
          "pairs",
          [](py::handle self) {
            const auto& f = py::cast<const PairResultFile&>(self);
            constexpr py::ssize_t kSize = sizeof(std::int32_t);
            return viewOf(f.indices.data(), {static_cast<py::ssize_t>(f.width()), 2}, {2 * kSize, kSize},
                          self);
          },
          "(pairs, 2) int32: indices into `parts` and `links`.")
      .def_property_readonly(
          "tools", [](const PairResultFile& f) { return f.stored.tuned.pass.tools; },
          "Names of the tools in people's hands.")
      .def_property_readonly(
          "pair_tools",
          [](py::handle self) {
            const auto& f = py::cast<const PairResultFile&>(self);
            return viewOf(f.tools.data(), {static_cast<py::ssize_t>(f.width())}, {sizeof(std::int32_t)},
                          self);
          },
          "(pairs,) int32: index into `tools` for a pair of the tool in the hand; -1 for the part itself.")
      .def_property_readonly(
          "t",
          [](py::handle self) {
            const auto& f = py::cast<const PairResultFile&>(self);
            return viewOf(f.stored.tuned.pass.parts.front().track.t.data(),
                          {static_cast<py::ssize_t>(f.frames())}, {sizeof(double)}, self);
          },
          "(frames,), s, rising.");
  table("distance", &StoredPairs::distance, "(frames, pairs), m, measured.");
  table("bound", &StoredPairs::bound,
        "(frames, pairs), m: the true distance is never below distance - bound.");
  table("uncertainty", &StoredPairs::uncertainty,
        "(frames, pairs), m, of the person's pose; infinite: the part was not seen.");
  table("clearance", &StoredPairs::clearance,
        "(frames, pairs), m, certified: distance - bound - uncertainty; -inf: unknown.");
  table("robot_speed", &StoredPairs::robot_speed,
        "(frames, pairs), m/s, of the link's nearest point towards the part; 0: moving away.");
  table("person_speed", &StoredPairs::person_speed,
        "(frames, pairs), m/s, of the part's nearest point towards the link; 0: moving away.");
  table("on_part", &StoredPairs::on_part, "(frames, pairs, 3), m, world: nearest points; NaN beyond 0.5 m.",
        3);
  table("on_link", &StoredPairs::on_link, "(frames, pairs, 3), m, world: nearest points; NaN beyond 0.5 m.",
        3);
  result
      .def_property_readonly(
          "closing_speed",
          [](py::handle self) { return tableOf(self, py::cast<const PairResultFile&>(self).closing_speed); },
          "(frames, pairs), m/s: robot_speed + person_speed, never below the true one.")
      .def_property_readonly("options", &optionsOf, "Assumptions: limit, reaction_time, clamped, ...")
      .def("__len__", &PairResultFile::frames)
      .def("__repr__", [](const PairResultFile& f) {
        return "<abstand.Result of " + std::to_string(f.frames()) + " frames and " +
               std::to_string(f.width()) + " pairs>";
      });
  addContacts(result);
  module.def("read_result", &readPairResult, py::arg("path"), kReadResultDoc);
}

}  // namespace abstand::python

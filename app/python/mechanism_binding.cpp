// abstand.Mechanism.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>

#include "app/python/array_view.hpp"
#include "app/python/bodies.hpp"
#include "app/python/interrupt_check.hpp"
#include "app/python/pose_rows.hpp"
#include "core/base/error.hpp"
#include "core/base/parallel.hpp"
#include "core/mechanism/dof_limits.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "core/robot_file/mesh_reference.hpp"

namespace abstand::python {
namespace {

namespace mech = abstand::mechanism;

using JointRows = py::array_t<double, py::array::c_style | py::array::forcecast>;

constexpr std::size_t kRowsABlock = 256;

/// abstand.Mechanism: constant after loading except `scratch`, which is used with the GIL.
struct RobotHandle {
  robot_file::Robot robot;
  mech::MechanismState scratch;
  const mech::Mechanism& mechanism() const { return robot.mechanism; }
};

/// Joint values of one posture, an array (dof,), or of n, (n, dof).
struct Postures {
  Postures(const mech::Mechanism& mechanism, const JointRows& q)
      : single(q.ndim() == 1), dof(static_cast<std::size_t>(mechanism.dof)), data(q.data()) {
    if ((q.ndim() != 1 && q.ndim() != 2) || q.shape(q.ndim() - 1) != mechanism.dof)
      throw UsageError("q: found an array whose last dimension is " +
                       (q.ndim() > 0 ? std::to_string(q.shape(q.ndim() - 1)) : "none") + ", expected (" +
                       std::to_string(dof) + ",) or (n, " + std::to_string(dof) + ")");
    size = single ? 1 : static_cast<std::size_t>(q.shape(0));
    for (std::size_t i = 0; i < size; ++i)
      for (const double x : (*this)[i])
        if (!std::isfinite(x))
          throw UsageError((single ? "q" : "q[" + std::to_string(i) + "]") +
                           ": found a number that is not finite, expected rad or m");
  }
  std::span<const double> operator[](std::size_t i) const { return {data + i * dof, dof}; }

  bool single;
  std::size_t dof, size{0};
  const double* data;
};

void storeFrames(const mech::MechanismState& state, double* out) {
  for (const Transform& X : state.X_BF) {
    storePose(X, out);
    out += 16;
  }
}

/// An array of `size` rows of the shape `row`, or of a single row.
py::array_t<double> rowsOf(const Postures& q, std::vector<py::ssize_t> row) {
  if (!q.single) row.insert(row.begin(), static_cast<py::ssize_t>(q.size));
  return py::array_t<double>(row);
}

/// Calls `store(state, i)` with the forward kinematics of each posture.
template <class Store>
void eachPosture(RobotHandle& robot, const Postures& q, int threads, Store store) {
  if (threads < 0 || threads > 256)
    throw UsageError("threads: found " + std::to_string(threads) + ", expected 0 to 256");
  if (q.single) {
    mech::forward(robot.mechanism(), q[0], robot.scratch);
    store(robot.scratch, 0);
    return;
  }
  const py::gil_scoped_release release;
  InterruptCheck interrupt;
  parallelFor(threads, (q.size + kRowsABlock - 1) / kRowsABlock, [&](std::size_t block) {
    interrupt.poll();
    mech::MechanismState state;
    const std::size_t end = std::min(q.size, (block + 1) * kRowsABlock);
    for (std::size_t i = block * kRowsABlock; i < end; ++i) {
      mech::forward(robot.mechanism(), q[i], state);
      store(state, i);
    }
  });
}

py::array_t<double> fk(RobotHandle& robot, const JointRows& values, int threads) {
  const Postures q(robot.mechanism(), values);
  const std::size_t frames = robot.mechanism().frames.size();
  auto out = rowsOf(q, {static_cast<py::ssize_t>(frames), 4, 4});
  double* data = out.mutable_data();
  eachPosture(robot, q, threads, [&](const mech::MechanismState& state, std::size_t i) {
    storeFrames(state, data + 16 * frames * i);
  });
  return out;
}

int frameIndex(const RobotHandle& robot, py::handle frame) {
  const int count = static_cast<int>(robot.mechanism().frames.size());
  if (py::isinstance<py::str>(frame)) {
    const auto name = py::cast<std::string>(frame);
    const int index = robot.mechanism().indexOf(name);
    if (index < 0) throw UsageError("frame: the mechanism has no frame '" + name + "'");
    return index;
  }
  const int index = py::cast<int>(frame);
  if (index < 0 || index >= count)
    throw UsageError("frame: found " + std::to_string(index) + ", expected 0 to " +
                     std::to_string(count - 1));
  return index;
}

py::array_t<double> jacobianOf(RobotHandle& robot, const JointRows& values, const py::object& frame,
                               int threads) {
  const Postures q(robot.mechanism(), values);
  const int index = frameIndex(robot, frame);
  auto out = rowsOf(q, {6, static_cast<py::ssize_t>(q.dof)});
  double* data = out.mutable_data();
  using RowMajor = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>;
  eachPosture(robot, q, threads, [&](const mech::MechanismState& state, std::size_t i) {
    Eigen::Matrix<double, 6, Eigen::Dynamic> J;
    mech::jacobian(robot.mechanism(), state, index, J);
    Eigen::Map<RowMajor>(data + 6 * q.dof * i, 6, static_cast<Eigen::Index>(q.dof)) = J;
  });
  return out;
}

py::array_t<double> limitsOf(const RobotHandle& robot, double mech::DofLimits::*which) {
  std::vector<double> values;
  for (const mech::DofLimits& l : mech::dofLimits(robot.mechanism())) values.push_back(l.*which);
  return arrayOf(values.data(), static_cast<py::ssize_t>(values.size()));
}

/// (frame name, Mesh or Shape, X_FG) of each geometry of a use.
py::list geometryOf(const RobotHandle& robot, const std::string& use,
                    const std::vector<std::filesystem::path>& package_paths) {
  if (use != "collision" && use != "visual")
    throw UsageError("use: found '" + use + "', expected collision or visual");
  const auto wanted =
      use == "visual" ? robot_file::GeometryUse::kVisual : robot_file::GeometryUse::kCollision;
  robot_file::MeshFinder finder(robot.robot.file, {package_paths, true});
  py::list out;
  for (const robot_file::LinkGeometry& g : robot.robot.geometry) {
    if (g.use != wanted) continue;
    const std::string name =
        g.frame < 0 ? "" : robot.mechanism().frames[static_cast<std::size_t>(g.frame)].name;
    if (g.shape) {
      out.append(py::make_tuple(name, ShapeBody{*g.shape}, poseArray(g.X_FG)));
      continue;
    }
    const auto file = finder.find(g.mesh);
    if (!file) throw ParseError(g.pos, "found no file " + g.mesh);
    auto loaded = mesh_file::loadMesh(*file);
    geometry::stretch(loaded.mesh, g.scale);
    loaded.report = mesh_file::inspect(loaded.mesh);
    out.append(
        py::make_tuple(name, Mesh{std::move(loaded.mesh), std::move(loaded.report)}, poseArray(g.X_FG)));
  }
  return out;
}

void bindFacts(py::class_<RobotHandle>& type) {
  type.def_property_readonly(
          "name", [](const RobotHandle& r) { return r.mechanism().name; }, "As stated in the file.")
      .def_property_readonly(
          "dof", [](const RobotHandle& r) { return r.mechanism().dof; }, "Length of q.")
      .def_property_readonly(
          "frames",
          [](const RobotHandle& r) {
            std::vector<std::string> names;
            for (const auto& f : r.mechanism().frames) names.push_back(f.name);
            return names;
          },
          "Names of the frames, in the order of fk(); parents first.")
      .def_property_readonly(
          "parents",
          [](const RobotHandle& r) {
            std::vector<int> parents;
            for (const auto& f : r.mechanism().frames) parents.push_back(f.parent);
            return parents;
          },
          "Index of each frame's parent; -1: the base.")
      .def_property_readonly(
          "joints", [](const RobotHandle& r) { return mech::dofNames(r.mechanism()); },
          "Names of the degrees of freedom, in the order of q.")
      .def_property_readonly(
          "lower", [](const RobotHandle& r) { return limitsOf(r, &mech::DofLimits::lower); },
          "(dof,), rad or m; -inf where unknown. fk() does not keep q within.")
      .def_property_readonly(
          "upper", [](const RobotHandle& r) { return limitsOf(r, &mech::DofLimits::upper); },
          "(dof,), rad or m; inf where unknown.")
      .def_property_readonly(
          "velocity", [](const RobotHandle& r) { return limitsOf(r, &mech::DofLimits::velocity); },
          "(dof,), rad/s or m/s, largest size; inf where unknown.")
      .def_property_readonly(
          "effort", [](const RobotHandle& r) { return limitsOf(r, &mech::DofLimits::effort); },
          "(dof,), N m or N, largest size; inf where unknown.")
      .def_property_readonly(
          "warnings", [](const RobotHandle& r) { return r.robot.warnings; },
          "What is odd about the file, a list of lines.")
      .def("__repr__", [](const RobotHandle& r) {
        return "<abstand.Mechanism '" + r.mechanism().name + "' of " +
               std::to_string(r.mechanism().frames.size()) + " frames and " +
               std::to_string(r.mechanism().dof) + " degrees of freedom>";
      });
}

}  // namespace

void bindMechanisms(py::module_& module) {
  py::class_<RobotHandle> type(module, "Mechanism",
                               R"doc(A robot's frames and joints, from a .mech file or a URDF.

Mechanism(path). ParseError for a file that is neither. Constant: any number of threads may use one. Joint values are rad and m,
poses are those of the frames in the base.)doc");
  type.def(py::init([](const std::filesystem::path& path) {
             const py::gil_scoped_release release;
             return RobotHandle{robot_file::loadRobot(path), {}};
           }),
           py::arg("path"))
      .def("fk", &fk, py::arg("q"), py::arg("threads") = 1,
           R"doc(Forward kinematics: the pose of every frame in the base.

q: (dof,) gives (frames, 4, 4); (n, dof) gives (n, frames, 4, 4), on `threads` threads (0: all cores) and without the GIL. An array
of contiguous float64 is used without a copy. UsageError for a wrong shape or a number that is not finite.)doc")
      .def("jacobian", &jacobianOf, py::arg("q"), py::arg("frame"), py::arg("threads") = 1,
           R"doc(How a frame moves: (6, dof), or (n, 6, dof) for q of shape (n, dof).

Rows: linear velocity (m/s) of the origin of `frame` (a name or an index), then angular velocity (rad/s), in base axes, for one
unit of each joint's speed. Its transpose times a force and torque at that origin gives joint torques.)doc")
      .def("geometry", &geometryOf, py::arg("use") = "collision",
           py::arg("package_paths") = std::vector<std::filesystem::path>(),
           R"doc(What the file's links look like: a list of (frame name, Mesh or Shape, X).

use: 'collision' or 'visual'. X (4, 4) takes points of the body into the frame ('': the base). package_paths: folders of ROS
packages. ParseError for a mesh that is not there.)doc");
  bindFacts(type);
}

}  // namespace abstand::python

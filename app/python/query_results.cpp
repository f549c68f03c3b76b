#include "app/python/query_results.hpp"

#include "app/python/array_view.hpp"

namespace abstand::python {
namespace {

py::ssize_t count(std::size_t n) { return static_cast<py::ssize_t>(n); }

py::array_t<double> rows(std::size_t n) { return py::array_t<double>({count(n), py::ssize_t{3}}); }

void put(double* column, std::size_t i, const Vector3d& v) {
  for (std::size_t k = 0; k < 3; ++k) column[3 * i + k] = v[static_cast<int>(k)];
}

std::string describe(const Distance& d, const char* name) {
  return "<abstand." + std::string(name) + " " + std::string(py::str(py::float_(d.result.distance))) +
         " m, bound " + std::string(py::str(py::float_(d.result.bound))) + " m>";
}

constexpr const char* kForce =
    "(3,), N, world axes: the penalty force on A. On B acts the opposite, so the sum is zero.";

void bindSingleResults(py::module_& module) {
  py::class_<Distance>(module, "Distance", R"doc(How far two bodies are apart; world frame, SI.

The true distance is never below `distance - bound`, which is `at_least`.)doc")
      .def_property_readonly(
          "distance", [](const Distance& d) { return d.result.distance; },
          "m, between the bare surfaces: positive apart, negative inside (minus the deepest penetration).")
      .def_property_readonly(
          "bound", [](const Distance& d) { return d.result.bound; },
          "m; the true distance is never below distance - bound.")
      .def_property_readonly(
          "at_least", [](const Distance& d) { return d.result.distance - d.result.bound; },
          "m, distance - bound: what is certain.")
      .def_property_readonly(
          "point_a", [](const Distance& d) { return vectorArray(d.result.witness_a); },
          "(3,), m: the nearest point on A, the deepest one inside.")
      .def_property_readonly(
          "point_b", [](const Distance& d) { return vectorArray(d.result.witness_b); },
          "(3,), m: the nearest point on B, the deepest one inside.")
      .def("__float__", [](const Distance& d) { return d.result.distance; })
      .def("__repr__", [](const Distance& d) { return describe(d, "Distance"); });
  py::class_<Contact, Distance>(module, "Contact", "Distance and contact of two bodies; world frame, SI.")
      .def_property_readonly(
          "force", [](const Contact& c) { return vectorArray(c.result.force_a); }, kForce)
      .def_property_readonly(
          "torque_a", [](const Contact& c) { return vectorArray(c.result.torque_a); },
          "(3,), N m, world axes: on A about A's centre of mass.")
      .def_property_readonly(
          "torque_b", [](const Contact& c) { return vectorArray(c.result.torque_b); },
          "(3,), N m, world axes: on B about B's centre of mass.")
      .def_property_readonly(
          "contacts", [](const Contact& c) { return c.result.contacts; },
          "How many points are within the margin; 0: no contact.")
      .def_property_readonly(
          "depth", [](const Contact& c) { return c.result.depth; },
          "m, deepest penetration of the margins, 0 or more.")
      .def("__repr__", [](const Contact& c) { return describe(c, "Contact"); });
}

void bindBatchResults(py::module_& module) {
  py::class_<Distances>(module, "Distances", R"doc(Distances of n poses, as arrays; world frame, SI.

Distances(n) makes room for n answers, to be given as `out`.)doc")
      .def(py::init<std::size_t>(), py::arg("n"))
      .def("__len__", [](const Distances& d) { return d.size; })
      .def_readonly("distance", &Distances::distance, "(n,), m, as Distance.distance.")
      .def_readonly("bound", &Distances::bound, "(n,), m; the true distance is never below distance - bound.")
      .def_property_readonly(
          "at_least", [](const Distances& d) { return d.distance.attr("__sub__")(d.bound); },
          "(n,), m, distance - bound, a new array: what is certain.")
      .def_readonly("point_a", &Distances::point_a, "(n, 3), m: nearest points on A.")
      .def_readonly("point_b", &Distances::point_b, "(n, 3), m: nearest points on B.")
      .def("__repr__",
           [](const Distances& d) { return "<abstand.Distances of " + std::to_string(d.size) + " poses>"; });
  py::class_<Contacts, Distances>(module, "Contacts", R"doc(Distances and contacts of n poses, as arrays.

Contacts(n) makes room for n answers, to be given as `out`.)doc")
      .def(py::init<std::size_t>(), py::arg("n"))
      .def_readonly("force", &Contacts::force, "(n, 3), N: penalty forces on A; on B act the opposite ones.")
      .def_readonly("torque_a", &Contacts::torque_a, "(n, 3), N m: on A about A's centre of mass.")
      .def_readonly("torque_b", &Contacts::torque_b, "(n, 3), N m: on B about B's centre of mass.")
      .def_readonly("depth", &Contacts::depth, "(n,), m, deepest penetrations of the margins, 0 or more.")
      .def_readonly("contacts", &Contacts::contacts, "(n,) int32: points within the margin; 0: no contact.")
      .def("__repr__",
           [](const Contacts& c) { return "<abstand.Contacts of " + std::to_string(c.size) + " poses>"; });
}

}  // namespace

Distances::Distances(std::size_t n)
    : size(n), distance(count(n)), bound(count(n)), point_a(rows(n)), point_b(rows(n)) {}

Contacts::Contacts(std::size_t n)
    : Distances(n),
      force(rows(n)),
      torque_a(rows(n)),
      torque_b(rows(n)),
      depth(count(n)),
      contacts(count(n)) {}

ResultColumns::ResultColumns(Distances& out)
    : distance(out.distance.mutable_data()),
      bound(out.bound.mutable_data()),
      point_a(out.point_a.mutable_data()),
      point_b(out.point_b.mutable_data()) {}

ResultColumns::ResultColumns(Contacts& out) : ResultColumns(static_cast<Distances&>(out)) {
  force = out.force.mutable_data();
  torque_a = out.torque_a.mutable_data();
  torque_b = out.torque_b.mutable_data();
  depth = out.depth.mutable_data();
  contacts = out.contacts.mutable_data();
}

void ResultColumns::store(std::size_t i, const query::PairResult& r) const noexcept {
  distance[i] = r.distance;
  bound[i] = r.bound;
  put(point_a, i, r.witness_a);
  put(point_b, i, r.witness_b);
  if (force == nullptr) return;
  put(force, i, r.force_a);
  put(torque_a, i, r.torque_a);
  put(torque_b, i, r.torque_b);
  depth[i] = r.depth;
  contacts[i] = r.contacts;
}

void bindResults(py::module_& module) {
  bindSingleResults(module);
  bindBatchResults(module);
}

}  // namespace abstand::python

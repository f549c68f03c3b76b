// Python types of query results.
#pragma once

#include <pybind11/numpy.h>

#include "core/query/pair_query.hpp"

namespace abstand::python {

namespace py = pybind11;

/// abstand.Distance
struct Distance {
  query::PairResult result;
};

/// abstand.Contact
struct Contact : Distance {};

/// abstand.Memory: a pair's memory, and the structures it belongs to. Used with the GIL only.
struct Memory {
  query::PairMemory memory;
  std::shared_ptr<const structure::HapticStructure> a, b;
};

/// abstand.Distances: arrays of n results.
struct Distances {
  explicit Distances(std::size_t n);
  std::size_t size;
  py::array_t<double> distance, bound, point_a, point_b;
};

/// abstand.Contacts
struct Contacts : Distances {
  explicit Contacts(std::size_t n);
  py::array_t<double> force, torque_a, torque_b, depth;
  py::array_t<std::int32_t> contacts;
};

/// Addresses of the arrays' numbers, to write them without the GIL; null: not requested.
struct ResultColumns {
  explicit ResultColumns(Distances& out);
  explicit ResultColumns(Contacts& out);
  void store(std::size_t i, const query::PairResult& r) const noexcept;

  double *distance, *bound, *point_a, *point_b;
  double *force{nullptr}, *torque_a{nullptr}, *torque_b{nullptr}, *depth{nullptr};
  std::int32_t* contacts{nullptr};
};

void bindResults(py::module_& module);

}  // namespace abstand::python

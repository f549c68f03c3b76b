// Scene data as columns of arrays.
#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include "app/session/session.hpp"

namespace abstand::python {

namespace py = pybind11;

/// A number, vector or matrix for every pair, object or joint.
struct SceneColumn {
  enum class Of { kPairs, kObjects, kJoints };

  const char* name;
  Of of;
  const char* dtype;                    ///< NumPy type name
  std::vector<py::ssize_t> item_shape;  ///< shape for one pair, object or joint; empty: a number
  std::size_t item_bytes;
  /// Writes `item_bytes` of pair, object or joint i. No throw.
  void (*store)(const session::Session& session, std::size_t i, char* out);
};

const std::vector<SceneColumn>& sceneColumns();

/// Number of pairs, objects or joints of a session.
std::size_t countOf(const session::Session& session, SceneColumn::Of of);

/// Arrays for some columns at one time, or at `moments` times, and their addresses.
class SceneTable {
 public:
  /// Throws UsageError for an unknown column name. With the GIL.
  SceneTable(const session::Session& session, const std::vector<std::string>& names,
             std::optional<std::size_t> moments);

  /// Stores the session's current state as row `moment`. Without the GIL; no allocation, no throw.
  void store(const session::Session& session, std::size_t moment) noexcept;
  /// Sets the arrays as attributes of `target`.
  void giveTo(py::handle target) const;

 private:
  struct Filled {
    const SceneColumn* column;
    py::array array;
    char* data;
    std::size_t count;
  };
  std::vector<Filled> filled_;
};

}  // namespace abstand::python

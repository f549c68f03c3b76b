// The numbers of a scene as columns of arrays.
#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include "app/session/session.hpp"

namespace abstand::python {

namespace py = pybind11;

/// One number, vector or matrix of every pair, object or joint.
struct SceneColumn {
  enum class Of { kPairs, kObjects, kJoints };

  const char* name;
  Of of;
  const char* dtype;                    ///< NumPy's word for it
  std::vector<py::ssize_t> item_shape;  ///< of one pair's; empty: a number
  std::size_t item_bytes;
  /// Writes `item_bytes` of the pair, object or joint number i. No throw.
  void (*store)(const session::Session& session, std::size_t i, char* out);
};

const std::vector<SceneColumn>& sceneColumns();

/// How many pairs, objects or joints a session has.
std::size_t countOf(const session::Session& session, SceneColumn::Of of);

/// Arrays for some columns and one moment, or `moments` of them, and where they are in memory.
class SceneTable {
 public:
  /// Throws UsageError for a name that is no column. With the GIL.
  SceneTable(const session::Session& session, const std::vector<std::string>& names,
             std::optional<std::size_t> moments);

  /// The session's present state becomes row `moment`. Without the GIL; no allocation, no throw.
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

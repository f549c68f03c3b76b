// Poses from NumPy arrays.
#pragma once

#include <pybind11/numpy.h>

#include <string>

#include "core/math/transform.hpp"

namespace abstand::python {

namespace py = pybind11;

/// One pose, an array (4, 4), or many, (n, 4, 4). Arrays of doubles are used without a copy, with any
/// strides; others are converted. None is the identity. Holds a reference; created and destroyed with the
/// GIL, read without.
class PoseRows {
 public:
  /// `name`: of the argument, for messages. Throws UsageError for invalid arrays.
  PoseRows(py::handle poses, const char* name);

  bool single() const { return single_; }
  std::size_t size() const { return size_; }
  /// Pose of row i, or the only one if single().
  Transform operator[](std::size_t i) const noexcept;
  /// The only pose, validated. Throws UsageError.
  Transform only() const;
  /// Throws UsageError with the first row that is not finite, not a rigid transform (within 1e-6) or farther
  /// than 1e6 m from the origin.
  void check() const;

 private:
  void read(std::size_t i, int rows, Eigen::Matrix4d& X) const noexcept;
  std::string rowName(std::size_t i) const;

  const char* name_;
  py::array array_;
  const char* data_{nullptr};                 ///< null: the identity
  py::ssize_t row_{0}, down_{0}, across_{0};  ///< strides, bytes
  std::size_t size_{1};
  bool single_{true};
};

/// Number of poses in a call with both arguments; throws UsageError if both are many and differ in number.
std::size_t commonSize(const PoseRows& a, const PoseRows& b);

/// Stores a pose as 16 numbers, row by row.
inline void storePose(const Transform& X, double* out) {
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(out);
  matrix = X.matrix();
}

/// (4, 4)
py::array_t<double> poseArray(const Transform& X);

}  // namespace abstand::python

#include "app/python/pose_rows.hpp"

#include <cmath>
#include <cstring>

#include "core/base/error.hpp"

namespace abstand::python {
namespace {

constexpr double kRigid = 1e-6;
// m, as scene::Scene::kFarthest.
constexpr double kFarthestPose = 1e6;

using AnyDoubles = py::array_t<double, py::array::forcecast>;

/// True for a NumPy array of native doubles.
bool isDoubles(PyObject* object) {
  using namespace py::detail;
  const npy_api& numpy = npy_api::get();
  if (!numpy.PyArray_Check_(object)) return false;
  const auto* descr = array_descriptor_proxy(array_proxy(object)->descr);
  return descr->type_num == npy_api::NPY_DOUBLE_ && descr->byteorder == '=';
}

std::string shapeText(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

/// Fast sufficient test for a rigid transform; false for NaN.
bool surelyRigid(const Eigen::Matrix4d& X) {
  const Vector3d x = X.col(0).head<3>(), y = X.col(1).head<3>(), z = X.col(2).head<3>();
  const auto off = [](double value, double wanted) { return (value - wanted) * (value - wanted); };
  const double columns = off(x.dot(x), 1) + off(y.dot(y), 1) + off(z.dot(z), 1) +
                         2 * (off(x.dot(y), 0) + off(y.dot(z), 0) + off(z.dot(x), 0));
  const double last = off(X(3, 0), 0) + off(X(3, 1), 0) + off(X(3, 2), 0) + off(X(3, 3), 1);
  // The norms of R^T R - I and R R^T - I are equal to first order.
  return columns <= 0.25 * kRigid * kRigid && last <= kRigid * kRigid && x.cross(y).dot(z) > 0.0 &&
         X.col(3).head<3>().squaredNorm() <= kFarthestPose * kFarthestPose;
}

/// The fault of a pose, or null.
const char* faultOf(const Eigen::Matrix4d& X) {
  if (surelyRigid(X)) return nullptr;
  if (!X.allFinite()) return "numbers that are not finite";
  if (!((X.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() <= kRigid))
    return "a last row other than 0 0 0 1";
  const Matrix3d R = X.topLeftCorner<3, 3>();
  if (!((R * R.transpose() - Matrix3d::Identity()).cwiseAbs().maxCoeff() <= kRigid))
    return "columns that are not orthonormal";
  if (!(R.determinant() > 0.0)) return "a reflection";
  if (!(X.topRightCorner<3, 1>().cwiseAbs().maxCoeff() <= kFarthestPose)) return "a place beyond 1e6 m";
  return nullptr;
}

}  // namespace

PoseRows::PoseRows(py::handle poses, const char* name) : name_(name) {
  if (poses.is_none()) return;
  if (isDoubles(poses.ptr())) {
    array_ = py::reinterpret_borrow<py::array>(poses);
  } else {
    array_ = AnyDoubles::ensure(poses);
    if (!array_) {
      PyErr_Clear();
      throw UsageError(std::string(name) + ": found " + Py_TYPE(poses.ptr())->tp_name +
                       ", expected an array (4, 4) or (n, 4, 4)");
    }
  }
  const py::ssize_t n = array_.ndim();
  if ((n != 2 && n != 3) || array_.shape(n - 1) != 4 || array_.shape(n - 2) != 4)
    throw UsageError(std::string(name) + ": found an array " + shapeText(array_) +
                     ", expected (4, 4) or (n, 4, 4)");
  data_ = static_cast<const char*>(array_.data());
  single_ = n == 2;
  if (!single_) {
    size_ = static_cast<std::size_t>(array_.shape(0));
    row_ = array_.strides(0);
  }
  down_ = array_.strides(n - 2);
  across_ = array_.strides(n - 1);
}

void PoseRows::read(std::size_t i, int rows, Eigen::Matrix4d& X) const noexcept {
  // The array may be at any address, so its numbers may be unaligned.
  const char* pose = data_ + row_ * static_cast<py::ssize_t>(i);
  if (across_ == sizeof(double) && down_ == 4 * across_) {
    double numbers[16];
    std::memcpy(numbers, pose, sizeof numbers);
    X = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers);
    if (rows < 4) X.row(3) << 0, 0, 0, 1;
    return;
  }
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < 4; ++c) std::memcpy(&X(r, c), pose + r * down_ + c * across_, sizeof(double));
}

Transform PoseRows::operator[](std::size_t i) const noexcept {
  Transform X = Transform::Identity();
  if (data_ != nullptr) read(i, 3, X.matrix());
  return X;
}

Transform PoseRows::only() const {
  if (!single_) throw UsageError(std::string(name_) + ": found many poses, expected one (4, 4)");
  if (data_ == nullptr) return Transform::Identity();
  Eigen::Matrix4d X;
  read(0, 4, X);
  if (const char* fault = faultOf(X))
    throw UsageError(std::string(name_) + ": found " + fault + ", expected a rigid transform");
  X.row(3) << 0, 0, 0, 1;
  return Transform(X);
}

std::string PoseRows::rowName(std::size_t i) const {
  return single_ ? std::string(name_) : std::string(name_) + "[" + std::to_string(i) + "]";
}

void PoseRows::check() const {
  if (data_ == nullptr) return;
  Eigen::Matrix4d X;
  for (std::size_t i = 0; i < size_; ++i) {
    read(i, 4, X);
    if (const char* fault = faultOf(X))
      throw UsageError(rowName(i) + ": found " + fault + ", expected a rigid transform");
  }
}

std::size_t commonSize(const PoseRows& a, const PoseRows& b) {
  if (!a.single() && !b.single() && a.size() != b.size())
    throw UsageError("X_a and X_b: found " + std::to_string(a.size()) + " and " + std::to_string(b.size()) +
                     " poses, expected equally many, or one of one of them");
  return a.single() ? b.size() : a.size();
}

py::array_t<double> poseArray(const Transform& X) {
  py::array_t<double> array({4, 4});
  storePose(X, array.mutable_data());
  return array;
}

}  // namespace abstand::python

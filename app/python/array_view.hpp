// NumPy arrays that refer to memory of an object.
#pragma once

#include <pybind11/numpy.h>

#include <utility>
#include <vector>

namespace abstand::python {

namespace py = pybind11;

inline void makeReadOnly(py::array& array) {
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
}

/// A read-only view of `data` without a copy; keeps `owner` alive.
template <class T>
py::array viewOf(const T* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                 py::handle owner) {
  py::array view(py::dtype::of<T>(), std::move(shape), std::move(strides), data, owner);
  makeReadOnly(view);
  return view;
}

/// A copy of `count` numbers.
template <class T>
py::array_t<T> arrayOf(const T* data, py::ssize_t count) {
  return py::array_t<T>(count, data);
}

template <class Vector>
py::array_t<double> vectorArray(const Vector& v) {
  return arrayOf(v.data(), v.size());
}

}  // namespace abstand::python

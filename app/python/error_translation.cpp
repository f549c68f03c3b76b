#include "app/python/error_translation.hpp"

#include "core/base/error.hpp"
#include "core/base/write_error.hpp"

namespace abstand::python {
namespace {

namespace py = pybind11;

py::object errorType(const char* name) { return py::module_::import("abstand._errors").attr(name); }

void raise(const char* name, const char* text) { PyErr_SetString(errorType(name).ptr(), text); }

void raiseParseError(const ParseError& e) {
  const py::object type = errorType("ParseError");
  py::object error = type(e.what());
  error.attr("file") = e.pos().file;
  error.attr("line") = e.pos().line;
  error.attr("column") = e.pos().column;
  PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace

void translateErrors() {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const ParseError& e) {
      raiseParseError(e);
    } catch (const UsageError& e) {
      raise("UsageError", e.what());
    } catch (const WriteError& e) {
      raise("WriteError", e.what());
    }
  });
}

}  // namespace abstand::python

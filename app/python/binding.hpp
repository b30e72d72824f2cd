#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/python/hint_words.hpp"
#include "core/base/positions.hpp"
#include "core/base/result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo::python {

namespace py = pybind11;

/// An Error of the engine on its way to Python, where it is abrazo.Error.
class EngineError : public std::runtime_error {
 public:
  explicit EngineError(const Error& error) : std::runtime_error(error.text(argument_words)) {}
};

/// The value; throws EngineError if there is none.
template <typename T>
T unwrap(Result<T> result) {
  if (!result) throw EngineError(result.error());
  return std::move(*result);
}

/// Runs work of the engine without the GIL. The work must not use Python.
template <typename Work>
auto without_gil(Work work) {
  const py::gil_scoped_release released;
  return work();
}

using Shape = std::vector<py::ssize_t>;

/// Numbers of the engine as a read-only array, without a copy. @param owner owner of the numbers, kept alive
/// by the array
template <typename Number>
py::array view_of(const Number* numbers, Shape shape, py::handle owner) {
  py::array_t<Number> array(std::move(shape), numbers, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// (T, 25, 3) view of contiguous poses.
py::array view_of(const std::vector<Pose>& poses, py::handle owner);

/// Argument for one or several poses: anything that NumPy converts to doubles. What a masked array masks is
/// not a number.
class Numbers : public py::array_t<double, py::array::c_style | py::array::forcecast> {
 public:
  Numbers() = default;
  /// Empty if it cannot be converted.
  static Numbers of(py::handle given) {
    const bool is_masked = py::isinstance(given, py::module_::import("numpy.ma").attr("MaskedArray"));
    py::object plain = py::reinterpret_borrow<py::object>(given);
    if (is_masked) plain = plain.attr("astype")("float64").attr("filled")(py::float_(std::nan("")));
    Numbers numbers;
    static_cast<array_t&>(numbers) = array_t::ensure(plain);
    return numbers;
  }
};

/// One pose. @throws py::value_error when the shape is not (25, 3); `name` is that of the argument
Pose pose_of(const Numbers& numbers, const char* name);

/// Settings with some of them changed, and the files of bodies measured. @param changes  a dict by key
Settings changed_settings(const Settings& settings, const py::object& changes);

/// The settings of a preset with some of them changed. @param changes  a dict by key, or None
Settings settings_of(const std::string& preset_name, const py::object& changes);

/// The Python value of a JSON text, usually a dict.
py::object from_json(const std::string& json);

// One function per file that adds its part to the module.
void bind_motion(py::module_& module);
void bind_library(py::module_& module);
void bind_frame(py::module_& module);
void bind_synthesis(py::module_& module);
void bind_evaluation(py::module_& module);
void bind_session(py::module_& module);

}  // namespace abrazo::python

template <>
struct pybind11::detail::type_caster<abrazo::python::Numbers> {
  PYBIND11_TYPE_CASTER(abrazo::python::Numbers, handle_type_name<array_t<double>>::name);
  bool load(handle given, bool converts) {
    if (!converts && !isinstance<array>(given)) return false;
    value = abrazo::python::Numbers::of(given);
    return static_cast<bool>(value);
  }
};

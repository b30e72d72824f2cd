#include "app/python/binding.hpp"
#include "core/base/version.hpp"
#include "core/bodies/chosen_body.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo::python {

static_assert(sizeof(Pose) == joint_count * 3 * sizeof(double), "arrays are views of rows of poses");
static_assert(sizeof(PairPose) == 2 * sizeof(Pose));

py::array view_of(const std::vector<Pose>& poses, py::handle owner) {
  return view_of(poses.empty() ? nullptr : poses.front().data(),
                 {static_cast<py::ssize_t>(poses.size()), joint_count, 3}, owner);
}

Pose pose_of(const Numbers& numbers, const char* name) {
  if (numbers.ndim() != 2 || numbers.shape(0) != joint_count || numbers.shape(1) != 3)
    throw py::value_error(std::string(name) + " has the shape " +
                          py::str(numbers.attr("shape")).cast<std::string>() +
                          "; (25, 3) is expected, x y z of 25 joints [m]");
  return Eigen::Map<const Pose>(numbers.data());
}

Settings settings_of(const std::string& preset_name, const py::object& changes) {
  const Settings settings = unwrap(preset(preset_name));
  if (changes.is_none()) return settings;
  return changed_settings(settings, changes);
}

Settings changed_settings(const Settings& settings, const py::object& changes) {
  const auto json =
      py::module_::import("json").attr("dumps")(changes, py::arg("allow_nan") = false).cast<std::string>();
  Settings changed = unwrap(parse_settings(json, settings, "settings"));
  for (BodyChoice* body : {&changed.active_body, &changed.passive_body}) unwrap(measure_file(*body));
  return changed;
}

py::object from_json(const std::string& json) {
  return py::module_::import("json").attr("loads")(json);
}

PYBIND11_MODULE(_abrazo, module) {
  // What people write and see is the package; this module is a part of it.
  const py::object own_name = module.attr("__name__");
  module.attr("__name__") = "abrazo";
  module.doc() = "The engine of Abrazo; import abrazo, which has all of it.";
  py::register_exception<EngineError>(module, "Error").doc() =
      "Why a file, a setting or another word from outside could not be used: the sentence that the command "
      "line prints.";
  py::tuple joints(joint_count), parents(joint_count);
  for (std::size_t joint = 0; joint < joint_names.size(); ++joint) {
    joints[joint] = std::string(joint_names[joint]);
    parents[joint] = joint_parents[joint];
  }
  module.attr("JOINTS") = joints;
  module.attr("PARENTS") = parents;
  module.attr("__version__") = version();
  bind_motion(module);
  bind_frame(module);
  bind_library(module);
  bind_synthesis(module);
  bind_evaluation(module);
  bind_session(module);
  module.attr("__name__") = own_name;
}

}  // namespace abrazo::python

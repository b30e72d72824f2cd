#include "app/python/progress.hpp"
#include "core/evaluation/report/report_json.hpp"
#include "core/evaluation/run/evaluation_source.hpp"

namespace abrazo::python {

namespace {

/// What an evaluation gives.
struct Report {
  std::string json;
  std::vector<std::string> warnings;
};

py::object evaluate_takes(const std::filesystem::path& manifest, const std::vector<std::string>& parts,
                          const std::filesystem::path& users, bool both_roles,
                          std::vector<std::string> hold_out, const std::string& preset_name,
                          const py::object& changes, bool variants, py::object progress) {
  const EvaluationSource source{manifest.string(), users.string(), both_roles, std::move(hold_out)};
  EvaluationOptions options;
  options.parts = unwrap(evaluation_parts(parts));
  options.settings = settings_of(preset_name, changes);
  options.hold_out = source.hold_out;
  options.variants = variants;
  const Report report = CalledProgress(std::move(progress)).run([&](const Progress& tell) -> Result<Report> {
    const auto manifests = read_manifests(source);
    if (!manifests) return manifests.error();
    const auto data = read_evaluation_data(*manifests, source.both_roles, part(tell, 0, 0.1));
    if (!data) return data.error();
    const auto evaluation = evaluate(*data, options, part(tell, 0.1, 1));
    if (!evaluation) return evaluation.error();
    return Report{report_json(*evaluation), data->warnings};
  });
  for (const std::string& warning : report.warnings)
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) throw py::error_already_set();
  return from_json(report.json);
}

}  // namespace

void bind_evaluation(py::module_& module) {
  module.def(
      "evaluate", &evaluate_takes, py::arg("manifest"), py::arg("parts") = std::vector<std::string>{"all"},
      py::kw_only(), py::arg("users") = "", py::arg("both_roles") = false,
      py::arg("hold_out") = std::vector<std::string>(), py::arg("preset") = "responsive",
      py::arg("settings") = py::none(), py::arg("variants") = true, py::arg("progress") = py::none(),
      "The paper's tables and further metrics on the takes of a manifest: a dict, the report.json of "
      "`abrazo evaluate`.\n\n"
      "parts: of 'selection', 'timing', 'moves', 'zmp', 'contact', 'published', 'bodies', or 'all'; users: "
      "manifest of other "
      "people's takes;\nhold_out: names of the takes to be answered, by default each; variants: also users "
      "of other builds and disturbed\ninput. What is odd about a file is a UserWarning. Raises "
      "abrazo.Error.");
}

}  // namespace abrazo::python

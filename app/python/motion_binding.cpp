#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <variant>

#include "app/python/binding.hpp"
#include "app/python/clip.hpp"
#include "app/python/progress.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/motion/files/motion_reading.hpp"

namespace abrazo::python {

namespace {

std::vector<Pose> poses_of(const Numbers& positions) {
  if (positions.ndim() != 3 || positions.shape(1) != joint_count || positions.shape(2) != 3)
    throw py::value_error("positions has the shape " + py::str(positions.attr("shape")).cast<std::string>() +
                          "; (T, 25, 3) is expected, x y z of 25 joints [m] in T frames");
  std::vector<Pose> poses(static_cast<std::size_t>(positions.shape(0)));
  for (std::size_t frame = 0; frame < poses.size(); ++frame) {
    std::memcpy(poses[frame].data(), positions.data() + frame * sizeof(Pose) / sizeof(double), sizeof(Pose));
    for (int joint = 0; joint < joint_count; ++joint)
      if (!poses[frame].row(joint).allFinite())
        throw py::value_error(
            fmt::format("positions of frame {}, joint {} ({}) are not finite; fill such "
                        "gaps, or leave the frames out",
                        frame, joint, joint_names[static_cast<std::size_t>(joint)]));
  }
  return poses;
}

std::shared_ptr<ReadClip> make_clip(const Numbers& positions, double fps, std::string name) {
  if (!(fps > 0 && std::isfinite(fps)))
    throw py::value_error(fmt::format("fps is {}; a number above 0 is expected", fps));
  return std::make_shared<ReadClip>(ReadClip{{std::move(name), fps, poses_of(positions)}, {}});
}

std::shared_ptr<ReadClip> read_clip(const std::filesystem::path& file, const std::filesystem::path& skeleton,
                                    std::optional<double> metres_per_unit, std::optional<double> fps,
                                    std::string joint_map, std::string joints, std::string up,
                                    std::optional<std::variant<int, std::string>> performer,
                                    std::string animation, const std::filesystem::path& body_model) {
  const MotionReading reading{.file = file.string(),
                              .skeleton = skeleton.string(),
                              .joint_map = std::move(joint_map),
                              .joints = std::move(joints),
                              .up = std::move(up),
                              .metres_per_unit = metres_per_unit,
                              .fps = fps,
                              .performer = !performer ? std::string()
                                           : std::holds_alternative<int>(*performer)
                                               ? std::to_string(std::get<int>(*performer))
                                               : std::get<std::string>(*performer),
                              .animation = std::move(animation),
                              .body_model = body_model.string()};
  return CalledProgress(py::none()).run([&](const Progress& progress) -> Result<std::shared_ptr<ReadClip>> {
    Result<ImportedClip> imported = read_performer(reading, progress);
    if (!imported) return imported.error();
    std::vector<std::string> warnings;
    for (const Warning& warning : warnings_of_import(reading, *imported))
      warnings.push_back(warning.text(argument_words));
    return std::make_shared<ReadClip>(ReadClip{std::move(imported->clip), std::move(warnings)});
  });
}

}  // namespace

void bind_motion(py::module_& module) {
  py::class_<ReadClip, std::shared_ptr<ReadClip>>(
      module, "Clip", "One performer's motion: 25 joints in metres, right-handed, Y up, floor near y = 0.")
      .def(py::init(&make_clip), py::arg("positions"), py::arg("fps"), py::arg("name") = "",
           "positions: (T, 25, 3) [m], joints in the order of abrazo.JOINTS, is copied; fps: frames per "
           "second.\nRaises ValueError on another shape and on positions that are not finite.")
      .def_property_readonly(
          "positions", [](py::handle self) { return view_of(self.cast<const ReadClip&>().clip.poses, self); },
          "(T, 25, 3) float64 [m], world; a read-only view.")
      .def_property_readonly(
          "fps", [](const ReadClip& self) { return self.clip.fps; }, "Frames per second.")
      .def_property_readonly(
          "name", [](const ReadClip& self) { return self.clip.name; }, "The performer's.")
      .def_property_readonly(
          "duration", [](const ReadClip& self) { return self.clip.duration_s(); }, "[s]")
      .def_property_readonly(
          "joints", [module](const ReadClip&) { return module.attr("JOINTS"); },
          "Names of the 25 joints, in the order of positions.")
      .def_readonly("warnings", &ReadClip::warnings, "What was odd about the file, a sentence each.")
      .def("__len__", [](const ReadClip& self) { return self.clip.poses.size(); })
      .def("__repr__", [](const ReadClip& self) {
        return fmt::format("<abrazo.Clip {}: {} frames at {} fps>", self.clip.name, self.clip.poses.size(),
                           self.clip.fps);
      });

  module.def(
      "read_motion", &read_clip, py::arg("file"), py::kw_only(), py::arg("skeleton") = "",
      py::arg("metres_per_unit") = py::none(), py::arg("fps") = py::none(), py::arg("joint_map") = "",
      py::arg("joints") = "", py::arg("up") = "", py::arg("performer") = py::none(),
      py::arg("animation") = "", py::arg("body_model") = "",
      "Reads a motion file of any known format as 25 joints in metres.\n\n"
      "skeleton: the .asf of an .amc; metres_per_unit: length of the file's unit; fps: instead of "
      "the file's;\njoint_map: a built-in map or marker model by its name, or a JSON file; joints: "
      "order of the joints of an array without\nnames, as 'smplh52'; up: 'y' or 'z';\nperformer: "
      "which one of a file with several, a number from 1 or a name;\nanimation: which one of a file "
      "with several, the longest by default;\nbody_model: of SMPL or SMPL-X parameters, the .npz of the "
      "body model. What is not given is found out, and "
      "each guess is among\nthe clip's warnings. Raises abrazo.Error.");
}

}  // namespace abrazo::python

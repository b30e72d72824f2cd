#include <fmt/format.h>

#include <memory>

#include "app/python/frame.hpp"
#include "app/python/library.hpp"
#include "app/python/progress.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo::python {

namespace {

using LibraryPtr = std::shared_ptr<ReadLibrary>;

LibraryPtr made_of(MotionLibrary library, std::vector<std::string> warnings) {
  return std::make_shared<ReadLibrary>(
      ReadLibrary{std::make_shared<const MotionLibrary>(std::move(library)), std::move(warnings)});
}

LibraryPtr build_from(const std::filesystem::path& file, std::vector<std::string> exclude, bool both_roles,
                      std::optional<double> rate_hz, py::object progress) {
  const LibraryBuildOptions options{std::move(exclude), rate_hz, both_roles};
  return CalledProgress(std::move(progress)).run([&](const Progress& report) -> Result<LibraryPtr> {
    const auto manifest = read_manifest(file);
    if (!manifest) return manifest.error();
    std::vector<std::string> warnings;
    auto library = build_library(*manifest, options, report, warnings);
    if (!library) return library.error();
    return made_of(std::move(*library), std::move(warnings));
  });
}

LibraryPtr open_file(const std::filesystem::path& file) {
  return without_gil([&] { return made_of(unwrap(read_library(file)), {}); });
}

void save_as(const ReadLibrary& self, const std::filesystem::path& file, py::object progress) {
  CalledProgress(std::move(progress)).run([&](const Progress& report) {
    return write_library(*self.library, file, report);
  });
}

int checked(const MotionLibrary& library, int pair) {
  if (pair >= 0 && pair < library.pair_count()) return pair;
  throw py::index_error(
      fmt::format("there is no pair {}; the library has {}, from 0", pair, library.pair_count()));
}

std::optional<int> find_pair(const ReadLibrary& self, const std::string& take, int frame, bool swapped) {
  const int pair = self.library->find_pair(take, frame, swapped);
  return pair < 0 ? std::nullopt : std::optional(pair);
}

}  // namespace

void bind_library(py::module_& module) {
  py::class_<LibraryTake>(module, "Take", "What a library keeps of a take.")
      .def_readonly("name", &LibraryTake::name)
      .def_readonly("fps", &LibraryTake::fps, "Frames per second of its file.")
      .def_readonly("frames", &LibraryTake::frames, "In its file.")
      .def_readonly("frame_stride", &LibraryTake::frame_stride, "Every n-th frame is in the library.")
      .def("__repr__", [](const LibraryTake& take) {
        return fmt::format("<abrazo.Take {}: {} frames at {} fps>", take.name, take.frames, take.fps);
      });

  py::class_<ReadLibrary, LibraryPtr>(
      module, "Library",
      "Recorded pairs, normalised, with their features and interaction meshes. Never changes; may be shared "
      "by threads.")
      .def_static("build", &build_from, py::arg("manifest"), py::kw_only(),
                  py::arg("exclude") = std::vector<std::string>(), py::arg("both_roles") = false,
                  py::arg("rate") = py::none(), py::arg("progress") = py::none(),
                  "Reads the takes of a manifest (JSON) and builds their library, on every core.\n\n"
                  "exclude: names of takes that are left out; both_roles: either performer may be the active "
                  "one in every\nframe; rate: thin to about this many pairs per second of motion [Hz]; "
                  "progress: True for a line on stderr,\nor a function of (fraction, doing) that stops the "
                  "job by returning False. Raises abrazo.Error.")
      .def_static("open", &open_file, py::arg("file"),
                  "Reads a library file (HDF5). Of a large one, poses and meshes stay in the file and are "
                  "read when used.\nRaises abrazo.Error.")
      .def("save", &save_as, py::arg("file"), py::kw_only(), py::arg("progress") = py::none(),
           "Writes it as HDF5, whole or not at all. Raises abrazo.Error.")
      .def_property_readonly(
          "name", [](const ReadLibrary& self) { return self.library->name(); }, "The manifest's.")
      .def_property_readonly(
          "rate", [](const ReadLibrary& self) { return self.library->rate_hz(); },
          "Pairs per second of motion [Hz].")
      .def_property_readonly(
          "takes", [](const ReadLibrary& self) { return self.library->takes(); },
          "The takes, in the order of the manifest.")
      .def_property_readonly(
          "features",
          [](py::handle self) {
            const MotionLibrary& library = *self.cast<const ReadLibrary&>().library;
            const auto& features = library.columns().features;
            return view_of(features.empty() ? nullptr : features.front().data(),
                           {static_cast<py::ssize_t>(features.size()), 15}, self);
          },
          "(P, 15) float64 [m]: head, right and left hand, right and left foot of each active pose, "
          "normalised; a\nread-only view.")
      .def("__len__", [](const ReadLibrary& self) { return self.library->pair_count(); })
      .def(
          "pose",
          [](const ReadLibrary& self, int pair) {
            const PairPose pose = self.library->pose(checked(*self.library, pair));
            return py::array_t<double>(Shape{2, joint_count, 3}, pose.data());
          },
          py::arg("pair"),
          "(2, 25, 3) [m]: a recorded pair, active then passive, from the active root and heading (Eq. 1-2); "
          "a copy.\nRaises IndexError.")
      .def(
          "source",
          [](const ReadLibrary& self, int pair) {
            return source_of(*self.library, checked(*self.library, pair));
          },
          py::arg("pair"), "Where a pair was recorded. Raises IndexError.")
      .def("find_pair", &find_pair, py::arg("take"), py::arg("frame"), py::arg("swapped") = false,
           "The pair of a frame (from 0) of a take, or None when the library does not have it.")
      .def_readonly("warnings", &ReadLibrary::warnings, "What was odd about the files it was built from.")
      .def_property_readonly(
          "damage",
          [](const ReadLibrary& self) -> std::optional<std::string> {
            const auto damage = self.library->damage();
            return damage ? std::optional(damage->text()) : std::nullopt;
          },
          "What happened to the file that a large library is read from; None when nothing did.")
      .def("__repr__", [](const ReadLibrary& self) {
        return fmt::format("<abrazo.Library {}: {} takes, {} pairs>", self.library->name(),
                           self.library->takes().size(), self.library->pair_count());
      });
}

}  // namespace abrazo::python

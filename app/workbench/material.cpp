#include "app/workbench/material.hpp"

#include <filesystem>

#include "core/base/text.hpp"
#include "core/choreography/salsa.hpp"
#include "core/library/manifest.hpp"
#include "core/library/motion_library_builder.hpp"
#include "core/library/motion_library_file.hpp"
#include "core/library/normalization.hpp"
#include "core/motion/import_clip.hpp"

namespace abrazo::app {
namespace {

enum class Kind { Library, Manifest, Motion, Unknown };

Kind kind_of(const std::string& file) {
  const std::string extension = lower_case(std::filesystem::path(file).extension().string());
  if (extension == ".h5" || extension == ".hdf5") return Kind::Library;
  if (extension == ".json") return Kind::Manifest;
  if (extension == ".bvh" || extension == ".amc") return Kind::Motion;
  return Kind::Unknown;
}

/// Without another input, a take of the library plays the user; it is not selected from then.
void take_input_from_library(Material& material) {
  const int take = static_cast<int>(material.library->takes().size()) - 1;
  material.input = clip_of_take(*material.library, take);
  material.excluded_takes.clear();
  if (take > 0) material.excluded_takes = {material.library->takes()[static_cast<std::size_t>(take)].name};
}

Result<MotionLibrary> build_from(const std::string& file, const Progress& progress,
                                 std::vector<std::string>& warnings) {
  const auto manifest = read_manifest(file);
  if (!manifest) return manifest.error();
  return build_library(*manifest, {}, progress, warnings);
}

Status add_motion(const std::string& file, Material& material) {
  auto clips = load_motion(file, {}, {});
  if (!clips) return clips.error();
  ImportedClip& first = clips->front();
  for (const ImportWarning& warning : first.report.warnings)
    material.warnings.push_back(std::filesystem::path(file).filename().string() + ": " + warning.detail);
  material.input = std::move(first.clip);
  material.excluded_takes.clear();
  return Done{};
}

}  // namespace

Result<Material> make_demo(const Progress& progress) {
  report(progress, 0, "Generating a dance");
  ChoreographyOptions dance;
  dance.minutes = 1;
  auto library = build_library("generated salsa", generate_salsa(dance), {}, progress);
  if (!library) return library.error();
  Material material;
  material.library = std::make_shared<const MotionLibrary>(std::move(library).value());
  dance.seed = 20;
  dance.minutes = 0.5;
  dance.take_seconds = 30;
  material.input = generate_salsa(dance).front().a;
  material.input.name = "generated leader";
  return material;
}

Result<Material> load_material(const std::vector<std::string>& files, const Material& open,
                               const Progress& progress) {
  Material material = open;
  material.warnings.clear();
  bool new_library = false, new_input = false;
  for (const std::string& file : files) {
    switch (kind_of(file)) {
      case Kind::Library:
      case Kind::Manifest: {
        report(progress, 0, "Opening " + std::filesystem::path(file).filename().string());
        auto library = kind_of(file) == Kind::Library ? read_library(file)
                                                      : build_from(file, progress, material.warnings);
        if (!library) return library.error();
        material.library = std::make_shared<const MotionLibrary>(std::move(library).value());
        new_library = true;
        break;
      }
      case Kind::Motion: {
        const Status added = add_motion(file, material);
        if (!added) return added.error();
        new_input = true;
        break;
      }
      case Kind::Unknown:
        return Error{
            "not a kind of file Abrazo opens; use a motion (.bvh, .amc), a library (.h5) or a manifest "
            "(.json)",
            file};
    }
  }
  if (!material.library) {
    auto demo = make_demo(progress);
    if (!demo) return demo.error();
    material.library = demo->library;
  }
  if (new_library && !new_input) take_input_from_library(material);
  return material;
}

Clip clip_of_take(const MotionLibrary& library, int take) {
  Clip clip;
  clip.name = library.takes()[static_cast<std::size_t>(take)].name;
  const LibraryTake& about = library.takes()[static_cast<std::size_t>(take)];
  clip.fps = about.fps / std::max(1, about.frame_stride);
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    if (static_cast<int>(source.take) != take || source.swapped) continue;
    clip.poses.push_back(to_world(library.pose(pair).topRows<joint_count>(), library.root(pair)));
  }
  return clip;
}

}  // namespace abrazo::app

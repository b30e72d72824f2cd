#include "core/motion/joints/motion_format.hpp"

#include <array>
#include <filesystem>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr std::array formats = {
    MotionFormatInfo{MotionFormat::Bvh, "BVH", ".bvh"},
    MotionFormatInfo{MotionFormat::Amc, "AMC", ".amc"},
    MotionFormatInfo{MotionFormat::Asf, "ASF", ".asf"},
    MotionFormatInfo{MotionFormat::C3d, "C3D", ".c3d"},
    MotionFormatInfo{MotionFormat::Trc, "TRC", ".trc"},
    MotionFormatInfo{MotionFormat::PointCsv, "CSV of positions", ".csv .tsv"},
    MotionFormatInfo{MotionFormat::Gltf, "glTF", ".gltf .glb .vrm .vrma"},
    MotionFormatInfo{MotionFormat::Fbx, "FBX", ".fbx"},
    MotionFormatInfo{MotionFormat::Collada, "Collada", ".dae"},
    MotionFormatInfo{MotionFormat::Numpy, "NumPy", ".npy .npz"},
};

std::string extension_of(std::string_view file) {
  return lower_case(std::filesystem::path(file).extension().string());
}

}  // namespace

std::span<const MotionFormatInfo> motion_formats() {
  return formats;
}

std::string_view name_of(MotionFormat format) {
  return formats[static_cast<std::size_t>(format)].name;
}

std::optional<MotionFormat> format_of_name(std::string_view file) {
  const std::string extension = extension_of(file);
  if (extension.empty()) return std::nullopt;
  for (const MotionFormatInfo& info : formats)
    for (const std::string_view known : split_words(info.extensions))
      if (known == extension) return info.format;
  return std::nullopt;
}

std::string motion_file_patterns(bool with_skeletons) {
  std::string patterns;
  for (const MotionFormatInfo& info : formats) {
    if (info.format == MotionFormat::Asf && !with_skeletons) continue;
    for (const std::string_view extension : split_words(info.extensions))
      patterns += (patterns.empty() ? "*" : " *") + std::string(extension);
  }
  return patterns;
}

}  // namespace abrazo

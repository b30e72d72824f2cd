#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace abrazo {

enum class MotionFormat { Bvh, Amc, Asf, C3d, Trc, PointCsv, Gltf, Fbx, Collada, Numpy };

struct MotionFormatInfo {
  MotionFormat format;
  std::string_view name;        ///< "C3D"
  std::string_view extensions;  ///< ".gltf .glb .vrm"
};

/// All formats of motions, including .asf, a skeleton without motion.
std::span<const MotionFormatInfo> motion_formats();
std::string_view name_of(MotionFormat format);

/// By the file name alone. A .csv may also hold labels: check its content.
std::optional<MotionFormat> format_of_name(std::string_view file);

/// "*.bvh *.amc ...": patterns for a file dialog. @param with_skeletons  and .asf
std::string motion_file_patterns(bool with_skeletons);

}  // namespace abrazo

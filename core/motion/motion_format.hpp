#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace abrazo {

enum class MotionFormat { Bvh, Amc, Asf, C3d, Trc, PointCsv, Gltf, Fbx, Collada };

struct MotionFormatInfo {
  MotionFormat format;
  std::string_view name;        ///< "C3D"
  std::string_view extensions;  ///< ".gltf .glb .vrm"
};

/// Every format a motion is read from; .asf, a skeleton without motion, stands among them.
std::span<const MotionFormatInfo> motion_formats();
std::string_view name_of(MotionFormat format);

/// By the file's name alone. A .csv may as well hold labels: ask its content.
std::optional<MotionFormat> format_of_name(std::string_view file);

/// What a file's bytes are, whatever its name; nothing when they do not tell.
/// @param head  the first few kilobytes suffice
std::optional<MotionFormat> format_of_content(std::string_view head);

/// Of a file that is no motion: what it is and what to do ("is a USD file; export FBX or BVH from ...");
/// empty when unknown.
std::string foreign_kind(std::string_view head, std::string_view file);

/// Whether a table's first lines are those of positions (a column for x, y and z of each point) and not of
/// labels.
bool holds_positions(std::string_view head);

/// "*.bvh *.amc ...": patterns for a file dialog. @param with_skeletons  and .asf
std::string motion_file_patterns(bool with_skeletons);

}  // namespace abrazo

#include "core/opening/file_kinds.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/base/text.hpp"
#include "core/library/takes/tier_file.hpp"
#include "core/motion/files/format_recognition.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "core/motion/tables/point_csv.hpp"

namespace abrazo {
namespace {

namespace fs = std::filesystem;

/// The first lines of a file; empty when it cannot be read, such as a pipe without a writer.
std::string head_of(const std::string& file) {
  std::error_code failure;
  if (!fs::is_regular_file(file, failure)) return {};
  std::string head(65536, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  return head;
}

/// A file of labels has "tiers", a manifest "takes", a joint map "joints", a marker model "markers"; all are
/// JSON.
FileKind kind_of_json(const std::string& file) {
  constexpr std::size_t enough_for_tiers = 400;
  const std::string head = head_of(file);
  if (head.substr(0, enough_for_tiers).find("\"tiers\"") != std::string::npos) return FileKind::Labels;
  const auto has = [&](const char* key) { return head.find(key) != std::string::npos; };
  const bool names_joints = (has("\"joints\"") || has("\"markers\"")) && !has("\"takes\"");
  return names_joints ? FileKind::JointMap : FileKind::Manifest;
}

FileKind kind_of_table(const std::string& file) {
  const std::string head = head_of(file);
  if (holds_positions(head)) return FileKind::Motion;
  const std::string begin = lower_case(trimmed(std::string_view(head).substr(0, 400)));
  return begin.starts_with("take,start") || begin.starts_with("tier,start") ? FileKind::Labels
                                                                            : FileKind::Unknown;
}

/// ELAN exports labels as text with tabs; most other texts have none.
FileKind kind_of_text(const std::string& file) {
  const std::string head = head_of(file);
  const auto tabs = std::ranges::count(std::string_view(head).substr(0, head.find('\n')), '\t');
  constexpr int fewest_tabs = 3;
  return tabs >= fewest_tabs ? FileKind::Labels : FileKind::Unknown;
}

/// What an unknown file is, as far as that is known, and what to do.
Error unknown_file(const std::string& file) {
  const std::string foreign = foreign_kind(head_of(file), file);
  if (!foreign.empty()) return Error{foreign, file};
  return Error{"not a kind of file Abrazo opens; use a motion (" + motion_file_patterns(false) +
                   "), a library (.h5), a manifest (.json) or a session (.abrazo)",
               file};
}

Status check_existence(const std::string& file) {
  std::error_code trouble;
  const auto status = fs::status(file, trouble);
  if (!fs::exists(status)) return Error{"there is no such file; check its name", file};
  if (fs::is_directory(status)) return Error{"is a folder; open a file in it", file};
  return Done{};
}

/// Where a file of a kind goes; null for one that no session runs on.
std::string* place_of(FileKind kind, SortedFiles& sorted) {
  switch (kind) {
    case FileKind::Library:
    case FileKind::Manifest:
      return &sorted.library;
    case FileKind::Motion:
      return &sorted.motion;
    case FileKind::Skeleton:
      return &sorted.skeleton;
    case FileKind::JointMap:
      return &sorted.joint_map;
    case FileKind::Session:
      return &sorted.session;
    case FileKind::Labels:
    case FileKind::Video:
    case FileKind::Unknown:
      break;
  }
  return nullptr;
}

Status put(const FileToOpen& file, SortedFiles& sorted) {
  std::error_code ignored;
  std::string* place = place_of(file.kind, sorted);
  if (!place && !fs::is_directory(file.path, ignored)) return unknown_file(file.path);
  if (Status there = check_existence(file.path); !there) return there;
  if (!place->empty())
    return Error{file.kind == FileKind::Motion
                     ? "is a second motion, and one plays the user; open one of the two, or list both as a "
                       "pair in a manifest"
                     : "is the second of its kind; open one of the two",
                 file.path};
  *place = file.path;
  return Done{};
}

}  // namespace

FileKind kind_of_file(const std::string& file) {
  const std::string extension = lower_case(fs::path(file).extension().string());
  if (extension == ".h5" || extension == ".hdf5") return FileKind::Library;
  if (extension == ".abrazo") return FileKind::Session;
  if (extension == ".json") return kind_of_json(file);
  if (extension == ".asf") return FileKind::Skeleton;
  if (const auto format = format_of_name(file))
    return *format == MotionFormat::PointCsv ? kind_of_table(file) : FileKind::Motion;
  if (extension == ".txt") return kind_of_text(file);
  if (is_tier_file(file)) return FileKind::Labels;
  const bool is_video = !extension.empty() && std::ranges::find(video_extensions(), extension.substr(1)) !=
                                                  video_extensions().end();
  if (is_video) return FileKind::Video;
  return head_of(file).starts_with("\x89HDF") ? FileKind::Library : FileKind::Unknown;
}

std::vector<FileToOpen> recognised(const std::vector<std::string>& files) {
  std::vector<FileToOpen> known;
  for (const std::string& file : files) known.push_back({file, kind_of_file(file)});
  return known;
}

Result<SortedFiles> sorted(const std::vector<FileToOpen>& files) {
  SortedFiles sorted;
  for (const FileToOpen& file : files)
    if (const Status done = put(file, sorted); !done) return done.error();
  if (!sorted.session.empty() && !(sorted.motion + sorted.skeleton + sorted.joint_map).empty())
    return Error{"is a session, which has its own user; open it alone, or together with its library",
                 sorted.session};
  if (sorted.motion.empty() && !(sorted.skeleton + sorted.joint_map).empty())
    return Error{"says how to read a motion; open it together with one (.amc, .bvh, ...)",
                 sorted.skeleton.empty() ? sorted.joint_map : sorted.skeleton};
  return sorted;
}

const std::vector<std::string>& video_extensions() {
  static const std::vector<std::string> known = {"mp4", "m4v",  "mov", "avi", "mkv", "webm", "mpg", "mpeg",
                                                 "mts", "m2ts", "ts",  "wmv", "ogv", "3gp",  "flv", "mjpeg"};
  return known;
}

}  // namespace abrazo

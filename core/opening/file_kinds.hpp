#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

enum class FileKind { Library, Manifest, Motion, Skeleton, JointMap, Session, Labels, Video, Unknown };

/// What a file is for: by its name; for .csv, .json and names that say nothing by how it begins. Reads at
/// most 64 kB.
FileKind kind_of_file(const std::string& file);

struct FileToOpen {
  std::string path;
  FileKind kind = FileKind::Unknown;
};
/// Done once, for all that happens with the files from then on.
std::vector<FileToOpen> recognised(const std::vector<std::string>& files);

/// The files of what a session can run on, at most one of each kind; empty = none.
struct SortedFiles {
  std::string library;  ///< library or manifest
  std::string motion, skeleton, joint_map, session;
};
/// @return an Error for a file that is not there, is of no use, or cannot be opened together with the others
Result<SortedFiles> sorted(const std::vector<FileToOpen>& files);

/// Without a dot, in lower case.
const std::vector<std::string>& video_extensions();

}  // namespace abrazo

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/motion/files/import_clip.hpp"

namespace abrazo {

/// A list of paired takes from a JSON file. Paths are already resolved against the manifest's folder.
struct Manifest {
  /// The import detects options that are not set.
  struct Performer {
    std::filesystem::path motion;
    std::filesystem::path skeleton = {};                   ///< empty for formats with their own skeleton
    std::optional<int> index = {};                         ///< index in a file with several performers, from
                                                           ///< 0
    int start = 0;                                         ///< first used frame of the file
    std::optional<double> metres_per_unit = std::nullopt;  ///< overrides that of the take
    std::optional<UpAxis> up_axis = std::nullopt;
    std::string joints = {};     ///< order of an array's joints: a built-in one or a file; empty = as it says
    std::string joint_map = {};  ///< a built-in one by name, or the path of a file; empty = the one that fits
    std::string animation = {};  ///< which one of a file with several; empty = the longest
    std::filesystem::path body_model = {};  ///< of a file with SMPL parameters; empty = none
  };
  struct Take {
    std::string name;
    std::optional<double> fps;
    std::optional<double> metres_per_unit;
    Performer a, b;
    std::optional<int> frames;  ///< used frames of both, counted from `start`; none = to the end
    std::vector<RoleInterval>
        roles;  ///< one interval over the whole take if the file gives one letter; empty = unknown
    std::filesystem::path labels;  ///< empty = none
    std::string move = {};         ///< label of the whole take, instead of `labels`; empty = none
    std::string labels_tier = {};  ///< tier of a file with several; empty = its moves
    /// Roles from a tier of a label file, instead of `roles`; an empty file means `labels`.
    std::string roles_tier = {};
    std::filesystem::path roles_file = {};
  };
  std::string name;
  std::vector<Take> takes;
  std::vector<std::string> warnings;  ///< unknown keys, probably misspelt
};

/// @param file  where it was read from: gives the folder of relative paths and the place in messages
Result<Manifest> parse_manifest(std::string_view json, const std::filesystem::path& file);
Result<Manifest> read_manifest(const std::filesystem::path& file);

/// The JSON that reads back to the same manifest. Paths are relative to `folder` if they share a prefix with
/// it, else absolute.
std::string manifest_json(const Manifest& manifest, const std::filesystem::path& folder);

/// Rows of one take from a label file: take,start_frame,end_frame,label[,detail,confidence]; a field with a
/// comma is quoted. Refuses overlapping, empty or reversed intervals with the line's number.
Result<std::vector<LabelInterval>> parse_labels(std::string_view csv, std::string_view take,
                                                std::string_view where);

/// Options for reading a performer's file. Reads the joint map if its file is given.
Result<ImportOptions> import_options(const Manifest::Performer& performer, std::optional<double> fps);

/// A performer with unit and axis of the other of the take, where its own motion leaves them open and the
/// other's does not: both were captured in one space.
Manifest::Performer with_space_of(const ImportReport& other, const ImportReport& own,
                                  const Manifest::Performer& performer);

/// The takes that a label file names, each once, in its order.
std::vector<std::string> takes_in_labels(std::string_view csv);

/// Reads both performers of a take, on one floor (share_floor), cut to its frames, with roles and labels,
/// whose frames count from the cut. Unequal lengths are an error that says by how many frames.
/// @param warnings  those of the readers are appended, prefixed by the file
/// @param progress  as for load_motion
Result<PairedTake> load_take(const Manifest::Take& take, std::vector<std::string>& warnings,
                             const Progress& progress = {});

}  // namespace abrazo

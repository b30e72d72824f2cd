#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/paired_take.hpp"
#include "core/motion/named_motion.hpp"

namespace abrazo {

/// A list of paired takes as a JSON file has it. Paths are already relative to the manifest's folder.
struct Manifest {
  struct Performer {
    std::filesystem::path motion;
    std::filesystem::path skeleton;  ///< empty for formats that carry their own
  };
  struct Take {
    std::string name;
    std::optional<double> fps;
    std::optional<double> metres_per_unit;
    Performer a, b;
    std::vector<RoleInterval>
        roles;  ///< one interval over everything when the file gives one letter; empty = unknown
    std::filesystem::path labels;  ///< empty = none
  };
  std::string name;
  std::vector<Take> takes;
  std::vector<std::string> warnings;  ///< keys that nobody reads, most likely misspelt
};

/// @param file  where it was read from: gives the folder of relative paths and the place in messages
Result<Manifest> parse_manifest(std::string_view json, const std::filesystem::path& file);
Result<Manifest> read_manifest(const std::filesystem::path& file);

/// Rows of one take from a label file: take,start_frame,end_frame,label[,detail,confidence].
/// Refuses overlapping, empty or reversed intervals with the line's number.
Result<std::vector<LabelInterval>> parse_labels(std::string_view csv, std::string_view take,
                                                std::string_view where);

/// Reads both performers of a take, its roles and labels. Unequal lengths are an error that says by how many
/// frames.
/// @param warnings  what the readers found odd is appended, prefixed by the file
Result<PairedTake> load_take(const Manifest::Take& take, std::vector<std::string>& warnings);

}  // namespace abrazo

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo {

/// What the files of a published dataset do not say.
struct Dataset {
  std::string name;  ///< "interx"
  std::optional<double> fps = {};
  std::optional<double> metres_per_unit = {};
  std::optional<UpAxis> up_axis = {};
};

/// "folder", of which nothing is known, and published datasets; docs/guide/datasets.md lists them.
const std::vector<Dataset>& datasets();

/// Where the moves of takes are from.
enum class MovesFrom {
  LabelFiles,  ///< those beside the takes, or one for all
  Folders,     ///< each take is one move, called like the folder that it is in
  Names        ///< each take is one move, called like the take without its number
};

struct DatasetFolder {
  std::string dataset = "folder";
  std::filesystem::path folder;
  std::filesystem::path body_model = {};  ///< for SMPL parameters; empty = none
  MovesFrom moves = MovesFrom::LabelFiles;
  std::filesystem::path labels = {};  ///< of all takes; empty = those beside the takes
};

/// Reads all motion files below a folder and pairs their performers (guess_pairs). Only pairs that are not
/// unsure become takes; the manifest's `warnings` list the others with the reason, the performers without a
/// partner, the files that cannot be read, and takes that were cut to the shorter performer.
/// @return an Error that lists the datasets, or says what was found if there is no pair
Result<Manifest> plan_dataset(const DatasetFolder& wanted);

}  // namespace abrazo

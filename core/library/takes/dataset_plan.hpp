#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo {

/// File layout of a dataset of pairs.
struct DatasetLayout {
  std::string name;      ///< "interx"
  std::string expected;  ///< the files of a take, in words
};

/// "compas3d", "interx", "interhuman", "remocap", "folder"; docs/guide/datasets.md describes each
/// layout.
const std::vector<DatasetLayout>& dataset_layouts();

/// Pairs the files below a folder by the layout of a dataset, with roles, rates, units and axes if the
/// dataset defines them; the rest is detected when the library is built. No motion is read. The manifest's
/// `warnings` list the motion files without a partner.
/// @param body_model  for datasets of SMPL parameters; empty if there is none
/// @return an Error that lists the layouts, or the expected files if no pair is found
Result<Manifest> plan_dataset(const std::string& layout, const std::filesystem::path& folder,
                              const std::filesystem::path& body_model = {});

}  // namespace abrazo

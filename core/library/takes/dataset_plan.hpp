#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo {

/// How the files of a set of pairs are laid out.
struct DatasetLayout {
  std::string name;      ///< "interx"
  std::string expected;  ///< the files that make a take, for a person
};

/// "compas3d", "interx", "interhuman", "remocap", "folder"; docs/guide/datasets.md says what each is taken
/// for.
const std::vector<DatasetLayout>& dataset_layouts();

/// Pairs the files below a folder as that set lays them out, with roles, rates, units and axes where the set
/// defines them; the rest is found out when the library is built. No motion is read. `warnings` of the
/// manifest name the motion files that have no partner.
/// @param body_model  for sets of SMPL parameters; empty: none is named
/// @return an Error that names the layouts, or says which files were expected when no pair is found
Result<Manifest> plan_dataset(const std::string& layout, const std::filesystem::path& folder,
                              const std::filesystem::path& body_model = {});

}  // namespace abrazo

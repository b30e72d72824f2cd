#pragma once

#include <array>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/evaluation/run/evaluate.hpp"

namespace abrazo {

/// Parts of an evaluation by name, in the order of EvaluationPart.
inline constexpr std::array<std::string_view, 7> evaluation_part_names = {
    "selection", "timing", "moves", "zmp", "contact", "published", "bodies"};

/// The parts of these names; "all" means every one. An Error lists the names.
Result<std::set<EvaluationPart>> evaluation_parts(std::span<const std::string> names);

/// The takes of an evaluation or a sweep.
struct EvaluationSource {
  std::string manifest;
  std::string users;  ///< manifest of other people's takes; empty: leave one take out
  bool both_roles = false;
  std::vector<std::string> hold_out;  ///< takes to be answered; empty = all
};

/// The manifests of a source: read, and checked for the takes to be answered, without reading motions.
struct EvaluationManifests {
  Manifest manifest;
  std::optional<Manifest> users;
};
Result<EvaluationManifests> read_manifests(const EvaluationSource& source);

/// The takes themselves and their library. @param both_roles  as EvaluationSource::both_roles
Result<EvaluationData> read_evaluation_data(const EvaluationManifests& manifests, bool both_roles,
                                            const Progress& progress);

/// What tells these data from others, for people and for shards that are to be merged: name, number of pairs,
/// who is answered, and a checksum of all motions, roles and labels.
std::string identity_of(const EvaluationData& data, std::span<const std::string> hold_out);

}  // namespace abrazo

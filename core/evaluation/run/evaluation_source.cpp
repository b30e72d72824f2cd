#include "core/evaluation/run/evaluation_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/base/text.hpp"

namespace abrazo {

Result<std::set<EvaluationPart>> evaluation_parts(std::span<const std::string> names) {
  std::set<EvaluationPart> parts;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(evaluation_part_names, name);
    if (found == evaluation_part_names.end() && name != "all")
      return Error{fmt::format("{} is no part of the evaluation; there are {}, and all", in_quotes(name),
                               fmt::join(evaluation_part_names, ", ")),
                   ""};
    for (std::size_t part = 0; part < evaluation_part_names.size(); ++part)
      if (name == "all" || name == evaluation_part_names[part])
        parts.insert(static_cast<EvaluationPart>(part));
  }
  return parts;
}

Result<EvaluationManifests> read_manifests(const EvaluationSource& source) {
  auto manifest = read_manifest(source.manifest);
  if (!manifest) return manifest.error();
  EvaluationManifests manifests{.manifest = std::move(*manifest), .users = {}};
  if (!source.users.empty()) {
    auto users = read_manifest(source.users);
    if (!users) return users.error();
    manifests.users = std::move(*users);
  }
  const Manifest* const users = manifests.users ? &*manifests.users : nullptr;
  if (const Status usable = check_answered(manifests.manifest, users, source.hold_out); !usable)
    return usable.error();
  return manifests;
}

Result<EvaluationData> read_evaluation_data(const EvaluationManifests& manifests, bool both_roles,
                                            const Progress& progress) {
  return read_evaluation_data(manifests.manifest, manifests.users ? &*manifests.users : nullptr, both_roles,
                              progress);
}

}  // namespace abrazo

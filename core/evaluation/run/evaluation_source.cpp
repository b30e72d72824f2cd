#include "core/evaluation/run/evaluation_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/base/checksum.hpp"
#include "core/base/text.hpp"

namespace abrazo {

namespace {

void add_take(ContentHash& hash, const PairedTake& take) {
  hash.add(std::string_view(take.name));
  hash.add(take.fps);
  for (const Clip* clip : {&take.a, &take.b})
    for (const Pose& pose : clip->poses)
      for (const double coordinate : pose.reshaped()) hash.add(coordinate);
  for (const RoleInterval& role : take.roles)
    for (const int word : {role.start, role.end, static_cast<int>(role.active)})
      hash.add(static_cast<std::uint64_t>(word));
  for (const LabelInterval& label : take.labels) {
    for (const int word : {label.start, label.end}) hash.add(static_cast<std::uint64_t>(word));
    hash.add(std::string_view(label.label));
  }
}

}  // namespace

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

std::string identity_of(const EvaluationData& data, std::span<const std::string> hold_out) {
  ContentHash hash;
  for (const std::vector<PairedTake>* takes : {&data.takes, &data.users})
    for (const PairedTake& take : *takes) add_take(hash, take);
  std::string name =
      fmt::format("{} ({} pairs, checksum {})", data.name, data.library->pair_count(), hash.text());
  if (!data.users_name.empty()) name += ", users " + data.users_name;
  if (data.both_roles) name += ", both roles";
  if (!hold_out.empty()) name += fmt::format(", answered {}", fmt::join(hold_out, " "));
  return name;
}

}  // namespace abrazo

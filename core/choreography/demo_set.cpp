#include "core/choreography/demo_set.hpp"

#include <fmt/core.h>

#include <span>
#include <string_view>

#include "core/base/json_text.hpp"
#include "core/base/output_file.hpp"
#include "core/library/takes/performer_letter.hpp"
#include "core/motion/bvh/bvh.hpp"

namespace abrazo {
namespace {

namespace fs = std::filesystem;

std::string motion_name(const PairedTake& take, char performer) {
  return fmt::format("{}_{}.bvh", take.name, performer);
}

std::string labels_csv(const std::vector<PairedTake>& takes) {
  std::string text = "take,start_frame,end_frame,label,detail,confidence\n";
  for (const PairedTake& take : takes)
    for (const LabelInterval& label : take.labels)
      text += fmt::format("{},{},{},{},{},{}\n", take.name, label.start, label.end, label.label, label.detail,
                          label.confidence);
  return text;
}

/// Intervals must be in order, within the take and without overlap, or they could not be read back.
Status check_roles(const PairedTake& take) {
  const int frames = static_cast<int>(take.a.poses.size());
  int covered = 0;
  for (const RoleInterval& role : take.roles) {
    if (role.start < covered || role.end <= role.start || role.end > frames)
      return Error{
          fmt::format("the role of frames {} to {} overlaps another, is empty, or goes beyond the {} "
                      "frames of the take",
                      role.start, role.end, frames),
          take.name};
    covered = role.end;
  }
  return Done{};
}

void write_roles(const PairedTake& take, JsonText& json) {
  const bool throughout = take.roles.size() == 1 && take.roles.front().start == 0 &&
                          take.roles.front().end == static_cast<int>(take.a.poses.size());
  if (take.roles.empty() || throughout) {
    json.value(take.roles.empty() ? std::string_view("unknown") : letter_of(take.roles.front().active));
    return;
  }
  write_role_list(json, take.roles);
}

Result<std::string> manifest_json(const std::vector<PairedTake>& takes, const std::string& name) {
  JsonText json;
  json.begin_object().key("name").value(name).key("takes").begin_array();
  for (const PairedTake& take : takes) {
    if (Status fine = check_roles(take); !fine) return fine.error();
    json.begin_object()
        .key("name")
        .value(take.name)
        .key("fps")
        .value(take.fps)
        .key("metres_per_unit")
        .value(1);
    for (const char performer : {'a', 'b'}) {
      json.key(std::string_view(&performer, 1))
          .begin_object()
          .key("motion")
          .value(motion_name(take, performer));
      json.end_object();
    }
    json.key("roles");
    write_roles(take, json);
    json.key("labels").value("labels.csv").end_object();
  }
  return json.end_array().end_object().take() + "\n";
}

Status add_motions(const PairedTake& take, const fs::path& folder, WholeFiles& files) {
  for (const char performer : {'a', 'b'}) {
    const Result<std::string> bvh = write_bvh(std::span(performer == 'a' ? &take.a : &take.b, 1));
    if (!bvh) return bvh.error();
    if (Status added = files.add((folder / motion_name(take, performer)).string(), *bvh); !added)
      return added;
  }
  return Done{};
}

}  // namespace

Result<fs::path> write_demo_set(const std::vector<PairedTake>& takes, const std::string& name,
                                const fs::path& folder, const Progress& progress) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || !fs::is_directory(folder, failure))
    return Error{"the folder cannot be made (" + (failure ? failure.message() : "a file has its name") +
                     "); choose another",
                 folder.string()};
  WholeFiles files;
  for (std::size_t t = 0; t < takes.size(); ++t) {
    if (!report(progress, static_cast<double>(t) / static_cast<double>(takes.size()),
                "writing " + takes[t].name))
      return Error{"cancelled", folder.string()};
    if (Status added = add_motions(takes[t], folder, files); !added) return added.error();
  }
  const Result<std::string> manifest = manifest_json(takes, name);
  if (!manifest) return manifest.error();
  if (Status added = files.add((folder / "labels.csv").string(), labels_csv(takes)); !added)
    return added.error();
  if (Status added = files.add((folder / "manifest.json").string(), *manifest); !added) return added.error();
  if (Status committed = files.commit(); !committed) return committed.error();
  report(progress, 1, "done");
  return folder / "manifest.json";
}

}  // namespace abrazo

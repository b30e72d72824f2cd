#include "core/opening/open_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/text.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/opening/generated_set.hpp"
#include "core/opening/import_rules.hpp"
#include "core/opening/joint_maps.hpp"
#include "core/opening/library_search.hpp"
#include "core/opening/session_material.hpp"

namespace abrazo {
namespace {

MotionReading files_in(const SortedFiles& files, const MotionReading& said) {
  MotionReading reading = said;
  reading.file = files.motion;
  if (!files.skeleton.empty()) reading.skeleton = files.skeleton;
  if (!files.joint_map.empty()) reading.joint_map = files.joint_map;
  return reading;
}

/// The clips become the input.
void take_input(const MotionReading& reading, std::vector<ImportedClip> clips, Material& material) {
  const std::string name = std::filesystem::path(reading.file).filename().string();
  ImportedClip& first = clips.front();
  if (clips.size() > 1)
    material.warnings.push_back(name + ": has " + std::to_string(clips.size()) + " performers; the first, " +
                                first.clip.name + ", plays the user");
  for (const ImportWarning& warning : first.report.warnings)
    material.warnings.push_back(name + ": " + warning.detail);
  material.input = std::move(first.clip);
  material.reading = reading;
  material.excluded_takes.clear();
}

/// With a joint map that was remembered for points like these, where no other fits.
Result<std::vector<ImportedClip>> with_remembered_map(MotionPoints& points, MotionReading& reading,
                                                      const std::string& folder, const Progress& progress) {
  auto clips = points.performers(reading, progress);
  if (clips || folder.empty() || !reading.joint_map.empty()) return clips;
  for (const NamedMotion& motion : points.motions())
    if (!joints_are_known(motion)) {
      reading.joint_map = remembered_map(motion, folder);
      break;
    }
  return reading.joint_map.empty() ? clips : points.performers(reading, progress);
}

/// The take of the open library whose performer was read from this file, else from one beside it of the same
/// kind.
/// @param library  a file that is opened with it; empty = the open library
std::optional<std::pair<Manifest::Take, Manifest::Performer>> take_like(const std::string& file,
                                                                        const std::string& library,
                                                                        const Material& open) {
  const bool is_open = library.empty();
  const std::string& library_file = is_open ? open.library_file : library;
  std::optional<Manifest> of_file;
  if (std::filesystem::path(library_file).extension() == ".json")
    if (auto read = read_manifest(library_file)) of_file = std::move(*read);
  const Manifest* manifest = of_file ? &*of_file : is_open ? open.manifest.get() : nullptr;
  if (!manifest) return std::nullopt;
  std::error_code failure;
  const auto place = [&failure](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(path, failure);
  };
  const std::filesystem::path wanted = place(file);
  std::optional<std::pair<Manifest::Take, Manifest::Performer>> found;
  for (const Manifest::Take& take : manifest->takes)
    for (const Manifest::Performer* performer : {&take.a, &take.b}) {
      const std::filesystem::path motion = place(performer->motion);
      if (motion == wanted) return std::pair(take, *performer);
      if (!found && motion.parent_path() == wanted.parent_path() && motion.extension() == wanted.extension())
        found.emplace(take, *performer);
    }
  return found;
}

/// What the file does not say is read as in the library that is open: a capture at 60 Hz that answers at 120
/// dances twice as fast as the takes it was recorded with.
/// @return in words what was taken from there; empty = nothing
std::string read_as_in_library(const ImportReport& report, const std::string& library, const Material& open,
                               MotionReading& reading) {
  const auto like = take_like(reading.file, library, open);
  if (!like) return {};
  const auto& [take, performer] = *like;
  const auto unit = performer.metres_per_unit ? performer.metres_per_unit : take.metres_per_unit;
  std::string words;
  const auto note = [&words](const std::string& what) { words += (words.empty() ? "" : ", ") + what; };
  if (report.fps_guessed && !reading.fps && take.fps) {
    reading.fps = take.fps;
    note(exact_text(*take.fps) + " frames per second");
  }
  if (report.unit_guessed && !reading.metres_per_unit && unit) {
    reading.metres_per_unit = unit;
    note(exact_text(*unit) + " m per unit");
  }
  if (report.up_axis_guessed && reading.up.empty() && performer.up_axis) {
    reading.up = std::string(name_of(*performer.up_axis));
    note("up axis " + reading.up);
  }
  return words;
}

/// By the person's choices, otherwise by the rule for similar files, otherwise as found; then notes whether
/// the file leaves questions. @return the report of the motion as it was read
Result<ImportReport> read_as_wished(const SortedFiles& files, const OpeningWish& wish, Material& material,
                                    const Progress& progress) {
  MotionPoints points;
  MotionReading reading = files_in(files, wish.said.value_or(MotionReading{}));
  auto clips = with_remembered_map(points, reading, wish.joint_maps, progress);
  bool settled = wish.said.has_value(), suits = true;
  if (!settled && !wish.import_rules.empty()) {
    const StoredRules stored = import_rules(wish.import_rules);
    if (const ImportRule* rule = rule_for(stored.rules, reading.file, layout_of(points.motions()))) {
      MotionReading ruled = files_in(files, rule->how);
      auto said = points.performers(ruled, progress);
      suits = said.ok();
      if (suits)
        clips = std::move(said), reading = std::move(ruled), settled = true;
      else
        material.warnings.push_back("the rule for similar files does not suit it (" + said.error().text() +
                                    "); it was read as found");
    }
  }
  if (!clips) return clips.error();
  if (!settled) {
    MotionReading like_library = reading;
    const std::string taken =
        read_as_in_library(clips->front().report, files.library, wish.open, like_library);
    auto said = taken.empty() ? clips : points.performers(like_library, progress);
    if (!taken.empty() && said) {
      clips = std::move(said), reading = std::move(like_library);
      material.warnings.push_back(std::filesystem::path(reading.file).filename().string() +
                                  " does not say it, so it was read as the takes of the library: " + taken);
    }
  }
  material.is_doubtful = !settled && (!suits || clips->size() > 1 || clips->front().report.asks());
  ImportReport report = clips->front().report;
  take_input(reading, std::move(*clips), material);
  return report;
}

/// A library file does not say how its motion files were read, but its takes have a rate.
void compare_rates(const ImportReport& report, Material& material) {
  const std::vector<LibraryTake>& takes = material.library->takes();
  if (!report.fps_guessed || material.is_generated || takes.empty()) return;
  const double rate = takes.front().fps;
  const bool is_one =
      std::ranges::all_of(takes, [rate](const LibraryTake& take) { return take.fps == rate; });
  if (!is_one || rate == material.input.fps) return;
  material.warnings.insert(
      material.warnings.begin(),
      fmt::format("{} does not state its frame rate and is played at {} per second; the takes of the library "
                  "have {}: set that if it was captured with them",
                  material.input.name, exact_text(material.input.fps), exact_text(rate)));
}

Result<Material> open_as_session(const SortedFiles& files, const OpeningWish& wish,
                                 const Progress& progress) {
  report(progress, 0, "Opening " + std::filesystem::path(files.session).filename().string());
  auto session = open_session(files.session, wish.autosaves);
  if (!session) return session.error();
  const bool asks = wish.locate && wish.files.size() == 1 && !session->project->missing().empty();
  if (asks) {
    const auto places = wish.locate(session->project, progress);
    if (!places) return Error{"cancelled", files.session};
    session = with_places(std::move(*session), *places);
  }
  return material_of(*session, {files.library, wish.open, asks}, progress);
}

/// The requested library with the open input; a take of a new library plays the user.
Status add_library(const SortedFiles& files, const Progress& progress, Material& material) {
  auto opened = files.library.empty() ? generated_dance(progress) : open_library(files.library, progress);
  if (!opened) return opened.error();
  if (files.library.empty())
    opened->warnings.emplace_back(
        "no library is open: a generated dance answers; open a library (.h5) or a manifest");
  opened->input = std::move(material.input);
  opened->reading = std::move(material.reading);
  opened->is_doubtful = material.is_doubtful;
  opened->is_input_asked = material.is_input_asked;
  opened->warnings.insert(opened->warnings.begin(), material.warnings.begin(), material.warnings.end());
  material = std::move(*opened);
  return Done{};
}

}  // namespace

Result<Material> open_files(const OpeningWish& wish, const Progress& progress) {
  const auto files = sorted(wish.files);
  if (!files) return files.error();
  if (!files->session.empty()) return open_as_session(*files, wish, progress);
  Material material = for_next_session(wish.open);
  const bool has_motion = !files->motion.empty();
  material.is_input_asked = has_motion;
  ImportReport report;
  if (has_motion) {
    auto read = read_as_wished(*files, wish, material, progress);
    if (!read) return read.error();
    report = std::move(*read);
  }
  if (!files->library.empty() || !material.library)
    if (const Status added = add_library(*files, progress, material); !added) return added.error();
  if (has_motion) {
    compare_rates(report, material);
    return material;
  }
  return danced_with(material, static_cast<int>(material.library->takes().size()) - 1);
}

Status read_input(const MotionReading& reading, Material& material, const Progress& progress) {
  auto clips = read_performers(reading, progress);
  if (!clips) return clips.error();
  take_input(reading, std::move(*clips), material);
  return Done{};
}

}  // namespace abrazo

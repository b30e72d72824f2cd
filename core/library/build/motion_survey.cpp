#include <algorithm>

#include "core/base/text.hpp"
#include "core/library/build/library_plan.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

/// The .asf that goes with an .amc among those beside it; empty when none does.
fs::path skeleton_beside(const fs::path& motion) {
  std::vector<std::string> skeletons;
  std::error_code ignored;
  const fs::path folder = motion.has_parent_path() ? motion.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (lower_case(entry.path().extension().string()) == ".asf") skeletons.push_back(entry.path().string());
  std::sort(skeletons.begin(), skeletons.end());
  return guess_skeleton(motion.string(), skeletons);
}

PlannedPerformer unread(const Manifest::Performer& source, std::optional<double> fps, const Error& error) {
  PlannedPerformer performer;
  performer.source = source;
  performer.fps = fps;
  performer.name = source.motion.stem().string();
  performer.trouble = error;
  return performer;
}

}  // namespace

std::vector<PlannedPerformer> survey_motion(const Manifest::Performer& wanted, std::optional<double> fps,
                                            const Progress& progress) {
  Manifest::Performer source = wanted;
  const bool needs_skeleton = lower_case(source.motion.extension().string()) == ".amc";
  if (needs_skeleton && source.skeleton.empty()) source.skeleton = skeleton_beside(source.motion);
  const auto options = import_options(source, fps);
  if (!options) return {unread(source, fps, options.error())};
  auto clips = load_motion(source.motion.string(), source.skeleton.string(), *options, progress);
  if (!clips) return {unread(source, fps, clips.error())};
  std::vector<PlannedPerformer> performers;
  for (ImportedClip& imported : *clips) {
    PlannedPerformer performer;
    performer.source = source;
    performer.source.index = static_cast<int>(performers.size());
    performer.fps = fps;
    performer.name = imported.clip.name;
    performer.in_the_file = static_cast<int>(clips->size());
    performer.report = std::move(imported.report);
    performer.clip = std::make_shared<const Clip>(std::move(imported.clip));
    performers.push_back(std::move(performer));
  }
  return performers;
}

}  // namespace abrazo

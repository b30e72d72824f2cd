#include "core/library/build/dataset_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/library/build/library_plan.hpp"
#include "core/library/takes/performer_name.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "core/motion/joints/performers.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

constexpr int deepest = 12;
constexpr std::size_t most_listed = 40;  ///< pairs that are not certain, each on its own line

/// All files below a folder, relative to it, in the order of their names.
Result<std::vector<fs::path>> files_below(const fs::path& folder) {
  std::error_code trouble;
  if (!fs::is_directory(folder, trouble)) return Error{"is no folder", folder.string()};
  std::vector<fs::path> files;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, trouble), end;
  for (; !trouble && entry != end; entry.increment(trouble)) {
    if (entry.depth() >= deepest) entry.disable_recursion_pending();
    if (std::error_code ignored; entry->is_regular_file(ignored))
      files.push_back(entry->path().lexically_relative(folder));
  }
  if (trouble) return Error{"cannot be listed: " + trouble.message(), folder.string()};
  std::sort(files.begin(), files.end());
  return files;
}

/// Labels of the same name beside the first performer's file, or anywhere below the folder when they are
/// alone there.
fs::path labels_for(const fs::path& first, const std::vector<fs::path>& files) {
  std::string stem = first.stem().string();
  const auto cut = stem.find_last_of("_-.");
  for (const std::string& name : {stem, cut == std::string::npos ? stem : stem.substr(0, cut)})
    for (const std::string ending : {".txt", ".eaf"})
      for (const fs::path& file : files)
        if (lower_case(file.filename().string()) == lower_case(name + ending)) return file;
  return {};
}

/// Tables without a motion are no news: labels and lists are often beside the motions.
bool is_worth_telling(const PlannedPerformer& unread) {
  return format_of_name(unread.source.motion.string()) != MotionFormat::PointCsv;
}

/// One entry for each performer of each motion file below the folder.
LibraryPlan survey(const DatasetFolder& wanted, const Dataset& dataset, const std::vector<fs::path>& files) {
  LibraryPlan plan;
  plan.name = wanted.folder.filename().empty() ? wanted.folder.parent_path().filename().string()
                                               : wanted.folder.filename().string();
  for (const fs::path& file : files) {
    const auto format = format_of_name(file.string());
    if (!format || *format == MotionFormat::Asf || wanted.folder / file == wanted.body_model) continue;
    Manifest::Performer source{.motion = wanted.folder / file};
    source.metres_per_unit = dataset.metres_per_unit;
    source.up_axis = dataset.up_axis;
    source.body_model = wanted.body_model;
    for (PlannedPerformer& performer : survey_motion(source, dataset.fps)) {
      if (performer.trouble && !is_worth_telling(performer)) continue;
      plan.performers.push_back(std::move(performer));
    }
  }
  return plan;
}

std::string shown(const PlannedPerformer& performer, const fs::path& folder) {
  const std::string file = performer.source.motion.lexically_relative(folder).string();
  return performer.in_the_file > 1 ? file + ", " + performer.name : file;
}

/// Takes nothing apart that is certain: the others are listed and lose their take.
void leave_out_what_is_unsure(LibraryPlan& plan, const fs::path& folder, std::vector<std::string>& warnings) {
  std::map<std::string, std::string> obstacles;
  for (const PlanRemark& remark : remarks_on(plan))
    if (remark.kind == PlanRemark::Kind::Obstacle && remark.performer >= 0)
      obstacles.emplace(plan.performers[static_cast<std::size_t>(remark.performer)].take, remark.text);
  std::size_t unsure = 0;
  std::set<std::string> dropped;
  for (std::size_t i = 0; i + 1 < plan.performers.size(); ++i) {
    const PlannedPerformer &one = plan.performers[i], &other = plan.performers[i + 1];
    if (one.take.empty() || one.take != other.take) continue;
    const bool is_unsure = one.guess && one.guess->confidence() == Confidence::Unsure;
    const auto obstacle = obstacles.find(one.take);
    if (!is_unsure && obstacle == obstacles.end()) continue;
    dropped.insert(one.take);
    if (++unsure > most_listed) continue;
    warnings.push_back(fmt::format("not certain, left out: {} + {} ({})", shown(one, folder),
                                   shown(other, folder), is_unsure ? one.guess->reason : obstacle->second));
  }
  if (unsure > most_listed)
    warnings.push_back(fmt::format("{} more pairs are not certain and were left out", unsure - most_listed));
  for (PlannedPerformer& performer : plan.performers)
    if (dropped.contains(performer.take)) performer.take.clear(), performer.guess.reset();
  if (unsure > 0)
    warnings.push_back(
        "pairs that are not certain: those that are pairs can be added to the manifest, or chosen in the "
        "window (Library > Build library)");
}

/// The files that have no partner or cannot be read, and what is to be known of the takes.
void warn_of_the_rest(const LibraryPlan& plan, const fs::path& folder, std::vector<std::string>& warnings) {
  std::vector<std::string> alone, unread;
  std::string first_trouble;
  for (const PlannedPerformer& performer : plan.performers) {
    if (performer.trouble && first_trouble.empty()) first_trouble = performer.trouble->message;
    if (performer.trouble)
      unread.push_back(shown(performer, folder));
    else if (performer.take.empty())
      alone.push_back(shown(performer, folder));
  }
  if (!alone.empty())
    warnings.push_back(fmt::format("{} performers have no certain partner and were left out: {}",
                                   alone.size(), some_of(alone)));
  if (!unread.empty())
    warnings.push_back(fmt::format("{} files cannot be read and were left out: {}. The first: {}",
                                   unread.size(), some_of(unread), first_trouble));
  for (const PlanRemark& remark : remarks_on(plan))
    if (remark.kind == PlanRemark::Kind::Warning && remark.about.starts_with("take "))
      warnings.push_back(remark.whole());
}

Status read_label_names(const fs::path& labels, LibraryPlan& plan) {
  if (labels.empty()) return Done{};
  const auto text = read_whole_file(labels);
  if (!text) return text.error();
  plan.labels = labels;
  plan.labelled_takes = takes_in_labels(*text);
  name_like_labels(plan);
  return Done{};
}

/// "left_punch_12" -> "left_punch".
std::string without_number(std::string name) {
  while (!name.empty() && std::string_view("0123456789_- ").find(name.back()) != std::string_view::npos)
    name.pop_back();
  return name;
}

void name_moves(const DatasetFolder& wanted, const std::vector<fs::path>& files, Manifest& manifest) {
  for (Manifest::Take& take : manifest.takes) {
    const fs::path first = take.a.motion.lexically_relative(wanted.folder).parent_path();
    const fs::path second = take.b.motion.lexically_relative(wanted.folder).parent_path();
    // Where each performer has a folder, the move is that above both.
    const fs::path folder = first == second ? first : first.parent_path();
    if (wanted.moves == MovesFrom::Folders) take.move = folder.filename().string();
    if (wanted.moves == MovesFrom::Names) take.move = without_number(take.name);
    if (wanted.moves == MovesFrom::LabelFiles && wanted.labels.empty())
      if (const fs::path labels = labels_for(take.a.motion, files); !labels.empty())
        take.labels = wanted.folder / labels;
  }
}

}  // namespace

const std::vector<Dataset>& datasets() {
  static const std::vector<Dataset> all = {
      {"folder"},
      {.name = "compas3d", .up_axis = UpAxis::Z},
      {.name = "interx", .fps = 120},
      {.name = "interhuman", .fps = 30, .up_axis = UpAxis::Z},
      {.name = "remocap", .metres_per_unit = 0.001, .up_axis = UpAxis::Y}};
  return all;
}

Result<Manifest> plan_dataset(const DatasetFolder& wanted) {
  const auto dataset = std::ranges::find(datasets(), wanted.dataset, &Dataset::name);
  if (dataset == datasets().end()) {
    std::vector<std::string> names;
    for (const Dataset& each : datasets()) names.push_back(each.name);
    return Error{"there is no dataset '" + wanted.dataset + "'; expected one of " + some_of(names), ""};
  }
  const auto files = files_below(wanted.folder);
  if (!files) return files.error();
  LibraryPlan plan = survey(wanted, *dataset, *files);
  pair_up(plan);
  std::vector<std::string> warnings;
  leave_out_what_is_unsure(plan, wanted.folder, warnings);
  if (const Status named = read_label_names(wanted.labels, plan); !named) return named.error();
  warn_of_the_rest(plan, wanted.folder, warnings);
  const bool any = std::ranges::any_of(plan.performers, [](const auto& one) { return !one.take.empty(); });
  if (!any) {
    std::string found;
    for (const std::string& warning : warnings) found += "\n  " + warning;
    return Error{fmt::format("holds no certain pair among {} files; expected two motion files whose names or "
                             "folders differ by one word or number (leader, follower; a, b; p1, p2; C0, C1), "
                             "or files with two performers{}",
                             files->size(), found),
                 wanted.folder.string()};
  }
  Manifest manifest = manifest_of(plan);
  manifest.warnings = std::move(warnings);
  name_moves(wanted, *files, manifest);
  return manifest;
}

}  // namespace abrazo

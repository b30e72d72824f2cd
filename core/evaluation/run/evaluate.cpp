#include "core/evaluation/run/evaluate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/evaluation/run/selection_table.hpp"
#include "core/evaluation/tables/move_table.hpp"
#include "core/evaluation/tables/run_measures.hpp"
#include "core/evaluation/takes/take_synthesis.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/synthesis/step/clip_synthesis.hpp"

namespace abrazo {

namespace {

Error evaluation_cancelled(const EvaluationData& data) {
  return {"cancelled", data.name};
}

Result<std::vector<PairedTake>> read_takes(const Manifest& manifest, const Progress& progress,
                                           std::vector<std::string>& warnings) {
  warnings.insert(warnings.end(), manifest.warnings.begin(), manifest.warnings.end());
  std::vector<PairedTake> takes;
  for (const Manifest::Take& entry : manifest.takes) {
    const double fraction = static_cast<double>(takes.size()) / static_cast<double>(manifest.takes.size());
    if (!report(progress, fraction, "reading " + entry.name)) return Error{"cancelled", manifest.name};
    auto take = load_take(entry, warnings, part(progress, fraction, fraction));
    if (!take) return take.error();
    takes.push_back(std::move(*take));
  }
  return takes;
}

/// What is measured for one kind of user.
struct Wanted {
  bool moves = false, zmp = false, contact = false, published = false;
  bool any() const { return moves || zmp || contact || published; }
};

Wanted wanted_of(const EvaluationOptions& options) {
  return {.moves = options.parts.contains(EvaluationPart::Moves),
          .zmp = options.parts.contains(EvaluationPart::Zmp),
          .contact = options.parts.contains(EvaluationPart::Contact),
          .published = options.parts.contains(EvaluationPart::Published)};
}

Result<std::vector<SynthesisedTake>> synthesise(const EvaluationData& data,
                                                const std::vector<const PairedTake*>& takes,
                                                const EvaluationOptions& options, const UserVariant& variant,
                                                const Progress& progress) {
  std::vector<std::optional<Result<SynthesisedTake>>> runs(takes.size());
  const bool finished =
      for_each_row(takes.size(), 1, progress, "answering " + variant.name, [&](std::size_t t) {
        runs[t] = synthesise_take(data.library, *takes[t],
                                  {.settings = options.settings,
                                   .both_roles = data.both_roles,
                                   .leave_out = data.users.empty(),
                                   .variant = variant,
                                   .seed = options.seed + static_cast<unsigned>(t)});
      });
  if (!finished) return evaluation_cancelled(data);
  std::vector<SynthesisedTake> synthesised;
  for (std::optional<Result<SynthesisedTake>>& run : runs) {
    if (!*run) return run->error();
    synthesised.push_back(std::move(**run));
  }
  return synthesised;
}

Result<UserResult> measure_user(const EvaluationData& data, const std::vector<const PairedTake*>& takes,
                                const EvaluationOptions& options, const UserVariant& variant,
                                const Progress& progress) {
  const auto runs = synthesise(data, takes, options, variant, part(progress, 0, 0.9));
  if (!runs) return runs.error();
  if (!report(progress, 0.9, "measuring " + variant.name)) return evaluation_cancelled(data);
  UserResult result;
  result.user = variant.name;
  result.moves = count_moves(*runs, *data.library, data.both_roles);
  result.zmp = measure_zmp(*runs, ZmpSettings{});
  result.contact = measure_contact(*runs, *data.library);
  result.partner = measure_partner(*runs);
  result.movement = measure_movement(*runs);
  result.solve = measure_solve_times(*runs);
  if (!wanted_of(options).published || variant.name != UserVariant{}.name) return result;
  auto published = measure_published(*runs, data.library, data.both_roles);
  if (!published) return published.error();
  result.published = *published;
  return result;
}

Status measure_users(const EvaluationData& data, const std::vector<const PairedTake*>& takes,
                     const EvaluationOptions& options, const Progress& progress, Evaluation& evaluation) {
  struct Group {
    std::vector<UserVariant> variants;
    std::vector<UserResult> results;
  };
  Group as_is{{UserVariant{}}, {}}, builds, disturbed;
  const Wanted wanted = wanted_of(options);
  if (options.variants && wanted.moves) builds.variants = other_builds();
  if (options.variants && wanted.contact) disturbed.variants = disturbances();
  const double share = 1.0 / static_cast<double>(1 + builds.variants.size() + disturbed.variants.size());
  double done = 0;
  for (Group* group : {&as_is, &builds, &disturbed})
    for (const UserVariant& variant : group->variants) {
      auto result = measure_user(data, takes, options, variant, part(progress, done, done + share));
      if (!result) return result.error();
      group->results.push_back(std::move(*result));
      done += share;
    }
  evaluation.result = std::move(as_is.results.front());
  evaluation.builds = std::move(builds.results);
  evaluation.disturbed = std::move(disturbed.results);
  evaluation.has_moves = wanted.moves;
  evaluation.has_zmp = wanted.zmp;
  evaluation.has_contact = wanted.contact;
  return Done{};
}

/// The rate at which the takes are answered; 0 when it differs.
double common_step_rate(const std::vector<const PairedTake*>& takes, const Settings& settings) {
  double rate_hz = -1;
  for (const PairedTake* take : takes) {
    const double own = clip_step_rate(take->a, settings);
    if (rate_hz >= 0 && own != rate_hz) return 0;
    rate_hz = own;
  }
  return std::max(0.0, rate_hz);
}

/// Steps are frames, so a rate that is no whole part of the clip's has steps unevenly apart.
bool is_uneven(double fps, double step_rate_hz) {
  const double frames_a_step = fps / step_rate_hz;
  return std::abs(frames_a_step - std::round(frames_a_step)) > 1e-6;
}

void remark_on(const std::vector<const PairedTake*>& takes, Evaluation& evaluation) {
  for (const PairedTake* take : takes) {
    if (evaluation.has_moves && std::none_of(take->labels.begin(), take->labels.end(),
                                             [](const auto& label) { return is_move(label.label); }))
      evaluation.remarks.push_back("take " + take->name +
                                   " has no labelled moves and does not count in them");
    const double rate_hz = clip_step_rate(take->a, evaluation.settings);
    if (evaluation.result && is_uneven(take->a.fps, rate_hz))
      evaluation.remarks.push_back(fmt::format(
          "take {0} has {1:g} frames a second, which {2:g} steps a second do not divide: steps are unevenly "
          "apart, which distorts accelerations, and so the ZMP errors of capture and synthesis; choose a "
          "step rate that divides {1:g}",
          take->name, take->a.fps, rate_hz));
  }
}

template <typename Takes>
std::vector<std::string> names_of(const Takes& takes) {
  std::vector<std::string> names;
  for (const auto& take : takes) names.push_back(take.name);
  return names;
}

/// @param data  name of the takes, for messages
Status check_names(const std::vector<std::string>& known, bool leave_out,
                   const std::vector<std::string>& hold_out, const std::string& data) {
  if (leave_out && known.size() < 2)
    return Error{"leaving a take out needs at least two takes; name more of them, or give other users' takes",
                 data, Hint::NameUsers};
  for (const std::string& name : hold_out)
    if (std::find(known.begin(), known.end(), name) == known.end())
      return Error{
          fmt::format("there is no take of this name to be answered; there are {}", fmt::join(known, ", ")),
          name};
  return Done{};
}

}  // namespace

Result<EvaluationData> read_evaluation_data(const Manifest& manifest, const Manifest* users, bool both_roles,
                                            const Progress& progress) {
  EvaluationData data;
  data.name = manifest.name;
  data.both_roles = both_roles;
  auto takes = read_takes(manifest, part(progress, 0, 0.4), data.warnings);
  if (!takes) return takes.error();
  data.takes = std::move(*takes);
  if (users != nullptr) {
    auto read = read_takes(*users, part(progress, 0.4, 0.5), data.warnings);
    if (!read) return read.error();
    data.users = std::move(*read);
    data.users_name = users->name;
  }
  auto library =
      build_library(manifest.name, data.takes,
                    {.excluded_takes = {}, .rate_hz = {}, .both_roles = both_roles}, part(progress, 0.5, 1));
  if (!library) return library.error();
  data.library = std::make_shared<const MotionLibrary>(std::move(*library));
  return data;
}

Status check_answered(const Manifest& manifest, const Manifest* users,
                      const std::vector<std::string>& hold_out) {
  return check_names(names_of((users != nullptr ? *users : manifest).takes), users == nullptr, hold_out,
                     manifest.name);
}

Result<std::vector<const PairedTake*>> answered_takes(const EvaluationData& data,
                                                      const EvaluationOptions& options) {
  const std::vector<PairedTake>& all = data.users.empty() ? data.takes : data.users;
  if (const Status usable = check_names(names_of(all), data.users.empty(), options.hold_out, data.name);
      !usable)
    return usable.error();
  std::vector<const PairedTake*> takes;
  if (options.hold_out.empty())
    for (const PairedTake& take : all) takes.push_back(&take);
  for (const std::string& name : options.hold_out) {
    const PairedTake& take =
        *std::find_if(all.begin(), all.end(), [&](const PairedTake& t) { return t.name == name; });
    if (std::find(takes.begin(), takes.end(), &take) == takes.end()) takes.push_back(&take);
  }
  return takes;
}

Result<Evaluation> evaluate(const EvaluationData& data, const EvaluationOptions& options,
                            const Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  const auto takes = answered_takes(data, options);
  if (!takes) return takes.error();
  Evaluation evaluation;
  evaluation.data = data.name;
  evaluation.users = data.users_name;
  evaluation.settings = options.settings;
  evaluation.step_rate_hz = common_step_rate(*takes, options.settings);
  evaluation.both_roles = data.both_roles;
  evaluation.library_pairs = data.library->pair_count();
  for (const PairedTake* take : *takes) evaluation.takes.push_back(take->name);
  evaluation.remarks = data.warnings;

  if (options.parts.contains(EvaluationPart::Selection)) {
    auto tables = measure_selection(data, options, part(progress, 0, 0.1));
    if (!tables) return tables.error();
    evaluation.selection = std::move(*tables);
  }
  if (wanted_of(options).any())
    if (const Status done = measure_users(data, *takes, options, part(progress, 0.1, 0.6), evaluation); !done)
      return done.error();
  if (options.parts.contains(EvaluationPart::Bodies)) {
    auto table = measure_bodies(*takes, part(progress, 0.6, 0.8));
    if (!table) return table.error();
    evaluation.bodies = std::move(*table);
  }
  if (options.parts.contains(EvaluationPart::Timing)) {
    auto rows = measure_timing(data, options, part(progress, 0.8, 1));
    if (!rows) return rows.error();
    evaluation.timing = std::move(*rows);
  }
  remark_on(*takes, evaluation);
  evaluation.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return evaluation;
}

}  // namespace abrazo

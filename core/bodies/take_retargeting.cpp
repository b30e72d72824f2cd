#include "core/bodies/take_retargeting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <utility>

#include "core/base/line_file.hpp"
#include "core/base/output_file.hpp"
#include "core/base/statistics.hpp"
#include "core/bodies/retargeted_frame.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/motion/scenes/character_glb.hpp"
#include "core/synthesis/frames/recording_trace.hpp"
#include "core/synthesis/frames/trace.hpp"

namespace abrazo {

namespace {

/// Of several takes each has files of its own.
std::string file_of_take(const RetargetWish& wish, const std::string& file, const std::string& take) {
  if (wish.takes.size() == 1) return file;
  // A take's name is free text; it must not lead to another folder.
  std::string suffix = "_" + take;
  std::ranges::replace_if(
      suffix, [](char c) { return c == '/' || c == '\\' || c == ':' || static_cast<unsigned char>(c) < ' '; },
      '_');
  return with_suffix(file, suffix);
}

Status check_choices(const RetargetWish& wish) {
  if (wish.takes.empty()) return Error{"no take is chosen; choose at least one", ""};
  for (const BodyChoice* choice : {&wish.active, &wish.passive})
    if (choice->kind == BodyChoice::Kind::User) return choose_body(*choice, Body{}).error();
  for (const auto& [name, factor] :
       {std::pair{"contacts", wish.contacts}, std::pair{"smoothness", wish.smoothness}})
    if (!(factor >= 0 && factor <= RetargetWish::greatest_factor))
      return Error{fmt::format("a factor from 0 to {:g} is expected for {}, not {:g}",
                               RetargetWish::greatest_factor, name, factor),
                   ""};
  return wish.character.empty() ? check_clip_file(wish.output, {}, 2) : check_character_file(wish.output);
}

/// The files of a wish, beside their places until all are there.
struct Outputs {
  WholeFiles motions;
  std::vector<std::unique_ptr<LineFile>> traces;

  Status commit() {
    for (const auto& trace : traces)
      if (const Status closed = trace->close(); !closed) return closed;
    for (const auto& trace : traces)
      if (const Status named = trace->finish(); !named) return named;
    return motions.commit();
  }
};

Status add_motion(const RetargetedPair& pair, const RetargetWish& wish, WholeFiles& motions) {
  const std::vector<std::string> files = wish.motion_files(pair.recorded.name);
  const std::array<Clip, 2> clips = {pair.active(), pair.passive()};
  if (wish.character.empty()) {
    const auto content = clip_file_content(files.front(), clips);
    return content ? motions.add(files.front(), *content) : content.error();
  }
  const auto performed = character_performances(wish.character, clips);
  if (!performed) return performed.error();
  for (std::size_t i = 0; i < files.size(); ++i)
    if (const Status added = motions.add(files[i], (*performed)[i]); !added) return added;
  return Done{};
}

Result<std::unique_ptr<LineFile>> trace_of(const RetargetedPair& pair, const RetargetWish& wish,
                                           const std::string& source) {
  const std::string& take = pair.recorded.name;
  auto trace = LineFile::open(wish.trace_file(take));
  if (!trace) return trace.error();
  const double fps = pair.recorded.active.fps;
  (*trace)->add(trace_header_line({source, take, fps, Settings{}}));
  for (std::size_t frame = 0; frame < pair.frames.size(); ++frame)
    (*trace)->add(trace_frame_line(frame_result_of(pair, frame), wish.from + static_cast<long long>(frame),
                                   static_cast<double>(frame) / fps));
  return trace;
}

Result<RetargetedTake> add_take(const PairedTake& take, const RetargetWish& wish, const std::string& source,
                                const Progress& progress, Outputs& outputs) {
  const auto made = retarget_take(take, wish, progress);
  if (!made) return made.error();
  if (const Status added = add_motion(made->pair, wish, outputs.motions); !added) return added.error();
  if (!wish.trace.empty()) {
    auto trace = trace_of(made->pair, wish, source);
    if (!trace) return trace.error();
    outputs.traces.push_back(std::move(*trace));
  }
  RetargetedTake about = made->described();
  about.motion_files = wish.motion_files(take.name);
  return about;
}

/// The motions that a manifest names; none of a library, which has its own, nor of a manifest that cannot be
/// read, which is refused where it is.
std::vector<std::string> motions_of_manifest(const std::string& source) {
  std::error_code missing;
  if (!std::filesystem::is_regular_file(source, missing)) return {};
  char first = 0;
  if (!(std::ifstream(source) >> first) || first != '{') return {};
  const auto manifest = read_manifest(source);
  if (!manifest) return {};
  std::vector<std::string> files;
  for (const Manifest::Take& take : manifest->takes)
    for (const Manifest::Performer* performer : {&take.a, &take.b})
      for (const std::filesystem::path& file : {performer->motion, performer->skeleton})
        if (!file.empty()) files.push_back(file.string());
  return files;
}

}  // namespace

std::vector<std::string> RetargetWish::motion_files(const std::string& take) const {
  const std::string file = file_of_take(*this, output, take);
  if (character.empty()) return {file};
  return {with_suffix(file, "_active"), with_suffix(file, "_passive")};
}

std::string RetargetWish::trace_file(const std::string& take) const {
  return trace.empty() ? std::string() : file_of_take(*this, trace, take);
}

Status check_retargeting(const RetargetWish& wish, const std::string& source) {
  if (const Status usable = check_choices(wish); !usable) return usable;
  std::vector<std::string> inputs = {source, wish.character};
  for (const BodyChoice* choice : {&wish.active, &wish.passive}) inputs.push_back(choice->file);
  for (std::string& motion : motions_of_manifest(source)) inputs.push_back(std::move(motion));
  std::set<std::string> motions;
  for (const std::string& take : wish.takes)
    for (const std::string& file : wish.motion_files(take)) {
      if (const Status usable = check_output(file, inputs); !usable) return usable;
      if (!motions.insert(file).second)
        return Error{"two takes would be written to it; choose each take once", file};
    }
  if (wish.trace.empty()) return Done{};
  for (const std::string& take : wish.takes) {
    const std::string trace = wish.trace_file(take);
    if (motions.contains(trace))
      return Error{"the trace and the motion cannot share a file; name two", trace};
    if (const Status usable = check_output(trace, inputs); !usable) return usable;
  }
  return Done{};
}

std::string RetargetedTake::bodies_text() const {
  return fmt::format("{} frames, active {} ({:.2f} m), passive {} ({:.2f} m)", frames, active_body,
                     active_height_m, passive_body, passive_height_m);
}

std::string RetargetedTake::quality_text() const {
  std::string text = frames_with_holds == 0
                         ? "no hands hold one another"
                         : fmt::format("holds change by {:.1f} mm on average, at most {:.1f}",
                                       1000 * hold_change_mean_m, 1000 * hold_change_max_m);
  text += fmt::format("; bodies overlap by {:.1f} mm more at most; bones differ by {:.3f} % at most",
                      1000 * excess_max_m, 100 * bone_error_max);
  if (nearest_only > 0)
    text +=
        fmt::format("\n{} of the frames are the nearest that these bodies can do; the first at {:.2f} s: {}",
                    nearest_only, first_shortfall_s, first_shortfall);
  return text;
}

RetargetedTake TakeOnBodies::described() const {
  RetargetedTake about;
  about.name = pair.recorded.name;
  about.frames = pair.frames.size();
  about.active_body = active.name;
  about.passive_body = passive.name;
  about.active_height_m = active.body.height();
  about.passive_height_m = passive.body.height();
  std::vector<double> hold_changes_m;
  for (std::size_t frame = 0; frame < pair.frames.size(); ++frame) {
    const RetargetedFrame& made = pair.frames[frame];
    if (made.holds > 0) hold_changes_m.push_back(made.hold_change_m);
    about.hold_change_max_m = std::max(about.hold_change_max_m, made.hold_change_m);
    about.bone_error_max = std::max(about.bone_error_max, made.bone_error);
    about.excess_max_m = std::max(about.excess_max_m, made.excess_m);
    if (!made.is_nearest_only() || about.nearest_only++ > 0) continue;
    about.first_shortfall = made.shortfall();
    about.first_shortfall_s = static_cast<double>(frame) / pair.recorded.active.fps;
  }
  about.frames_with_holds = hold_changes_m.size();
  about.hold_change_mean_m = mean(hold_changes_m);
  return about;
}

Result<TakeOnBodies> retarget_take(const PairedTake& take, const RetargetWish& wish,
                                   const Progress& progress) {
  const RecordedPair whole = recorded_pair_of(take);
  const Body active = body_of(whole.active.poses), passive = body_of(whole.passive.poses);
  auto part_of_take = cut(whole, wish.from, wish.to);
  if (!part_of_take) return part_of_take.error();
  auto to_active = choose_body(wish.active, active, progress);
  if (!to_active) return to_active.error();
  auto to_passive = choose_body(wish.passive, passive, progress);
  if (!to_passive) return to_passive.error();
  FitWeights weights;
  weights.relation.contact *= wish.contacts;
  weights.relation.near *= std::min(1.0, wish.contacts);  // beyond, near pairs would work against contacts
  weights.smooth *= wish.smoothness;
  auto pair = retarget_pair(std::move(*part_of_take),
                            {{active, to_active->body}, {passive, to_passive->body}}, progress, weights);
  if (!pair) return pair.error();
  return TakeOnBodies{std::move(*pair), std::move(*to_active), std::move(*to_passive)};
}

Result<std::vector<RetargetedTake>> retarget_takes(const std::vector<PairedTake>& takes,
                                                   const RetargetWish& wish, const std::string& source,
                                                   const Progress& progress) {
  if (const Status usable = check_retargeting(wish, source); !usable) return usable.error();
  Outputs outputs;
  std::vector<RetargetedTake> all;
  for (std::size_t t = 0; t < takes.size(); ++t) {
    const auto share = [&](std::size_t done) {
      return static_cast<double>(done) / static_cast<double>(takes.size());
    };
    const Progress of_take = [go_on = part(progress, share(t), share(t + 1)), &name = takes[t].name](
                                 double fraction, std::string_view doing) {
      return report(go_on, fraction, fmt::format("{}: {}", name, doing));
    };
    auto done = add_take(takes[t], wish, source, of_take, outputs);
    if (!done) return done.error();
    all.push_back(std::move(*done));
  }
  if (!report(progress, 1, "Writing")) return Error{"cancelled", source};
  if (const Status written = outputs.commit(); !written) return written.error();
  return all;
}

}  // namespace abrazo

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>
#include <vector>

#include "app/cli/character_option.hpp"
#include "app/cli/command_line.hpp"
#include "core/base/json_text.hpp"
#include "core/bodies/take_retargeting.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/store/takes_of_library.hpp"

namespace abrazo::app {

namespace {

struct RetargetArguments {
  std::string library, manifest;
  std::string active_body = "library", passive_body = "library";
  RetargetWish wish;
  bool json = false;

  const std::string& source() const { return library.empty() ? manifest : library; }
};

Result<RetargetWish> wish_of(const RetargetArguments& arguments) {
  RetargetWish wish = arguments.wish;
  auto active = parse_body_choice(arguments.active_body);
  if (!active) return active.error();
  auto passive = parse_body_choice(arguments.passive_body);
  if (!passive) return passive.error();
  wish.active = std::move(*active);
  wish.passive = std::move(*passive);
  return wish;
}

Result<std::vector<PairedTake>> takes_of(CommandLine& line, const RetargetArguments& arguments,
                                         const Progress& progress) {
  const std::vector<std::string>& names = arguments.wish.takes;
  if (arguments.library.empty()) {
    std::vector<std::string> warnings;
    auto takes = takes_of_manifest(arguments.manifest, names, warnings, progress);
    if (!takes) return takes.error();
    for (const std::string& warning : warnings) warn(line, warning);
    return takes;
  }
  const auto library = read_library(arguments.library);
  if (!library) return library.error();
  return takes_of_library(*library, names, arguments.library);
}

std::string text_of(const RetargetedTake& take) {
  std::string quality = take.quality_text();
  for (std::size_t end = quality.find('\n'); end != std::string::npos; end = quality.find('\n', end + 1))
    quality.insert(end + 1, "  ");
  return fmt::format("{}: {}, to {}\n  {}\n", take.name, take.bodies_text(),
                     fmt::join(take.motion_files, " and "), quality);
}

std::string json_of(const std::vector<RetargetedTake>& takes) {
  JsonText json;
  json.begin_object().key("takes").begin_array();
  for (const RetargetedTake& take : takes) {
    json.begin_object();
    json.key("take").value(take.name);
    json.key("frames").value(static_cast<int>(take.frames));
    json.key("active_body").value(take.active_body);
    json.key("passive_body").value(take.passive_body);
    json.key("hold_change_mean_m").value(take.hold_change_mean_m);
    json.key("hold_change_max_m").value(take.hold_change_max_m);
    json.key("excess_penetration_max_m").value(take.excess_max_m);
    json.key("bone_length_max").value(take.bone_error_max);
    json.key("nearest_only").value(static_cast<int>(take.nearest_only));
    json.end_object();
  }
  json.end_array().end_object();
  return json.take();
}

Status run_retarget(CommandLine& line, const RetargetArguments& arguments) {
  if (arguments.library.empty() == arguments.manifest.empty())
    return Error{"the take comes from --library or from --manifest: name one of them", ""};
  const auto wish = wish_of(arguments);
  if (!wish) return wish.error();
  if (const Status usable = check_retargeting(*wish, arguments.source()); !usable) return usable;
  const Progress progress = terminal_progress(line);
  const auto takes = takes_of(line, arguments, part(progress, 0, 0.1));
  if (!takes) return takes.error();
  const auto done = retarget_takes(*takes, *wish, arguments.source(), part(progress, 0.1, 1));
  if (!done) return done.error();
  if (arguments.json) {
    answer_json(line, json_of(*done));
  } else if (!line.quiet) {
    std::string text;
    for (const RetargetedTake& take : *done) text += text_of(take);
    answer(line, text);
  }
  return Done{};
}

}  // namespace

void add_retarget_command(CommandLine& line) {
  const auto arguments = std::make_shared<RetargetArguments>();
  CLI::App* command = line.app.add_subcommand(
      "retarget", "a recorded pair on two other bodies: contacts, steps and holds stay what they were");
  CLI::Option* library =
      command->add_option("--library", arguments->library, "motion library with the take")->type_name("LIB");
  command->add_option("--manifest", arguments->manifest, "or a manifest with it (JSON)")
      ->type_name("MANIFEST")
      ->excludes(library);
  command
      ->add_option("--take", arguments->wish.takes,
                   "the take; may be repeated, which gives OUT_TAKE for each")
      ->required()
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all()
      ->type_name("TAKE");
  command->add_option("--from", arguments->wish.from, "first frame")
      ->type_name("FRAME")
      ->capture_default_str();
  command->add_option("--to", arguments->wish.to, "frame behind the last; by default all")
      ->type_name("FRAME");
  const char* const body = "library, scale:NUMBER (0.3 to 3), or a motion file whose proportions it gets";
  command->add_option("--active-body", arguments->active_body, std::string("body of who leads: ") + body)
      ->type_name("BODY")
      ->capture_default_str();
  command->add_option("--passive-body", arguments->passive_body, std::string("body of the partner: ") + body)
      ->type_name("BODY")
      ->capture_default_str();
  command
      ->add_option("--contacts", arguments->wish.contacts,
                   "weight of the recorded distances of near joints, times the usual one, 0 to 4")
      ->type_name("FACTOR")
      ->capture_default_str();
  command
      ->add_option("--smoothness", arguments->wish.smoothness,
                   "weight of the smoothed motion, times the usual one, 0 to 4")
      ->type_name("FACTOR")
      ->capture_default_str();
  CLI::Option* output = command
                            ->add_option("-o,--output", arguments->wish.output,
                                         "both characters: .bvh (two roots), .glb, .csv, .npz")
                            ->required()
                            ->type_name("FILE");
  add_character_option(*command, arguments->wish.character, output, "OUT_active and OUT_passive");
  command
      ->add_option(
          "--trace", arguments->wish.trace,
          "one JSON object per frame (JSON lines), for abrazo render: recording, mesh, result, status")
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, "the summary as one JSON object on stdout");
  command->callback([&line, arguments] {
    if (const Status done = run_retarget(line, *arguments); !done) fail(line, done.error());
  });
}

}  // namespace abrazo::app

#include <fmt/format.h>

#include <memory>
#include <string>

#include "app/cli/library_command.hpp"
#include "app/cli/text_lines.hpp"
#include "core/base/json_text.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/takes/performer_letter.hpp"

namespace abrazo::app {

namespace {

struct PairArguments {
  std::string library, take;
  int frame = 0;
  bool swapped = false;
  bool json = false;
};

template <typename Items>
void append_vertices(JsonText& json, const Items& items) {
  json.begin_array();
  for (const auto& item : items) {
    json.begin_array();
    for (const std::uint8_t vertex : item) json.value(static_cast<int>(vertex));
    json.end_array();
  }
  json.end_array();
}

std::string pair_json(const MotionLibrary& library, int pair) {
  JsonText json;
  json.begin_object();
  json.key("active").rows(library.pose(pair).topRows<joint_count>());
  json.key("passive").rows(library.pose(pair).bottomRows<joint_count>());
  json.key("features").begin_array();
  for (const double value : library.features(pair)) json.value(value);
  json.end_array();
  append_vertices(json.key("tetrahedra"), library.tetrahedra(pair));
  append_vertices(json.key("edges"), library.edges(pair));
  json.key("label");
  if (const auto label = library.label(pair); label.empty())
    json.null();
  else
    json.value(label);
  json.key("role").value(letter_of(library.source(pair).annotated));
  json.key("take")
      .value(library.take_of(pair).name)
      .key("frame")
      .value(static_cast<int>(library.source(pair).frame));
  json.key("swapped").value(library.source(pair).swapped);
  return json.end_object().take();
}

std::string pair_text(const MotionLibrary& library, int pair) {
  TextLines text;
  const auto label = library.label(pair);
  text.add("{} frame {}{}, role {}, label {}, {} edges, {} tetrahedra", library.take_of(pair).name,
           library.source(pair).frame, library.source(pair).swapped ? " swapped" : "",
           letter_of(library.source(pair).annotated), label.empty() ? "none" : label,
           library.edges(pair).size(), library.tetrahedra(pair).size());
  text.add("{:10}  {:>8} {:>8} {:>8}   {:>8} {:>8} {:>8}", "normalised", "active x", "y", "z", "passive x",
           "y", "z");
  const PairPose& pose = library.pose(pair);
  for (int joint = 0; joint < joint_count; ++joint)
    text.add("{:10}  {:8.4f} {:8.4f} {:8.4f}    {:8.4f} {:8.4f} {:8.4f}",
             joint_names[static_cast<std::size_t>(joint)], pose(joint, 0), pose(joint, 1), pose(joint, 2),
             pose(joint_count + joint, 0), pose(joint_count + joint, 1), pose(joint_count + joint, 2));
  return text.take();
}

/// Why a frame has no pair, and which frame to use instead.
Error no_such_pair(const MotionLibrary& library, const PairArguments& arguments) {
  const int index = library.find_take(arguments.take);
  if (index < 0) {
    std::string names;
    for (const LibraryTake& take : library.takes())
      names += (names.empty() ? "" : ", ") + printable_line(take.name);
    return {fmt::format("there is no take \"{}\"; there are {}", arguments.take, names), arguments.library};
  }
  const LibraryTake& take = library.takes()[static_cast<std::size_t>(index)];
  const std::string where = fmt::format("{}: take {}", arguments.library, printable_line(take.name));
  if (arguments.frame < 0 || arguments.frame >= take.frames)
    return {fmt::format("frame {} does not exist; its frames are 0 to {}", arguments.frame, take.frames - 1),
            where};
  if (arguments.frame % take.frame_stride != 0)
    return {fmt::format("frame {} was left out when the library was thinned; ask for a multiple of {}",
                        arguments.frame, take.frame_stride),
            where};
  return {fmt::format("frame {} is only there with the other performer as the active one; {} --swapped",
                      arguments.frame, arguments.swapped ? "leave out" : "add"),
          where};
}

void run_pair(CommandLine& line, const PairArguments& arguments) {
  const auto library = read_library(arguments.library);
  if (!library) return fail(line, library.error());
  const int pair = library->find_pair(arguments.take, arguments.frame, arguments.swapped);
  if (pair < 0) return fail(line, no_such_pair(*library, arguments));
  const std::string text = arguments.json ? pair_json(*library, pair) : pair_text(*library, pair);
  if (const auto damage = library->damage()) return fail(line, *damage);  // it would be another pair
  if (arguments.json)
    answer_json(line, text);
  else
    answer(line, text);
}

}  // namespace

void add_library_pair(CLI::App& library, CommandLine& line) {
  auto arguments = std::make_shared<PairArguments>();
  CLI::App* command =
      library.add_subcommand("pair", "show one normalised pair with its features and interaction mesh");
  command->add_option("LIB", arguments->library, "library file")->required()->type_name("");
  command->add_option("TAKE", arguments->take, "name of the take")->required()->type_name("");
  command->add_option("FRAME", arguments->frame, "frame of the take, from 0")->required()->type_name("");
  command->add_flag("--swapped", arguments->swapped, "with performer b as the active one");
  command->add_flag("--json", arguments->json, "one JSON object on stdout");
  command->callback([&line, arguments] { run_pair(line, *arguments); });
}

}  // namespace abrazo::app

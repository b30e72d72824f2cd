#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/library_command.hpp"
#include "app/cli/text_lines.hpp"
#include "core/base/json_text.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/takes/performer_letter.hpp"

namespace abrazo::app {

namespace {

struct LibraryInfoArguments {
  std::string library;
  bool json = false;
};

/// What is counted over the pairs.
struct PairCounts {
  std::vector<int> per_take;
  std::map<std::string, int, std::less<>> per_label;
  std::map<std::string, int, std::less<>> per_role;
  std::array<int, 3> per_quality{};
};

PairCounts count_pairs(const MotionLibrary& library) {
  PairCounts counts;
  counts.per_take.resize(library.takes().size());
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    ++counts.per_take[library.source(pair).take];
    ++counts.per_role[std::string(letter_of(library.source(pair).annotated))];
    ++counts.per_quality.at(library.columns().mesh_quality[static_cast<std::size_t>(pair)]);
    if (const auto label = library.label(pair); !label.empty()) ++counts.per_label[std::string(label)];
  }
  return counts;
}

int frame_count(const MotionLibrary& library) {
  int frames = 0;
  for (const LibraryTake& take : library.takes()) frames += take.frames;
  return frames;
}

void append_take(JsonText& json, const LibraryTake& take, int pairs) {
  json.begin_object().key("name").value(take.name).key("fps").value(take.fps).key("frames").value(
      take.frames);
  json.key("frame_stride").value(take.frame_stride).key("pairs").value(pairs);
  json.key("body_a").value(static_cast<int>(take.body_a)).key("body_b").value(static_cast<int>(take.body_b));
  json.key("roles");
  write_role_list(json, take.roles);
  json.key("labels").begin_array();
  for (const LabelInterval& label : take.labels) {
    json.begin_object()
        .key("start")
        .value(label.start)
        .key("end")
        .value(label.end)
        .key("label")
        .value(label.label);
    json.key("detail").value(label.detail).key("confidence").value(label.confidence).end_object();
  }
  json.end_array().end_object();
}

void append_bones(JsonText& json, const std::array<double, bone_count>& values) {
  json.begin_object();
  for (std::size_t b = 0; b < values.size(); ++b) json.key(joint_names[b + 1]).value(values[b]);
  json.end_object();
}

void append_counts(JsonText& json, const std::map<std::string, int, std::less<>>& counts) {
  json.begin_object();
  for (const auto& [name, count] : counts) json.key(name).value(count);
  json.end_object();
}

std::string info_json(const MotionLibrary& library, std::uintmax_t bytes) {
  const PairCounts counts = count_pairs(library);
  JsonText json;
  json.begin_object().key("name").value(library.name()).key("rate_hz").value(library.rate_hz());
  json.key("pairs")
      .value(library.pair_count())
      .key("frames")
      .value(frame_count(library))
      .key("bytes")
      .value(static_cast<long long>(bytes))
      .key("mapped_bytes")
      .value(static_cast<long long>(mapped_bytes(library)));
  json.key("joints").begin_array();
  for (const std::string_view joint : joint_names) json.value(joint);
  json.end_array().key("takes").begin_array();
  for (std::size_t t = 0; t < library.takes().size(); ++t)
    append_take(json, library.takes()[t], counts.per_take[t]);
  json.end_array().key("bodies").begin_array();
  for (const LibraryBody& body : library.bodies()) {
    json.begin_object().key("name").value(body.name).key("height_m").value(body.body.height());
    append_bones(json.key("bone_lengths"), body.body.bone_lengths);
    append_bones(json.key("capsule_radii"), body.capsule_radii);
    json.end_object();
  }
  json.end_array();
  append_counts(json.key("roles"), counts.per_role);
  append_counts(json.key("labels"), counts.per_label);
  json.key("meshes")
      .begin_object()
      .key("exact")
      .value(counts.per_quality[0])
      .key("jittered")
      .value(counts.per_quality[1]);
  json.key("nearest_neighbours").value(counts.per_quality[2]).end_object();
  return json.end_object().take();
}

void add_takes(TextLines& text, const MotionLibrary& library, const PairCounts& counts) {
  std::size_t width = 4;
  for (const LibraryTake& take : library.takes()) width = std::max(width, take.name.size());
  text.add("");
  text.add("{:{}}  {:>8}  {:>7}  {:>7}  {:>7}  {:>6}  bodies", "take", width, "fps", "frames", "stride",
           "pairs", "labels");
  for (std::size_t t = 0; t < library.takes().size(); ++t) {
    const LibraryTake& take = library.takes()[t];
    text.add("{:{}}  {:8.4g}  {:7}  {:7}  {:7}  {:6}  {} {}", take.name, width, take.fps, take.frames,
             take.frame_stride, counts.per_take[t], take.labels.size(), take.body_a, take.body_b);
  }
}

void add_bodies(TextLines& text, const MotionLibrary& library) {
  std::string names = "body", heights = fmt::format("{:10}", "height m");
  for (std::size_t b = 0; b < library.bodies().size(); ++b) {
    names += fmt::format("  {:>18}", fmt::format("{} {}", b, library.bodies()[b].name));
    heights += fmt::format("  {:>18.3f}", library.bodies()[b].body.height());
  }
  text.add("");
  text.add("{}", names);
  text.add("{}", heights);
  text.add("bone length and capsule radius, m");
  for (std::size_t bone = 0; bone < bone_count; ++bone) {
    std::string row = fmt::format("{:10}", joint_names[bone + 1]);
    for (const LibraryBody& body : library.bodies())
      row += fmt::format("  {:10.4f}  {:6.4f}", body.body.bone_lengths[bone], body.capsule_radii[bone]);
    text.add("{}", row);
  }
}

std::string info_text(const MotionLibrary& library, std::uintmax_t bytes) {
  const PairCounts counts = count_pairs(library);
  TextLines text;
  text.add("{}: {} takes, {} frames, {} pairs at {:.4g} Hz, {} joints, {} bytes", library.name(),
           library.takes().size(), frame_count(library), library.pair_count(), library.rate_hz(), joint_count,
           bytes);
  if (const std::uint64_t mapped = mapped_bytes(library); mapped > 0)
    text.add("mapped: {} bytes stay in the file and are read as they are used", mapped);
  else
    text.add("mapped: nothing, everything is loaded into memory");
  text.add("meshes: {} exact, {} jittered, {} from nearest neighbours", counts.per_quality[0],
           counts.per_quality[1], counts.per_quality[2]);
  for (const auto& [role, count] : counts.per_role) text.add("active {}: {} pairs", role, count);
  for (const auto& [label, count] : counts.per_label) text.add("label {}: {} pairs", label, count);
  add_takes(text, library, counts);
  add_bodies(text, library);
  return text.take();
}

void run_info(CommandLine& line, const LibraryInfoArguments& arguments) {
  const auto library = read_library(arguments.library);
  if (!library) return fail(line, library.error());
  const std::uintmax_t bytes = std::filesystem::file_size(arguments.library);
  if (arguments.json)
    answer_json(line, info_json(*library, bytes));
  else
    answer(line, info_text(*library, bytes));
}

}  // namespace

void add_library_info(CLI::App& library, CommandLine& line) {
  auto arguments = std::make_shared<LibraryInfoArguments>();
  CLI::App* command = library.add_subcommand("info", "show the contents of a motion library");
  command->add_option("LIB", arguments->library, "library file")->required()->type_name("");
  command->add_flag("--json", arguments->json, "one JSON object on stdout");
  command->callback([&line, arguments] { run_info(line, *arguments); });
}

}  // namespace abrazo::app

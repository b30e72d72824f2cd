#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>

#include "app/cli/command_line.hpp"
#include "core/base/json_text.hpp"
#include "core/base/output_file.hpp"
#include "core/library/manifest.hpp"
#include "core/library/motion_library_builder.hpp"
#include "core/library/motion_library_file.hpp"
#include "core/library/performer_letter.hpp"

namespace abrazo::app {

namespace {

struct BuildArguments {
  std::string manifest, output;
  LibraryBuildOptions options;
};

struct InfoArguments {
  std::string library;
  bool json = false;
};

struct PairArguments {
  std::string library, take;
  int frame = 0;
  bool swapped = false;
  bool json = false;
};

long long bytes_of(const std::string& file) {
  return static_cast<long long>(std::filesystem::file_size(file));
}

Result<MotionLibrary> build(const BuildArguments& arguments, const Progress& progress,
                            std::vector<std::string>& warnings) {
  const auto manifest = read_manifest(arguments.manifest);
  if (!manifest) return manifest.error();
  return build_library(*manifest, arguments.options, progress, warnings);
}

void run_build(CommandLine& line, const BuildArguments& arguments) {
  if (const Status usable = check_output(arguments.output, {arguments.manifest}); !usable)
    return fail(line, usable.error());
  const auto begin = std::chrono::steady_clock::now();
  const Progress progress = terminal_progress(line);
  std::vector<std::string> warnings;
  const auto library = build(arguments, progress, warnings);
  for (const std::string& warning : warnings) warn(line, warning);
  if (!library) return fail(line, library.error());
  if (const Status written = write_library(*library, arguments.output, progress); !written)
    return fail(line, written.error());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (line.quiet) return;
  answer(line, fmt::format("{}: {} takes, {} pairs, {:.1f} s, {} bytes\n", arguments.output,
                           library->takes().size(), library->pair_count(), seconds.count(),
                           bytes_of(arguments.output)));
}

// ---- info ----

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
  json.key("roles").begin_array();
  for (const RoleInterval& role : take.roles)
    json.begin_object()
        .key("start")
        .value(role.start)
        .key("end")
        .value(role.end)
        .key("active")
        .value(letter_of(role.active))
        .end_object();
  json.end_array().key("labels").begin_array();
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

std::string info_json(const MotionLibrary& library, long long bytes) {
  const PairCounts counts = count_pairs(library);
  JsonText json;
  json.begin_object().key("name").value(library.name()).key("rate_hz").value(library.rate_hz());
  json.key("pairs")
      .value(library.pair_count())
      .key("frames")
      .value(frame_count(library))
      .key("bytes")
      .value(bytes)
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

void print_takes(const MotionLibrary& library, const PairCounts& counts) {
  std::size_t width = 4;
  for (const LibraryTake& take : library.takes()) width = std::max(width, take.name.size());
  fmt::print("\n{:{}}  {:>8}  {:>7}  {:>7}  {:>7}  {:>6}  bodies\n", "take", width, "fps", "frames", "stride",
             "pairs", "labels");
  for (std::size_t t = 0; t < library.takes().size(); ++t) {
    const LibraryTake& take = library.takes()[t];
    fmt::print("{:{}}  {:8.4g}  {:7}  {:7}  {:7}  {:6}  {} {}\n", take.name, width, take.fps, take.frames,
               take.frame_stride, counts.per_take[t], take.labels.size(), take.body_a, take.body_b);
  }
}

void print_bodies(const MotionLibrary& library) {
  fmt::print("\nbody");
  for (std::size_t b = 0; b < library.bodies().size(); ++b)
    fmt::print("  {:>18}", fmt::format("{} {}", b, library.bodies()[b].name));
  fmt::print("\n{:10}", "height m");
  for (const LibraryBody& body : library.bodies()) fmt::print("  {:>18.3f}", body.body.height());
  fmt::print("\nbone length and capsule radius, m\n");
  for (std::size_t bone = 0; bone < bone_count; ++bone) {
    fmt::print("{:10}", joint_names[bone + 1]);
    for (const LibraryBody& body : library.bodies())
      fmt::print("  {:10.4f}  {:6.4f}", body.body.bone_lengths[bone], body.capsule_radii[bone]);
    fmt::print("\n");
  }
}

void print_info(const MotionLibrary& library, long long bytes) {
  const PairCounts counts = count_pairs(library);
  fmt::print("{}: {} takes, {} frames, {} pairs at {:.4g} Hz, {} joints, {} bytes\n", library.name(),
             library.takes().size(), frame_count(library), library.pair_count(), library.rate_hz(),
             joint_count, bytes);
  if (const std::uint64_t mapped = mapped_bytes(library); mapped > 0)
    fmt::print("mapped: {} bytes stay in the file and are read as they are used\n", mapped);
  else
    fmt::print("mapped: nothing, all of it is read into memory\n");
  fmt::print("meshes: {} exact, {} jittered, {} from nearest neighbours\n", counts.per_quality[0],
             counts.per_quality[1], counts.per_quality[2]);
  for (const auto& [role, count] : counts.per_role) fmt::print("active {}: {} pairs\n", role, count);
  for (const auto& [label, count] : counts.per_label) fmt::print("label {}: {} pairs\n", label, count);
  print_takes(library, counts);
  print_bodies(library);
}

void run_info(CommandLine& line, const InfoArguments& arguments) {
  const auto library = read_library(arguments.library);
  if (!library) return fail(line, library.error());
  const long long bytes = bytes_of(arguments.library);
  if (arguments.json)
    fmt::print("{}\n", info_json(*library, bytes));
  else
    print_info(*library, bytes);
}

// ---- pair ----

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

void print_pair(const MotionLibrary& library, int pair) {
  const auto label = library.label(pair);
  fmt::print("{} frame {}{}, role {}, label {}, {} edges, {} tetrahedra\n", library.take_of(pair).name,
             library.source(pair).frame, library.source(pair).swapped ? " swapped" : "",
             letter_of(library.source(pair).annotated), label.empty() ? "none" : label,
             library.edges(pair).size(), library.tetrahedra(pair).size());
  fmt::print("{:10}  {:>8} {:>8} {:>8}   {:>8} {:>8} {:>8}\n", "normalised", "active x", "y", "z",
             "passive x", "y", "z");
  const PairPose& pose = library.pose(pair);
  for (int joint = 0; joint < joint_count; ++joint) {
    fmt::print("{:10}  {:8.4f} {:8.4f} {:8.4f}    {:8.4f} {:8.4f} {:8.4f}\n",
               joint_names[static_cast<std::size_t>(joint)], pose(joint, 0), pose(joint, 1), pose(joint, 2),
               pose(joint_count + joint, 0), pose(joint_count + joint, 1), pose(joint_count + joint, 2));
  }
}

/// Why a frame has no pair, and which one to ask for instead.
Error no_such_pair(const MotionLibrary& library, const PairArguments& arguments) {
  const int index = library.find_take(arguments.take);
  if (index < 0) {
    std::string names;
    for (const LibraryTake& take : library.takes()) names += (names.empty() ? "" : ", ") + take.name;
    return {fmt::format("there is no take \"{}\"; there are {}", arguments.take, names), arguments.library};
  }
  const LibraryTake& take = library.takes()[static_cast<std::size_t>(index)];
  const std::string where = fmt::format("{}: take {}", arguments.library, take.name);
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
  if (arguments.json)
    fmt::print("{}\n", pair_json(*library, pair));
  else
    print_pair(*library, pair);
}

// ---- options ----

void add_build(CLI::App& library, CommandLine& line) {
  auto arguments = std::make_shared<BuildArguments>();
  CLI::App* command =
      library.add_subcommand("build", "read the takes of a manifest and write a motion library");
  command->add_option("MANIFEST", arguments->manifest, "JSON list of paired takes")
      ->required()
      ->type_name("");
  command->add_option("-o,--output", arguments->output, "library to write (HDF5)")
      ->required()
      ->type_name("LIB");
  command->add_option("--exclude", arguments->options.excluded_takes, "leave out this take; may be repeated")
      ->expected(1)
      ->allow_extra_args(false)  // otherwise it also takes the words that follow
      ->take_all()
      ->type_name("TAKE");
  command->add_flag("--both-roles", arguments->options.both_roles,
                    "either performer may be the active one in every frame, whatever the roles say (doubles "
                    "the library; for fights, whose users attack and defend in turn)");
  command->add_option("--rate", arguments->options.rate_hz, "thin to about this rate, by whole strides")
      ->check(above_zero)
      ->type_name("HZ");
  command->callback([&line, arguments] { run_build(line, *arguments); });
}

void add_info(CLI::App& library, CommandLine& line) {
  auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command = library.add_subcommand("info", "say what a motion library holds");
  command->add_option("LIB", arguments->library, "library file")->required()->type_name("");
  command->add_flag("--json", arguments->json, "one JSON object on stdout");
  command->callback([&line, arguments] { run_info(line, *arguments); });
}

void add_pair(CLI::App& library, CommandLine& line) {
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

}  // namespace

void add_library_command(CommandLine& line) {
  CLI::App* library = line.app.add_subcommand("library", "build and inspect motion libraries");
  library->require_subcommand(1);
  add_build(*library, line);
  add_info(*library, line);
  add_pair(*library, line);
}

}  // namespace abrazo::app

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/library_command.hpp"
#include "core/base/output_file.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo::app {

namespace {

struct BuildArguments {
  std::string manifest, output;
  LibraryBuildOptions options;
};

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
  if (!has_one_rate(*library)) note(line, "--rate HZ brings the pairs of all takes to one rate");
  if (const Status written = write_library(*library, arguments.output, progress); !written)
    return fail(line, written.error());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (line.quiet) return;
  answer(line, fmt::format("{}: {} takes, {} pairs, {:.1f} s, {} bytes\n", arguments.output,
                           library->takes().size(), library->pair_count(), seconds.count(),
                           std::filesystem::file_size(arguments.output)));
}

}  // namespace

void add_library_build(CLI::App& library, CommandLine& line) {
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
  command
      ->add_option("--rate", arguments->options.rate_hz, "subsample to about this rate, by integer strides")
      ->check(above_zero)
      ->type_name("HZ");
  command->callback([&line, arguments] { run_build(line, *arguments); });
}

}  // namespace abrazo::app

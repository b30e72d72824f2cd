#include "app/cli/evaluation_data.hpp"

namespace abrazo::app {

void add_evaluation_source(CLI::App& command, EvaluationSource& source) {
  command.add_option("--manifest", source.manifest, "paired takes with roles and labels (JSON)")
      ->required()
      ->type_name("MANIFEST");
  command
      .add_option(
          "--users", source.users,
          "takes of other people (a manifest): they are answered by the takes of --manifest, of which "
          "none is left out")
      ->type_name("MANIFEST");
  command.add_flag(
      "--both-roles", source.both_roles,
      "either performer may be the active one in every frame, whatever the roles say: for fights, "
      "whose users attack and defend in turn");
  command
      .add_option("--hold-out", source.hold_out,
                  "takes to evaluate, each with all the others, separated by commas; by default all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("TAKE,...");
}

Result<EvaluationData> read_takes(CommandLine& line, const EvaluationManifests& manifests, bool both_roles,
                                  const Progress& progress) {
  auto data = read_evaluation_data(manifests, both_roles, progress);
  if (data)
    for (const std::string& warning : data->warnings) warn(line, warning);
  return data;
}

}  // namespace abrazo::app

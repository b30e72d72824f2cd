#include "app/cli/evaluation_data.hpp"

#include <filesystem>
#include <system_error>

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
}

Result<EvaluationData> read_evaluation_data(const EvaluationSource& source, const Progress& progress) {
  const auto manifest = read_manifest(source.manifest);
  if (!manifest) return manifest.error();
  if (source.users.empty())
    return abrazo::read_evaluation_data(*manifest, nullptr, source.both_roles, progress);
  const auto users = read_manifest(source.users);
  if (!users) return users.error();
  return abrazo::read_evaluation_data(*manifest, &*users, source.both_roles, progress);
}

Status make_folder(const std::string& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure || !std::filesystem::is_directory(folder, failure))
    return Error{"the folder cannot be made (" + (failure ? failure.message() : "a file has its name") +
                     "); choose another",
                 folder};
  return Done{};
}

}  // namespace abrazo::app

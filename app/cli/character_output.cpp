#include "app/cli/character_output.hpp"

#include "core/base/atomic_file.hpp"
#include "core/base/output_file.hpp"
#include "core/motion/scenes/character_glb.hpp"

namespace abrazo::app {

void CharacterOutput::add_to(CLI::App& command, CLI::Option* output) {
  command
      .add_option(
          "--character", file_,
          "a humanoid of another program (.glb, or .vrm 0.x and 1.0): it performs the motion with its "
          "own bones, in OUT_active and OUT_passive")
      ->needs(output)
      ->type_name("FILE");
}

Status CharacterOutput::check(const std::string& output) const {
  if (output.ends_with(".glb") || output.ends_with(".vrm")) return Done{};
  return Error{"a character with its motion is written as .glb or .vrm", output};
}

std::array<std::string, 2> CharacterOutput::outputs(const std::string& output) const {
  return {with_suffix(output, "_active"), with_suffix(output, "_passive")};
}

Result<std::vector<std::pair<std::string, std::string>>> CharacterOutput::contents(
    const std::string& output, const Clip& active, const Clip& passive) const {
  const auto character = read_whole_file(file_);
  if (!character) return character.error();
  std::vector<std::pair<std::string, std::string>> all;
  for (const Clip* clip : {&active, &passive}) {
    auto content = write_character_glb(*character, *clip, file_);
    if (!content) return content.error();
    all.emplace_back(outputs(output)[all.size()], std::move(*content));
  }
  return all;
}

}  // namespace abrazo::app

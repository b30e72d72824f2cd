#include "app/cli/character_option.hpp"

namespace abrazo::app {

void add_character_option(CLI::App& command, std::string& character, CLI::Option* output,
                          const std::string& files) {
  command
      .add_option(
          "--character", character,
          "a humanoid of another program (.glb, or .vrm 0.x and 1.0): it performs the motion with its "
          "own bones, in " +
              files)
      ->needs(output)
      ->type_name("FILE");
}

}  // namespace abrazo::app

#include "app/cli/motion_reading.hpp"

#include <cmath>

#include "app/cli/interruption.hpp"
#include "core/base/text.hpp"

namespace abrazo::app {

void add_reading_options(CLI::App& command, MotionReading& reading) {
  command.add_option("--skeleton", reading.skeleton, "the .asf of an .amc")->type_name("ASF");
  command
      .add_option("--metres-per-unit", reading.metres_per_unit,
                  "length of the file's unit; by default from the file or guessed")
      ->check(above_zero)
      ->type_name("METRES");
  command.add_option("--fps", reading.fps, "frame rate, overrides the file")
      ->check(above_zero)
      ->type_name("HZ");
  command
      .add_option("--joint-map", reading.joint_map,
                  "which point is which joint: a built-in map or marker model, or a JSON file")
      ->type_name("NAME|JSON");
  command
      .add_option("--joints", reading.joints,
                  "order of the joints of a .npy or .npz without names: " + joint_order_names() +
                      ", or a file with a name a line")
      ->type_name("NAME|FILE");
  command.add_option("--up", reading.up, "the file's axis that points up: " + up_axis_names())
      ->check([](const std::string& word) {
        return find_up_axis(word) ? std::string() : "expected " + up_axis_names() + ", found '" + word + "'";
      })
      ->type_name("AXIS");
  command
      .add_option("--floor", reading.floor_m,
                  "height of the floor above the file's zero; by default it is moved only if it is far off")
      ->check(CLI::Number)
      ->type_name("METRES");
  command.add_option("--performer", reading.performer, "which performer of a file with several")
      ->check([](const std::string& word) {
        const auto number = parse_number(word);
        const bool usable = !number || (*number >= 1 && *number == std::floor(*number));
        return usable ? std::string() : "expected a number from 1, or a name, found '" + word + "'";
      })
      ->type_name("N|NAME");
  command
      .add_option("--animation", reading.animation,
                  "which animation of a file with several; by default the longest")
      ->type_name("NAME");
  command
      .add_option("--body-model", reading.body_model,
                  "of a .npz with SMPL or SMPL-X parameters: the .npz of the body model")
      ->type_name("NPZ");
}

bool until_interrupted(double /*fraction*/, std::string_view /*doing*/) {
  return !interrupted();
}

Result<ImportedClip> read_performer(CommandLine& line, const MotionReading& reading) {
  Result<ImportedClip> imported = read_performer(reading, until_interrupted);
  if (imported) warn_of_import(line, reading, *imported);
  return imported;
}

void warn_of_import(CommandLine& line, const MotionReading& reading, const ImportedClip& imported) {
  for (const Warning& warning : warnings_of_import(reading, imported)) warn(line, warning);
}

void add_space_options(CLI::App& command, WrittenSpace& words) {
  command
      .add_option("--out-units", words.units,
                  "unit of the written .bvh, .csv, .npz or .npy; by default metres")
      ->check(CLI::IsMember({"m", "cm", "mm"}))
      ->type_name("UNIT");
  command
      .add_option("--out-up", words.up,
                  "axis that points up in the written .bvh, .csv, .npz or .npy; by default y")
      ->check(CLI::IsMember({"y", "z"}))
      ->type_name("AXIS");
  command
      .add_option("--out-joints", words.joints,
                  "joints of the written .npz or .npy and their order; by default abrazo25, the 25")
      ->type_name("NAME|FILE");
}

Result<ClipFileSpace> file_space(const WrittenSpace& words) {
  ClipFileSpace space{words.units == "cm"   ? 100.0
                      : words.units == "mm" ? 1000.0
                                            : 1.0,
                      words.up == "z" ? UpAxis::Z : UpAxis::Y};
  if (words.joints.empty()) return space;
  auto order = find_joint_order(words.joints);
  if (!order) return order.error();
  space.joints = std::move(*order);
  return space;
}

}  // namespace abrazo::app

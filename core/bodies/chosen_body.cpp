#include "core/bodies/chosen_body.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/motion/files/motion_reading.hpp"

namespace abrazo {

namespace {

constexpr double least_height_m = 0.4, greatest_height_m = 4;

Result<ChosenBody> body_of_file(const std::string& file, const Progress& progress) {
  auto performers = read_performers({.file = file}, progress);
  if (!performers) return performers.error();
  if (performers->size() != 1)
    return Error{
        fmt::format("holds {} performers; a body is measured in a file with one", performers->size()), file};
  const ImportedClip& imported = performers->front();
  ChosenBody chosen{body_of(imported.clip.poses), std::filesystem::path(file).filename().string()};
  const double height_m = chosen.body.height();
  if (!(height_m > least_height_m && height_m < greatest_height_m) || chosen.body.leg_length() < 0.1)
    return Error{
        fmt::format("its performer is {:.3g} m tall; a body between {} and {} m is expected: convert "
                    "the file to metres first",
                    height_m, least_height_m, greatest_height_m),
        file};
  return chosen;
}

}  // namespace

Status measure_file(BodyChoice& choice, const Progress& progress) {
  if (choice.kind != BodyChoice::Kind::OfFile || choice.measured) return Done{};
  auto chosen = body_of_file(choice.file, progress);
  if (!chosen) return chosen.error();
  choice.measured = chosen->body;
  return Done{};
}

Result<ChosenBody> choose_body(const BodyChoice& choice, const Body& recorded, const Progress& progress) {
  switch (choice.kind) {
    case BodyChoice::Kind::Library:
      return ChosenBody{recorded, body_choice_text(choice)};
    case BodyChoice::Kind::Scaled:
      return ChosenBody{scaled_body(recorded, choice.scale), body_choice_text(choice)};
    case BodyChoice::Kind::OfFile:
      return body_of_file(choice.file, progress);
    case BodyChoice::Kind::User:
      break;
  }
  return Error{
      "a recorded pair has no user whose body it could get; say library, scale:NUMBER or a motion file",
      body_choice_text(choice)};
}

}  // namespace abrazo

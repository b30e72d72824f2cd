#include "core/motion/body/body_choice.hpp"

#include <fmt/format.h>

#include "core/base/text.hpp"

namespace abrazo {

namespace {
constexpr std::string_view scale_prefix = "scale:";
}  // namespace

bool BodyChoice::operator==(const BodyChoice& other) const {
  if (measured.has_value() != other.measured.has_value()) return false;
  return kind == other.kind && scale == other.scale && file == other.file &&
         (!measured || are_same_lengths(*measured, *other.measured));
}

Body body_of_choice(const BodyChoice& choice, const Body& recorded, const std::optional<Body>& user) {
  switch (choice.kind) {
    case BodyChoice::Kind::Library:
      return recorded;
    case BodyChoice::Kind::User:
      return user.value_or(recorded);
    case BodyChoice::Kind::Scaled:
      return scaled_body(recorded, choice.scale);
    case BodyChoice::Kind::OfFile:
      break;
  }
  return choice.measured.value_or(recorded);
}

bool are_same_lengths(const Body& a, const Body& b) {
  return a.bone_lengths == b.bone_lengths && a.pseudo_lengths == b.pseudo_lengths &&
         a.toe_rest_height == b.toe_rest_height;
}

Result<BodyChoice> parse_body_choice(std::string_view text) {
  const std::string_view word = trimmed(text);
  if (word.empty())
    return Error{"a body is library, user, scale:NUMBER, or a motion file whose proportions it has", ""};
  BodyChoice choice;
  if (word == "library") return choice;
  if (word == "user") {
    choice.kind = BodyChoice::Kind::User;
    return choice;
  }
  if (!word.starts_with(scale_prefix)) {
    choice.kind = BodyChoice::Kind::OfFile;
    choice.file = word;
    return choice;
  }
  const std::string_view number = word.substr(scale_prefix.size());
  const auto scale = parse_number(number);
  // Written so that NaN is refused as well.
  if (!scale || !(*scale >= BodyChoice::least_scale && *scale <= BodyChoice::greatest_scale))
    return Error{fmt::format("{} is no size of a body: a number from {} to {} is expected, as in scale:0.85",
                             in_quotes(number), BodyChoice::least_scale, BodyChoice::greatest_scale),
                 ""};
  choice.kind = BodyChoice::Kind::Scaled;
  choice.scale = *scale;
  return choice;
}

std::string body_choice_text(const BodyChoice& choice) {
  switch (choice.kind) {
    case BodyChoice::Kind::Library:
      return "library";
    case BodyChoice::Kind::User:
      return "user";
    case BodyChoice::Kind::Scaled:
      return std::string(scale_prefix) + exact_text(choice.scale);
    case BodyChoice::Kind::OfFile:
      break;
  }
  return choice.file == "library" || choice.file == "user" || choice.file.starts_with(scale_prefix)
             ? "./" + choice.file
             : choice.file;
}

Body scaled_body(const Body& body, double scale) {
  Body scaled = body;
  for (double& length : scaled.bone_lengths) length *= scale;
  for (double& length : scaled.pseudo_lengths) length *= scale;
  scaled.toe_rest_height *= scale;
  return scaled;
}

}  // namespace abrazo

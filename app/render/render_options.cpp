#include "app/render/render_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "core/base/text.hpp"

namespace abrazo::app {
namespace {

constexpr int smallest_px = 64, largest_px = 8192;
constexpr double slowest_hz = 0.1, fastest_hz = 240;

/// Position of the number in the name of a series.
struct NumberPlace {
  std::size_t at = std::string::npos, length = 0;
  int digits = 0;
};

/// @return nothing where the name has something else behind a '%', or more than one number
std::optional<NumberPlace> number_place(const std::string& name) {
  NumberPlace place;
  for (std::size_t i = name.find('%'); i != std::string::npos; i = name.find('%', i + 1)) {
    if (place.at != std::string::npos) return {};
    std::size_t end = i + 1;
    if (end < name.size() && name[end] == '0') ++end;
    int digits = 0;
    if (end < name.size() && name[end] >= '1' && name[end] <= '9') digits = name[end++] - '0';
    if (end >= name.size() || name[end] != 'd') return {};
    place = {i, end + 1 - i, digits};
  }
  return place;
}

std::string wrong_size(const std::string& text) {
  return picture_size(text)
             ? std::string()
             : fmt::format("write a size as 1280x720, {} to {} pixels", smallest_px, largest_px);
}

std::string wrong_camera(const std::string& text) {
  std::optional<ViewDirection> direction;
  return view_direction(text, direction)
             ? std::string()
             : "expected follow, front, right, top, iso, or AZIMUTH,ELEVATION in degrees such as 30,15";
}

std::string wrong_rate(const std::string& text) {
  const auto rate = parse_number(text);
  return rate && *rate >= slowest_hz && *rate <= fastest_hz
             ? std::string()
             : fmt::format("expected a rate of {} to {} Hz, found '{}'", slowest_hz, fastest_hz, text);
}

}  // namespace

std::optional<PictureSize> picture_size(const std::string& text) {
  const auto parts = split_fields(text, 'x');
  const auto width = parts.size() == 2 ? parse_integer(parts[0]) : std::nullopt;
  const auto height = parts.size() == 2 ? parse_integer(parts[1]) : std::nullopt;
  const auto fits = [](long long px) { return px >= smallest_px && px <= largest_px; };
  if (!width || !height || !fits(*width) || !fits(*height)) return {};
  return PictureSize{static_cast<int>(*width), static_cast<int>(*height)};
}

bool view_direction(const std::string& text, std::optional<ViewDirection>& direction) {
  constexpr double straight_down_deg = 89;   // the picture keeps an upper end
  constexpr double iso_deg = 35.2643896828;  // the diagonal of a cube above its floor
  direction.reset();
  if (text == "follow") return true;
  if (text == "front") direction = {0, 0};
  if (text == "right") direction = {90, 0};
  if (text == "top") direction = {0, straight_down_deg};
  if (text == "iso") direction = {45, iso_deg};
  if (direction) return true;
  const auto parts = split_fields(text, ',');
  const auto azimuth = parts.size() == 2 ? parse_number(parts[0]) : std::nullopt;
  const auto elevation = parts.size() == 2 ? parse_number(parts[1]) : std::nullopt;
  // Written so that "nan" is none.
  const bool is_direction =
      azimuth && elevation && std::abs(*azimuth) <= 360 && std::abs(*elevation) <= straight_down_deg;
  if (is_direction) direction = {*azimuth, *elevation};
  return is_direction;
}

Result<RenderKind> render_kind(const std::string& output) {
  const std::filesystem::path path(output);
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".mp4") return RenderKind::Film;
  if (extension != ".png")
    return Error{
        "a rendering is a film (.mp4), a picture (.png) or a series of pictures (such as frame_%05d.png)",
        output};
  const auto place = number_place(path.filename().string());
  if (!place) return Error{"has a '%' that is not a number; the name of a series has one %d or %05d", output};
  return place->at == std::string::npos ? RenderKind::Picture : RenderKind::Series;
}

std::string series_name(const std::string& output, int number) {
  const std::filesystem::path path(output);
  std::string name = path.filename().string();
  const auto place = number_place(name);
  if (place && place->at != std::string::npos)
    name.replace(place->at, place->length, fmt::format("{:0{}}", number, place->digits));
  return (path.parent_path() / name).string();
}

void add_render_options(CLI::App& command, RenderOptions& options) {
  const auto on_off = CLI::IsMember({"on", "off"});
  command.add_option("input", options.input, "session (.abrazo) or trace (.jsonl)")
      ->required()
      ->type_name("S.abrazo|T.jsonl");
  command
      .add_option("-o,--output", options.output,
                  ".mp4: a film; .png: the picture at --from, or a series where the name has %d or %05d")
      ->required()
      ->type_name("OUT");
  command.add_option("--from", options.from_s, "from this time on [s]")->type_name("T");
  command.add_option("--to", options.to_s, "up to this time [s]")->type_name("T");
  command.add_option("--size", options.size, "pixels of a picture")
      ->check(CLI::Validator(wrong_size, ""))
      ->type_name("WxH")
      ->capture_default_str();
  command.add_option("--rate", options.rate_hz, "frames per second")
      ->check(CLI::Validator(wrong_rate, ""))
      ->type_name("HZ")
      ->capture_default_str();
  command
      .add_option(
          "--camera", options.camera,
          "follow (beside the pair), front, right, top, iso, or AZIMUTH,ELEVATION in degrees; all keep "
          "the pair in the picture")
      ->check(CLI::Validator(wrong_camera, ""))
      ->type_name("VIEW")
      ->capture_default_str();
  command.add_option("--theme", options.theme, "colours: dark or light")
      ->check(CLI::IsMember({"dark", "light"}))
      ->type_name("THEME")
      ->capture_default_str();
  const auto add_switch = [&](const char* name, std::string& value, const char* what) {
    command.add_option(name, value, what)->check(on_off)->type_name("on|off")->capture_default_str();
  };
  add_switch("--mesh", options.mesh, "the interaction mesh");
  add_switch("--user", options.user, "the user's skeleton");
  add_switch("--ahead", options.ahead,
             "session: the next positions of the partner if the recording continues");
  add_switch("--captions", options.captions, "frame, time and source written into the picture");
  const auto add_character = [&](const char* name, std::string& file, const char* which) {
    command
        .add_option(
            name, file,
            std::string("a humanoid of another program (.glb, or .vrm 0.x and 1.0) as the skin of the ") +
                which + " body")
        ->type_name("FILE");
  };
  add_character("--active-character", options.active_character, "active");
  add_character("--passive-character", options.passive_character, "passive");
  command.add_option("--library", options.library, "session: the library, if it was moved")->type_name("LIB");
}

std::vector<std::string> words_of(const RenderOptions& options) {
  std::vector<std::string> words = {"--output",
                                    options.output,
                                    "--size",
                                    options.size,
                                    "--rate",
                                    exact_text(options.rate_hz),
                                    "--camera=" + options.camera,
                                    "--theme",
                                    options.theme,
                                    "--mesh",
                                    options.mesh,
                                    "--user",
                                    options.user,
                                    "--ahead",
                                    options.ahead,
                                    "--captions",
                                    options.captions};
  if (options.from_s) words.push_back("--from=" + exact_text(*options.from_s));
  if (options.to_s) words.push_back("--to=" + exact_text(*options.to_s));
  if (!options.library.empty()) words.insert(words.end(), {"--library", options.library});
  if (!options.active_character.empty())
    words.insert(words.end(), {"--active-character", options.active_character});
  if (!options.passive_character.empty())
    words.insert(words.end(), {"--passive-character", options.passive_character});
  words.insert(words.end(), {"--", options.input});
  return words;
}

std::vector<std::string> inputs_of(const RenderOptions& options) {
  return {options.input, options.library, options.active_character, options.passive_character};
}

Status check_render(const RenderOptions& options) {
  const auto kind = render_kind(options.output);
  if (!kind) return kind.error();
  const PictureSize size = picture_size(options.size).value_or(PictureSize{});
  if (*kind == RenderKind::Film && (size.width % 2 != 0 || size.height % 2 != 0))
    return Error{fmt::format("a film needs an even size; found {}", options.size), options.output};
  if (*kind == RenderKind::Picture && options.to_s)
    return Error{"one picture has no --to; name a series (such as frame_%05d.png) or a film (.mp4)",
                 options.output};
  if (options.from_s && options.to_s && !(*options.to_s >= *options.from_s))
    return Error{fmt::format("--to {} is before --from {}", *options.to_s, *options.from_s), options.output};
  return Done{};
}

}  // namespace abrazo::app

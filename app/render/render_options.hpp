#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo::app {

/// What `abrazo render` is asked for. Knows no toolkit: the command line reads the words, the renderer again.
struct RenderOptions {
  std::string input;   ///< session (.abrazo) or trace (.jsonl)
  std::string output;  ///< .mp4; .png for one picture, or a series where the name has %d
  std::string library;
  std::optional<double> from_s, to_s;  ///< of the session or trace; nothing: all
  std::string size = "1280x720";
  double rate_hz = 30;
  std::string camera = "follow";
  std::string theme = "dark";
  std::string mesh = "on", user = "on", ahead = "off", captions = "off";
};

/// Declares them for a command.
void add_render_options(CLI::App& command, RenderOptions& options);
/// The words that say the same.
std::vector<std::string> words_of(const RenderOptions& options);

struct PictureSize {
  int width = 0, height = 0;
};
/// Of "1280x720".
std::optional<PictureSize> picture_size(const std::string& text);

/// Whence a camera looks.
struct ViewDirection {
  double azimuth_deg = 0;    ///< about the upward axis; 0 is from the front (+Z)
  double elevation_deg = 0;  ///< above the horizon
};
/// Of "front", "right", "top", "iso" or "AZIMUTH,ELEVATION". @return false where it is none of these
bool view_direction(const std::string& text, std::optional<ViewDirection>& direction);

enum class RenderKind { Film, Picture, Series };
/// Of the output's name; the error says which names there are.
Result<RenderKind> render_kind(const std::string& output);
/// The name of one of a series: its "%d" or "%05d" is the number.
std::string series_name(const std::string& output, int number);

/// What the words say that cannot be, without looking at the input.
Status check_render(const RenderOptions& options);

}  // namespace abrazo::app

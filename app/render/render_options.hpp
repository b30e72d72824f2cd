#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo::app {

/// Options of `abrazo render`. Independent of Qt; parsed by the command line and again by the renderer
/// process.
struct RenderOptions {
  std::string input;   ///< session (.abrazo) or trace (.jsonl)
  std::string output;  ///< .mp4; .png for one picture, or a series if the name has %d
  std::string library;
  std::string active_character, passive_character;  ///< files of skins (GLB, VRM); empty = capsules
  std::optional<double> from_s, to_s;               ///< of the session or trace; none = all
  std::string size = "1280x720";
  double rate_hz = 30;
  std::string camera = "follow";
  std::string theme = "dark";
  std::string mesh = "on", user = "on", ahead = "off", captions = "off";
};

/// Declares them for a command.
void add_render_options(CLI::App& command, RenderOptions& options);
/// The options as command-line arguments.
std::vector<std::string> words_of(const RenderOptions& options);

struct PictureSize {
  int width = 0, height = 0;
};
/// Parses "1280x720".
std::optional<PictureSize> picture_size(const std::string& text);

/// Direction from which a camera looks.
struct ViewDirection {
  double azimuth_deg = 0;    ///< about the upward axis; 0 is from the front (+Z)
  double elevation_deg = 0;  ///< above the horizon
};
/// Parses "front", "right", "top", "iso" or "AZIMUTH,ELEVATION". @return false for other text
bool view_direction(const std::string& text, std::optional<ViewDirection>& direction);

enum class RenderKind { Film, Picture, Series };
/// The kind for the output's name; the Error lists the valid names.
Result<RenderKind> render_kind(const std::string& output);
/// The name of one of a series: its "%d" or "%05d" is the number.
std::string series_name(const std::string& output, int number);

/// The files that a rendering reads.
std::vector<std::string> inputs_of(const RenderOptions& options);
/// Checks the options without reading the input.
Status check_render(const RenderOptions& options);

}  // namespace abrazo::app

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "app/render/render_options.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;
namespace app = abrazo::app;

namespace {

/// Whether the words are taken; if not, the message that a person would see is looked at.
bool is_taken(CLI::App& parser, const std::vector<std::string>& words) {
  try {
    parser.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    return true;
  } catch (const CLI::ParseError& refusal) {
    fuzz::expect_readable({app::usage_message(&parser, refusal), ""});
    return false;
  }
}

/// The output and the input, which a command needs before it runs, are never named.
void expect_refused_by_commands(const std::string& word) {
  static app::CommandLine line;
  static const bool is_set_up = [] {
    line.app.name("abrazo")->require_subcommand(1);
    app::add_demo_command(line);
    app::add_labels_command(line);
    return true;
  }();
  fuzz::expect(is_set_up, "no commands");
  constexpr std::array<const char*, 7> of_demo = {"--seed",  "--minutes",      "--tempo", "--height",
                                                  "--skill", "--timing-error", "--style"};
  for (const char* option : of_demo)
    fuzz::expect(!is_taken(line.app, {"demo", option + ("=" + word)}),
                 "a command without its output was taken");
  fuzz::expect(!is_taken(line.app, {"labels", "info", "--fps=" + word}),
               "a command without its file was taken");
  fuzz::expect(!is_taken(line.app, {"labels", "check", "--vocabulary=" + word}),
               "a command without its file was taken");
}

void expect_rendering(const std::string& word) {
  static app::RenderOptions options;
  static CLI::App parser;
  static const bool is_set_up = [] {
    app::add_render_options(parser, options);
    return true;
  }();
  fuzz::expect(is_set_up, "no options");
  for (const char* option : {"--rate", "--size", "--camera", "--from", "--to", "-o"}) {
    options = {};
    const bool is_output = option == std::string("-o");
    std::vector<std::string> words = {"--library=l.h5", "session.abrazo"};
    if (is_output) {
      words.insert(words.end(), {"--output=" + word});
    } else {
      words.insert(words.end(), {"-o", "film.mp4", option + ("=" + word)});
    }
    if (!is_taken(parser, words)) continue;
    fuzz::expect(options.rate_hz >= 0.1 && options.rate_hz <= 240, "a rate that no film has");
    std::optional<app::ViewDirection> direction;
    fuzz::expect(app::view_direction(options.camera, direction), "a view that was taken and is none");
    if (direction)
      fuzz::expect(std::abs(direction->azimuth_deg) <= 360 && std::abs(direction->elevation_deg) < 90,
                   "a camera that looks from nowhere");
    const auto size = app::picture_size(options.size);
    fuzz::expect(
        size && size->width >= 64 && size->width <= 8192 && size->height >= 64 && size->height <= 8192,
        "a size that was taken and is none");
    if (const abrazo::Status usable = app::check_render(options); !usable)
      fuzz::expect_readable(usable.error());
    if (fuzz::accepted(app::render_kind(options.output)))
      fuzz::expect(app::series_name(options.output, 7).size() < options.output.size() + 10,
                   "a name of no length");
    // What the command passes on is read as the same.
    const std::vector<std::string> passed_on = app::words_of(options);
    options = {};
    fuzz::expect(is_taken(parser, passed_on) && app::words_of(options) == passed_on,
                 "words that come back as others");
  }
}

}  // namespace

/// The value of an option of the command line: within what the option's help says, or refused in a line that
/// a person can read. No command runs.
ABRAZO_FUZZ_TARGET(options)(fuzz::Bytes bytes) {
  const std::string word(fuzz::text_of(bytes));
  expect_refused_by_commands(word);
  expect_rendering(word);
}

#include "app/cli/command_line.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "app/cli/hint_words.hpp"
#include "app/cli/interruption.hpp"
#include "core/base/printable.hpp"
#include "core/base/text.hpp"

namespace abrazo::app {

void fail(CommandLine& line, const Error& error) {
  clear_progress(line);
  fmt::print(stderr, "abrazo: {}\n", error.text(option_words));
  line.status = 1;
}

void warn(CommandLine& line, std::string_view text) {
  if (line.quiet) return;
  clear_progress(line);
  fmt::print(stderr, "abrazo: warning: {}\n", printable_line(text));
}

void warn(CommandLine& line, const Warning& warning) {
  warn(line, warning.text(option_words));
}

void note(CommandLine& line, std::string_view text) {
  if (line.quiet) return;
  clear_progress(line);
  fmt::print(stderr, "abrazo: {}\n", printable_line(text));
}

void answer(CommandLine& line, std::string_view text) {
  clear_progress(line);
  fmt::print("{}", printable(text));
}

void answer_json(CommandLine& line, std::string_view json) {
  clear_progress(line);
  // JSON does not escape DEL and characters from U+0080 on, which programs must receive unchanged.
  fmt::print("{}{}", ::isatty(STDOUT_FILENO) == 0 ? std::string(json) : printable(json),
             json.ends_with('\n') ? "" : "\n");
}

void show_state(CommandLine& line, std::string_view text) {
  if (line.quiet || ::isatty(STDERR_FILENO) == 0) return;
  fmt::print(stderr, "\r\033[K{}", printable_line(text));
  std::fflush(stderr);
  line.progress_visible = true;
}

void clear_progress(CommandLine& line) {
  if (!line.progress_visible) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  line.progress_visible = false;
}

Progress terminal_progress(CommandLine& line) {
  return [&line, last = -1](double fraction, std::string_view doing) mutable {
    const int percent = static_cast<int>(fraction * 100);
    if (percent != last) show_state(line, fmt::format("{:3d} %  {}", percent, doing));
    if (percent >= 100) clear_progress(line);
    last = percent;
    return !interrupted();
  };
}

const CLI::Validator above_zero(
    [](const std::string& word) {
      const auto number = parse_number(word);
      const bool usable = number && std::isfinite(*number) && *number > 0;
      return usable ? std::string() : "expected a number above 0, found '" + word + "'";
    },
    "");

std::string usage_message(const CLI::App* app, const CLI::Error& refusal) {
  std::string command = app->get_name();
  const CLI::App* innermost = app;
  while (!innermost->get_subcommands().empty()) {
    innermost = innermost->get_subcommands().front();
    command += ' ' + innermost->get_name();
  }
  std::string what = refusal.what();
  // CLI11 reports only a missing command, even if an unknown one was given.
  const auto commands =
      innermost->get_subcommands([](const CLI::App* one) { return !one->get_name().empty(); });
  if (!commands.empty()) {
    std::string names;
    for (const CLI::App* one : commands) names += (names.empty() ? "" : ", ") + one->get_name();
    const auto unknown = app->remaining(true);
    what = unknown.empty() ? "a command is missing; there are " + names
                           : "'" + unknown.front() + "' is not known here; the commands are " + names;
  }
  return printable_line(fmt::format("abrazo: {}; see {} --help", what, command)) + "\n";
}

}  // namespace abrazo::app

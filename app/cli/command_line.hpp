#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "core/base/error.hpp"
#include "core/base/progress.hpp"

namespace abrazo::app {

/// What every subcommand shares.
struct CommandLine {
  CLI::App app{
      "Abrazo: a virtual partner for close interactions, from recorded pairs and their interaction meshes."};
  bool quiet = false;
  int status = 0;  ///< exit status the subcommand that ran has set: 0 done, 1 could not be done
  bool progress_visible = false;  ///< a progress line stands on the terminal
};

/// Prints one sentence on stderr, with the option that it is about, and sets the exit status to 1.
void fail(CommandLine& line, const Error& error);

/// A remark on stderr about something odd that did not stop the work; nothing with --quiet.
void warn(CommandLine& line, std::string_view text);
void warn(CommandLine& line, const Warning& warning);

/// What is going on, as a line on stderr; nothing with --quiet.
void note(CommandLine& line, std::string_view text);

/// The command's answer to a person, on stdout; control characters become '?' (see TextLines for names).
void answer(CommandLine& line, std::string_view text);

/// The command's answer to a program, on stdout: one JSON object and a line end.
void answer_json(CommandLine& line, std::string_view json);

/// How something that goes on without an end is doing: takes the place of the progress line before, on
/// stderr when that is a terminal and --quiet was not given.
void show_state(CommandLine& line, std::string_view text);

/// Takes the progress line off the terminal, so that other text can follow.
void clear_progress(CommandLine& line);

/// Stops the job when the program was interrupted. Shows a progress line on stderr when that is a terminal
/// and --quiet was not given. `line` must outlive it.
Progress terminal_progress(CommandLine& line);

/// A number above 0, such as a rate. CLI11's own check answers with the largest double spelled out.
extern const CLI::Validator above_zero;

/// What is wrong with the words given, as one line that names the help to read.
std::string usage_message(const CLI::App* app, const CLI::Error& refusal);

// One function per subcommand file: declares the subcommand's options and what it runs.
void add_motion_command(CommandLine& line);
void add_library_command(CommandLine& line);
void add_synth_command(CommandLine& line);
void add_demo_command(CommandLine& line);
void add_evaluate_command(CommandLine& line);
void add_sweep_command(CommandLine& line);
void add_live_command(CommandLine& line);
void add_send_command(CommandLine& line);
void add_export_command(CommandLine& line);
void add_labels_command(CommandLine& line);
void add_render_command(CommandLine& line);
void add_suggest_command(CommandLine& line);
void add_session_command(CommandLine& line);

}  // namespace abrazo::app

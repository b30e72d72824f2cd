#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "core/base/error.hpp"
#include "core/base/progress.hpp"

namespace abrazo::app {

/// State shared by all subcommands.
struct CommandLine {
  CLI::App app{
      "Abrazo: a virtual partner for close interactions, from recorded pairs and their interaction meshes."};
  bool quiet = false;
  int status = 0;                 ///< exit status set by the subcommand: 0 success, 1 failure
  bool progress_visible = false;  ///< the terminal shows a progress line
};

/// Prints one sentence on stderr, with the option that it is about, and sets the exit status to 1.
void fail(CommandLine& line, const Error& error);

/// A warning on stderr; nothing with --quiet.
void warn(CommandLine& line, std::string_view text);
void warn(CommandLine& line, const Warning& warning);

/// A status line on stderr; nothing with --quiet.
void note(CommandLine& line, std::string_view text);

/// The command's output for people, on stdout; control characters become '?' (see TextLines for names).
void answer(CommandLine& line, std::string_view text);

/// The command's output for programs, on stdout: one JSON object and a line end.
void answer_json(CommandLine& line, std::string_view json);

/// State of an endless job: replaces the previous progress line on stderr, if that is a terminal and --quiet
/// is not given.
void show_state(CommandLine& line, std::string_view text);

/// Clears the progress line, so that other text can follow.
void clear_progress(CommandLine& line);

/// Cancels the job if the program was interrupted. Shows a progress line on stderr if that is a terminal and
/// --quiet is not given. `line` must outlive it.
Progress terminal_progress(CommandLine& line);

/// A number above 0, such as a rate. CLI11's own check answers with the largest double spelled out.
extern const CLI::Validator above_zero;

/// A usage error as one line that refers to the help.
std::string usage_message(const CLI::App* app, const CLI::Error& refusal);

// One function per subcommand file: declares the subcommand's options and its action.
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
void add_retarget_command(CommandLine& line);
void add_session_command(CommandLine& line);

}  // namespace abrazo::app

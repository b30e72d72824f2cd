#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"

namespace abrazo {

/// A program of ours that does one piece of work in a process of its own.
struct HelperJob {
  std::filesystem::path program;
  std::vector<std::string> arguments;  ///< after the program's name
  std::string_view input;              ///< is its standard input, a file that it may map
  std::size_t most_bytes = 0;          ///< of its answer
  double patience_s = 0;               ///< on the wall
  std::string doing;                   ///< for the progress
};

/// What a helper wrote to its standard output, and how it ended.
struct HelperAnswer {
  enum class End { Exit, Signal, TooLong, TooMuch, Unknown };
  End end = End::Exit;
  int code = 0;  ///< exit status, or the signal
  std::string bytes;
};

/// Starts the program and takes its answer. It gets none of this process' open files but its input, and is in
/// a process group of its own, so that Ctrl-C in a terminal reaches this process alone. It is killed when
/// progress asks to stop, and when it takes too long or answers too much; it never outlives the call.
/// @return an Error when it cannot be started, and "cancelled"
Result<HelperAnswer> run_helper(const HelperJob& job, const Progress& progress);

}  // namespace abrazo

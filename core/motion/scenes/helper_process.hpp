#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"

namespace abrazo {

/// A program of this project that does one piece of work in a separate process.
struct HelperJob {
  std::filesystem::path program;
  std::vector<std::string> arguments;  ///< after the program's name
  std::string_view input;              ///< given as standard input, a file that can be mapped
  std::size_t most_bytes = 0;          ///< of its answer
  double patience_s = 0;               ///< of wall-clock time
  std::string doing;                   ///< for the progress
};

/// The helper's standard output, and how it ended.
struct HelperAnswer {
  enum class End { Exit, Signal, TooLong, TooMuch, Unknown };
  End end = End::Exit;
  int code = 0;  ///< exit status, or the signal
  std::string bytes;
};

/// Starts the program and reads its answer. The program inherits no open file except its input. It has its
/// own process group, so that Ctrl-C in a terminal reaches only this process. It is killed if progress
/// requests a stop, if it takes too long or if its answer is too large; it never outlives the call.
/// @return an Error if it cannot be started, or "cancelled"
Result<HelperAnswer> run_helper(const HelperJob& job, const Progress& progress);

}  // namespace abrazo

#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "core/base/result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo::app {

/// The options of every setting (docs/guide/command-line.md, Settings), the same for each subcommand that
/// solves.
class SettingsOptions {
 public:
  void add_to(CLI::App& command);

  /// The preset with the given options applied.
  Result<Settings> read() const;

 private:
  std::string preset_ = "responsive";  ///< as in the window
  std::map<std::string, std::string> given_;
};

}  // namespace abrazo::app

#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"

namespace abrazo::app {

/// The option `--character`: both characters as a humanoid of another program, one file each.
class CharacterOutput {
 public:
  void add_to(CLI::App& command, CLI::Option* output);
  bool is_given() const { return !file_.empty(); }
  const std::string& file() const { return file_; }

  /// Whether the name of the output fits: .glb or .vrm.
  Status check(const std::string& output) const;
  /// OUT_active and OUT_passive.
  std::array<std::string, 2> outputs(const std::string& output) const;
  /// Their content, in that order.
  Result<std::vector<std::pair<std::string, std::string>>> contents(const std::string& output,
                                                                    const Clip& active,
                                                                    const Clip& passive) const;

 private:
  std::string file_;
};

}  // namespace abrazo::app

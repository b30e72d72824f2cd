#pragma once

#include <optional>
#include <string>

namespace abrazo {

/// Recorded pairs that a person means, as a value: those with this label and of this take, where one is
/// given.
struct MeantPairs {
  std::optional<std::string> label;  ///< "" stands for pairs without one
  std::optional<std::string> take;   ///< by its name
  bool operator==(const MeantPairs&) const = default;
};

}  // namespace abrazo

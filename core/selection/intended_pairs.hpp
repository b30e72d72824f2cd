#pragma once

#include <optional>
#include <string>

namespace abrazo {

/// The recorded pairs of an intended move, as a value: those with this label and of this take, if given.
struct IntendedPairs {
  std::optional<std::string> label;  ///< "" = pairs without a label
  std::optional<std::string> take;   ///< by its name
  bool operator==(const IntendedPairs&) const = default;
};

}  // namespace abrazo

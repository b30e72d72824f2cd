#pragma once

#include <string>

namespace abrazo {

/// Why something from outside could not be used, fit to be shown to a person as it is.
struct Error {
  std::string message;  ///< what was expected, what was found, what to change
  std::string
      where;  ///< "walk.bvh:17", "packet 812", "manifest.json: takes[3]"; empty when there is no place

  /// "where: message", one line.
  std::string text() const;
};

}  // namespace abrazo

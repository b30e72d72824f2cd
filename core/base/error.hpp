#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace abrazo {

/// Why something from outside could not be used, fit to be shown to a person as it is.
struct Error {
  std::string message;  ///< what was expected, what was found, what to change
  std::string
      where;  ///< "walk.bvh:17", "packet 812", "manifest.json: takes[3]"; empty when there is no place

  /// "where: message", one line.
  std::string text() const;
};

/// Of a line of a text file, counted from 1.
Error error_at_line(std::string_view where, std::size_t line, std::string message);

}  // namespace abrazo

#pragma once

#include <string>
#include <string_view>

#include "core/base/error.hpp"

namespace abrazo {

/// Walks over the lines of a text (LF, CRLF or CR ends) without copying it. Skips a UTF-8 byte order mark.
class LineReader {
 public:
  explicit LineReader(std::string_view text);

  /// @return false at the end; otherwise `line` is the next line without its end
  bool next(std::string_view& line);

  /// Number of the line last returned, 1-based.
  int number() const { return number_; }

  /// The text not yet returned.
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// Cuts the first word off `rest`; empty when there is none.
std::string_view take_word(std::string_view& rest);

/// "walk.bvh:17: message".
Error error_at(std::string_view where, int line, std::string message);

/// File name without folders and extension: "takes/60_01.amc" -> "60_01".
std::string stem_of(std::string_view where);

}  // namespace abrazo

#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "core/base/printable.hpp"

namespace abrazo::app {

/// Text for people, line by line: names from files stay on their line and cannot control the terminal.
class TextLines {
 public:
  template <typename... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    text_ += printable_line(fmt::format(form, std::forward<Values>(values)...)) + '\n';
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace abrazo::app

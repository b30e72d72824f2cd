#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "core/base/text.hpp"

namespace abrazo {

/// Writes JSON straight into a string: a trace line holds thousands of numbers and is written per frame.
/// Numbers read back to the same double; numbers that are not finite are written as null.
class JsonText {
 public:
  JsonText& begin_object() { return open('{'); }
  JsonText& end_object() { return close('}'); }
  JsonText& begin_array() { return open('['); }
  JsonText& end_array() { return close(']'); }
  JsonText& key(std::string_view name);
  JsonText& value(double number);
  JsonText& value(int number) { return raw(std::to_string(number)); }
  JsonText& value(long long number) { return raw(std::to_string(number)); }
  JsonText& value(bool flag) { return raw(flag ? "true" : "false"); }
  JsonText& value(std::string_view text);
  JsonText& value(const char* text) { return value(std::string_view(text)); }
  JsonText& null() { return raw("null"); }

  /// An array of rows.
  template <typename Derived>
  JsonText& rows(const Eigen::MatrixBase<Derived>& matrix) {
    begin_array();
    for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
      begin_array();
      for (Eigen::Index c = 0; c < matrix.cols(); ++c) value(static_cast<double>(matrix(r, c)));
      end_array();
    }
    return end_array();
  }

  const std::string& text() const { return text_; }
  std::string take() { return std::move(text_); }
  void clear() { text_.clear(), first_ = true; }

 private:
  JsonText& open(char bracket);
  JsonText& close(char bracket);
  JsonText& raw(std::string_view token);
  void separate();

  std::string text_;
  bool first_ = true;  ///< the innermost object or array is empty, or a key was just written
};

}  // namespace abrazo

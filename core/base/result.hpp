#pragma once

#include <stdexcept>
#include <utility>
#include <variant>

#include "core/base/error.hpp"

namespace abrazo {

/// Either a value or an Error. Returned by everything that reads external data.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// @throws std::logic_error if there is no value: access without a check is a programming error.
  T& value() & { return require_value(), std::get<0>(content_); }
  const T& value() const& { return require_value(), std::get<0>(content_); }
  T&& value() && { return require_value(), std::get<0>(std::move(content_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const { return std::get<1>(content_); }

 private:
  void require_value() const {
    if (!ok()) throw std::logic_error("Result has no value: " + error().text());
  }
  std::variant<T, Error> content_;
};

/// Success without a value.
struct Done {};
using Status = Result<Done>;

}  // namespace abrazo

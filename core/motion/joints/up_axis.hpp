#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/positions.hpp"

namespace abrazo {

/// The axis of a file that points up, or the one (`Minus...`) that points down.
enum class UpAxis { Y, Z, MinusY, MinusZ, X, MinusX };

inline constexpr std::array every_up_axis = {UpAxis::Y,      UpAxis::Z, UpAxis::MinusY,
                                             UpAxis::MinusZ, UpAxis::X, UpAxis::MinusX};

/// "y", "-z": on the command line, in manifests and arrays.
std::string name_of(UpAxis up);
/// The axis with this name.
std::optional<UpAxis> find_up_axis(std::string_view name);
/// "y, z, -y, -z, x or -x".
std::string up_axis_names();
/// "Y", "-Z": in sentences.
std::string axis_label(UpAxis up);

UpAxis opposite(UpAxis up);

/// The column of places (0..2) along this axis, and 1 or -1.
struct SignedColumn {
  int column = 1;
  double sign = 1;
};
constexpr SignedColumn column_of(UpAxis up) {
  switch (up) {
    case UpAxis::Y:
      return {1, 1};
    case UpAxis::Z:
      return {2, 1};
    case UpAxis::MinusY:
      return {1, -1};
    case UpAxis::MinusZ:
      return {2, -1};
    case UpAxis::X:
      return {0, 1};
    case UpAxis::MinusX:
      return {0, -1};
  }
  return {1, 1};
}

/// Turns places, a row each, so that `up` becomes Y: about X, or about Z if `up` is along X. Exact.
template <class Places>
void turn_to_y_up(Places& places, UpAxis up) {
  const Places from = places;
  switch (up) {
    case UpAxis::Y:
      return;
    case UpAxis::Z:
      places.col(1) = from.col(2), places.col(2) = -from.col(1);
      return;
    case UpAxis::MinusY:
      places.col(1) = -from.col(1), places.col(2) = -from.col(2);
      return;
    case UpAxis::MinusZ:
      places.col(1) = -from.col(2), places.col(2) = from.col(1);
      return;
    case UpAxis::X:
      places.col(0) = -from.col(1), places.col(1) = from.col(0);
      return;
    case UpAxis::MinusX:
      places.col(0) = from.col(1), places.col(1) = -from.col(0);
      return;
  }
}

/// Turns places with Y up so that `up` is up: the reverse of turn_to_y_up.
template <class Places>
void turn_from_y_up(Places& places, UpAxis up) {
  const bool is_half_turn = column_of(up).column == 1;
  turn_to_y_up(places, is_half_turn ? up : opposite(up));
}

}  // namespace abrazo

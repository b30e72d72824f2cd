#include "core/motion/joints/up_axis.hpp"

#include <algorithm>
#include <cctype>

namespace abrazo {

namespace {

constexpr std::array<std::string_view, every_up_axis.size()> axis_names = {"y", "z", "-y", "-z", "x", "-x"};

}  // namespace

std::string name_of(UpAxis up) {
  return std::string(axis_names[static_cast<std::size_t>(up)]);
}

std::optional<UpAxis> find_up_axis(std::string_view name) {
  const auto found = std::ranges::find(axis_names, name);
  if (found == axis_names.end()) return std::nullopt;
  return every_up_axis[static_cast<std::size_t>(found - axis_names.begin())];
}

std::string up_axis_names() {
  std::string names;
  for (std::size_t a = 0; a < axis_names.size(); ++a)
    names += (a == 0 ? "" : a + 1 == axis_names.size() ? " or " : ", ") + std::string(axis_names[a]);
  return names;
}

std::string axis_label(UpAxis up) {
  std::string name = name_of(up);
  name.back() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.back())));
  return name;
}

UpAxis opposite(UpAxis up) {
  switch (up) {
    case UpAxis::Y:
      return UpAxis::MinusY;
    case UpAxis::MinusY:
      return UpAxis::Y;
    case UpAxis::Z:
      return UpAxis::MinusZ;
    case UpAxis::MinusZ:
      return UpAxis::Z;
    case UpAxis::X:
      return UpAxis::MinusX;
    case UpAxis::MinusX:
      return UpAxis::X;
  }
  return up;
}

}  // namespace abrazo

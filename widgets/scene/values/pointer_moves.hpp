#pragma once

namespace abrazo::widgets {

/// Mouse conventions of other programs.
enum class NavigationStyle { Abrazo, Blender, Maya, Vtk };
enum class PointerMove { None, Turn, Shift, Zoom };

struct PointerButtons {
  bool left = false, middle = false, right = false;
  bool shift = false, control = false, alt = false;
};

/// The effect of a drag.
inline PointerMove pointer_move(NavigationStyle style, const PointerButtons& pressed) {
  using M = PointerMove;
  switch (style) {
    case NavigationStyle::Abrazo:
      if (pressed.right || (pressed.middle && pressed.shift)) return M::Shift;
      return pressed.left || pressed.middle ? M::Turn : M::None;
    case NavigationStyle::Blender:
      if (!pressed.middle) return M::None;
      return pressed.shift ? M::Shift : pressed.control ? M::Zoom : M::Turn;
    case NavigationStyle::Maya:
      if (!pressed.alt) return M::None;
      return pressed.right ? M::Zoom : pressed.middle ? M::Shift : pressed.left ? M::Turn : M::None;
    case NavigationStyle::Vtk:
      if (pressed.right || (pressed.left && pressed.control && pressed.shift)) return M::Zoom;
      if (pressed.middle || (pressed.left && pressed.shift)) return M::Shift;
      return pressed.left ? M::Turn : M::None;
  }
  return M::None;
}

}  // namespace abrazo::widgets

#pragma once

#include "core/motion/body/body.hpp"

namespace abrazo {

/// A character's body, which changes gradually when another one is chosen. A plain value, for serialisation.
struct GlidingBody {
  static constexpr double glides_s = 1.5;

  Body from, goal;
  double since_s = glides_s;  ///< since the choice of `goal`
  bool of_user = false;       ///< `goal` is being measured, so a small change of it is no other choice
  bool is_known = false;      ///< false: the first goal is taken at once

  /// Advances by a frame. @param at_once no pose was shown that the body would have to continue
  void follow(const Body& wanted, bool wanted_is_of_user, double elapsed_s, bool at_once);
  Body now() const;
  bool is_there() const { return since_s >= glides_s; }
};

/// Each length between those of two bodies. @param share 0 = a, 1 = b
Body body_between(const Body& a, const Body& b, double share);

}  // namespace abrazo

#include "core/synthesis/bodies/gliding_body.hpp"

#include "core/motion/body/body_choice.hpp"
#include "core/synthesis/motion/transition.hpp"

namespace abrazo {

Body body_between(const Body& a, const Body& b, double share) {
  Body body = a;
  const auto mix = [share](double& here, double there) { here += share * (there - here); };
  for (std::size_t i = 0; i < body.bone_lengths.size(); ++i) mix(body.bone_lengths[i], b.bone_lengths[i]);
  for (std::size_t i = 0; i < body.pseudo_lengths.size(); ++i)
    mix(body.pseudo_lengths[i], b.pseudo_lengths[i]);
  mix(body.toe_rest_height, b.toe_rest_height);
  return body;
}

void GlidingBody::follow(const Body& wanted, bool wanted_is_of_user, double elapsed_s, bool at_once) {
  const bool is_same_choice =
      wanted_is_of_user == of_user && (wanted_is_of_user || are_same_lengths(wanted, goal));
  if (!is_known || at_once) {
    *this = {wanted, wanted, glides_s, wanted_is_of_user, true};
  } else if (is_same_choice) {
    since_s += elapsed_s;
    goal = wanted;
  } else {
    *this = {now(), wanted, elapsed_s, wanted_is_of_user, true};
  }
}

Body GlidingBody::now() const {
  return is_there() ? goal : body_between(from, goal, 1 - quintic_fade(since_s / glides_s));
}

}  // namespace abrazo

#include "tests/soak/wait_account.hpp"

#include <algorithm>

namespace abrazo::soak {

double WaitAccount::asleep_s(const Sight& now) const {
  const double had_s = now.watched.ran_s - last_.watched.ran_s;
  const double starved_s = now.watched.starved_s - last_.watched.starved_s;
  return std::max(now.now_s - last_.now_s - had_s - starved_s, 0.0);
}

void WaitAccount::look(const Sight& sight) {
  if (sight.is_in_driver) in_driver_s_ += asleep_s(sight);
  if (!is_seen_) renderers_before_s_ = sight.renderers_s;
  is_seen_ = true;
  last_ = sight;
}

WaitAccount::Gap WaitAccount::beat(const Sight& sight) {
  if (last_.is_in_driver) in_driver_s_ += asleep_s(sight);
  double renderers_s = 0;  // they work beside one another: the longest wait is the one that was waited for
  for (const auto& [thread, ever_s] : sight.renderers_s) {
    const auto before = renderers_before_s_.find(thread);
    renderers_s = std::max(renderers_s, ever_s - (before == renderers_before_s_.end() ? 0 : before->second));
  }
  const Gap gap{sight.now_s - beat_.now_s, sight.watched.starved_s - beat_.watched.starved_s +
                                               std::clamp(renderers_s, 0.0, in_driver_s_)};
  beat_ = last_ = sight;
  beat_.is_in_driver = last_.is_in_driver = false;
  is_seen_ = false;
  in_driver_s_ = 0;
  return gap;
}

}  // namespace abrazo::soak

#include "core/session/run/partner_output.hpp"

#include <algorithm>
#include <utility>

namespace abrazo {

Body body_of_character(const MotionLibrary& library, Character character, const Settings& settings,
                       const std::optional<Body>& user) {
  const bool is_active = (character == Character::User) == (settings.user_role == UserRole::Active);
  return is_active ? body_of_choice(settings.active_body, library.usual_active_body().body, user)
                   : body_of_choice(settings.passive_body, library.usual_passive_body().body, user);
}

void PartnerOutput::attach(Character character, std::shared_ptr<PoseSink> sink) {
  if (sink) sinks_.push_back({character, std::move(sink)});
}

void PartnerOutput::detach(const std::shared_ptr<PoseSink>& sink) {
  std::erase_if(sinks_, [&](const Attached& attached) { return attached.sink == sink; });
}

bool PartnerOutput::send(const FrameResult& result, const std::shared_ptr<const MotionLibrary>& library,
                         const Settings& settings, const std::optional<Body>& user_body, double time_s) {
  tell_bodies(*library, settings, user_body);
  const bool user_is_passive = settings.user_role == UserRole::Passive;
  user_ = user_is_passive ? Pose(result.passive()) : Pose(result.active());
  partner_ = user_is_passive ? Pose(result.active()) : Pose(result.passive());
  has_poses_ = true;
  sent_s_ = time_s;
  send_to_all(time_s, true);
  return !sinks_.empty();
}

bool PartnerOutput::hold(double time_s, bool is_tracked) {
  if (!has_poses_ || time_s < next_hold_s()) return false;
  sent_s_ = time_s;
  send_to_all(time_s, is_tracked);
  return !sinks_.empty();
}

void PartnerOutput::tell_bodies(const MotionLibrary& library, const Settings& settings,
                                const std::optional<Body>& user_body) {
  for (Attached& attached : sinks_) {
    const Body body = body_of_character(library, attached.character, settings, user_body);
    if (attached.body && are_same_lengths(*attached.body, body)) continue;
    attached.sink->set_body(body);
    attached.body = body;
  }
}

void PartnerOutput::send_to_all(double time_s, bool tracked) {
  // The partner first: it has the tighter deadline.
  for (const Character character : {Character::Partner, Character::User})
    for (const Attached& attached : sinks_)
      if (attached.character == character)
        attached.sink->send({character == Character::User ? user_ : partner_, time_s, tracked});
}

}  // namespace abrazo

#include "core/session/run/partner_output.hpp"

#include <algorithm>
#include <utility>

namespace abrazo {

const Body& body_of_character(const MotionLibrary& library, Character character, UserRole user_role) {
  const bool is_active = (character == Character::User) == (user_role == UserRole::Active);
  return is_active ? library.usual_active_body().body : library.usual_passive_body().body;
}

void PartnerOutput::attach(Character character, std::shared_ptr<PoseSink> sink) {
  if (sink) sinks_.push_back({character, std::move(sink)});
}

void PartnerOutput::detach(const std::shared_ptr<PoseSink>& sink) {
  std::erase_if(sinks_, [&](const Attached& attached) { return attached.sink == sink; });
}

bool PartnerOutput::send(const FrameResult& result, const std::shared_ptr<const MotionLibrary>& library,
                         UserRole user_role, double time_s) {
  tell_bodies(library, user_role);
  user_ = user_role == UserRole::Passive ? Pose(result.passive()) : Pose(result.active());
  partner_ = user_role == UserRole::Passive ? Pose(result.active()) : Pose(result.passive());
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

void PartnerOutput::tell_bodies(const std::shared_ptr<const MotionLibrary>& library, UserRole user_role) {
  for (Attached& attached : sinks_) {
    if (attached.library == library && attached.user_role == user_role) continue;
    attached.sink->set_body(body_of_character(*library, attached.character, user_role));
    attached.library = library;
    attached.user_role = user_role;
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

#include "core/session/run/role_switch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abrazo {

namespace {

ActivePerformer annotated_at(const LibraryTake& take, int frame) {
  for (const RoleInterval& interval : take.roles)
    if (frame >= interval.start && frame < interval.end) return interval.active;
  return ActivePerformer::Unknown;
}

}  // namespace

Status check_role_control(const RoleViews& views, RoleControl by) {
  if (by == RoleControl::Hand) return Done{};
  for (const int pair : views.pairs())
    if (views.library()->source(pair).annotated != ActivePerformer::Unknown) return Done{};
  return Error{
      "no take of the library says who is active, so only the hand can decide about the role; give "
      "\"roles\" in the manifest",
      views.library()->name()};
}

RoleSwitch::RoleSwitch(std::shared_ptr<const RoleViews> views, UserRole role)
    : views_(std::move(views)), role_(role) {}

void RoleSwitch::control(RoleControl by, UserRole role) {
  if (by != by_) since_s_ = followed_since_s_ = -1;
  if (by != RoleControl::Leader)
    judge_.reset();
  else if (!judge_)
    judge_.emplace(views_);
  by_ = by;
  role_ = role;
}

UserRole RoleSwitch::after(const RoleEvidence& evidence) {
  if (by_ == RoleControl::Hand) return role_;
  if (since_s_ < 0 || since_s_ > evidence.time_s) since_s_ = evidence.time_s;
  const auto wanted = by_ == RoleControl::Library ? annotated_role(evidence) : leading_role(evidence);
  if (!wanted || *wanted == role_ || evidence.time_s - since_s_ < dwell_s) return role_;
  role_ = *wanted;
  since_s_ = evidence.time_s;
  followed_since_s_ = -1;
  return role_;
}

std::optional<UserRole> RoleSwitch::annotated_role(const RoleEvidence& evidence) {
  const FrameResult& result = evidence.result;
  if (result.selected < 0) return std::nullopt;
  if (result.source_changed || followed_since_s_ < 0) followed_since_s_ = evidence.time_s;
  if (evidence.time_s - followed_since_s_ < followed_s) return std::nullopt;
  const int pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
  const PairSource& source = views_->library()->source(pair);
  const LibraryTake& take = views_->library()->take_of(pair);
  const bool user_is_b = source.swapped == (role_ == UserRole::Active);
  const int later = static_cast<int>(source.frame) + static_cast<int>(std::lround(look_ahead_s * take.fps));
  const ActivePerformer active = annotated_at(take, std::min(later, take.frames - 1));
  if (active == ActivePerformer::Unknown) return std::nullopt;
  return (active == ActivePerformer::B) == user_is_b ? UserRole::Active : UserRole::Passive;
}

std::optional<UserRole> RoleSwitch::leading_role(const RoleEvidence& evidence) {
  if (!evidence.user_body) return std::nullopt;
  judge_->see(evidence.user, *evidence.user_body, evidence.time_s);
  static const double enough = std::log(clearly_better);
  if (judge_->fit().evidence > enough) return UserRole::Active;
  if (judge_->fit().evidence < -enough) return UserRole::Passive;
  return std::nullopt;
}

}  // namespace abrazo

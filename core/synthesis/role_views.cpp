#include "core/synthesis/role_views.hpp"

#include <utility>

namespace abrazo {

RoleViews::RoleViews(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs)
    : library_(std::move(library)), pairs_(std::move(pairs)) {}

const RoleViews::View& RoleViews::of(UserRole role) const {
  const std::size_t at = number(role);
  std::call_once(once_[at], [&] {
    views_[at] = made(role);
    ready_[at] = true;
  });
  return views_[at];
}

RoleViews::View RoleViews::made(UserRole role) const {
  View view;
  view.library = role == UserRole::Passive
                     ? std::make_shared<const MotionLibrary>(with_roles_exchanged(*library_))
                     : library_;
  view.index = std::make_shared<const PoseIndex>(view.library->columns().features, pairs_);
  return view;
}

}  // namespace abrazo

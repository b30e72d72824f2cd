#include "core/synthesis/role_views.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

#include "core/library/motion_library_file.hpp"

namespace abrazo {

namespace {

constexpr double gigabyte = 1e9;
constexpr std::uint64_t spare_bytes = 256 << 20;  ///< that other programs and what comes next need

}  // namespace

RoleViews::RoleViews(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs,
                     std::uint64_t (*memory_left)())
    : library_(std::move(library)), pairs_(std::move(pairs)), memory_left_(memory_left) {}

RoleViews::~RoleViews() = default;

const RoleViews::View& RoleViews::of(UserRole role) const {
  const std::size_t at = number(role);
  std::call_once(once_[at], [&] {
    views_[at] = made(role);
    ready_[at] = true;
  });
  return views_[at];
}

RoleViews::View RoleViews::made(UserRole role) const {
  // Memory that is not there is given all the same, and whoever fills it is killed later.
  if (is_costly(role))
    if (const std::uint64_t needed = mapped_bytes(*library_) + spare_bytes, left = memory_left_();
        needed > left)
      throw std::runtime_error(fmt::format(
          "a passive user needs the library with roles exchanged, {:.1f} GB in memory, and {:.1f} GB "
          "are left; close other programs, or build a smaller library",
          static_cast<double>(needed) / gigabyte, static_cast<double>(left) / gigabyte));
  View view;
  view.library = role == UserRole::Passive
                     ? std::make_shared<const MotionLibrary>(with_roles_exchanged(*library_))
                     : library_;
  view.index = std::make_shared<const PoseIndex>(view.library->columns().features, pairs_);
  return view;
}

void RoleViews::prepare(UserRole role) const {
  const std::size_t at = number(role);
  const std::scoped_lock lock(preparing_);
  if (ready_[at] || is_preparing_[at]) return;
  is_preparing_[at] = true;
  workers_[at] = std::jthread([this, role, at] {
    std::optional<Error> trouble;
    try {
      of(role);
    } catch (const std::bad_alloc&) {
      trouble = Error{"there is not enough memory for the library with roles exchanged", library_->name()};
    } catch (const std::exception& failure) {
      trouble = Error{failure.what(), library_->name()};
    }
    const std::scoped_lock done(preparing_);
    troubles_[at] = std::move(trouble);
    is_preparing_[at] = false;
  });
}

std::optional<Error> RoleViews::trouble(UserRole role) const {
  const std::scoped_lock lock(preparing_);
  return std::exchange(troubles_[number(role)], std::nullopt);
}

}  // namespace abrazo

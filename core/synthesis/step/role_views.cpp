#include "core/synthesis/step/role_views.hpp"

#include <fmt/format.h>

#include <mutex>
#include <stdexcept>

#include "core/library/store/motion_library_file.hpp"

namespace abrazo {

namespace {

constexpr double gigabyte = 1e9;
constexpr std::uint64_t spare_bytes = 256 << 20;  ///< that other programs and what comes next need

}  // namespace

RoleViews::RoleViews(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs,
                     std::uint64_t (*memory_left)())
    : library_(std::move(library)),
      pairs_(std::move(pairs)),
      memory_left_(memory_left),
      views_{MadeOnce<View>([this](const Progress&) { return made(UserRole::Active); }),
             MadeOnce<View>([this](const Progress&) { return made(UserRole::Passive); })},
      intents_{MadeOnce<LearnedIntent>(
                   [this](const Progress& progress) { return learned(UserRole::Active, progress); }),
               MadeOnce<LearnedIntent>(
                   [this](const Progress& progress) { return learned(UserRole::Passive, progress); })} {}

std::shared_ptr<const RoleViews> RoleViews::shared(std::shared_ptr<const MotionLibrary> library,
                                                   std::vector<int> pairs) {
  static std::mutex guard;
  static std::vector<std::weak_ptr<const RoleViews>> in_use;
  const std::scoped_lock lock(guard);
  std::erase_if(in_use, [](const auto& views) { return views.expired(); });
  for (const auto& views : in_use)
    if (auto known = views.lock(); known && known->library_ == library && known->pairs_ == pairs)
      return known;
  auto made = std::make_shared<const RoleViews>(std::move(library), std::move(pairs));
  in_use.push_back(made);
  return made;
}

RoleViews::~RoleViews() = default;

RoleViews::View RoleViews::made(UserRole role) const {
  // The system overcommits memory, and kills the process that fills it later.
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
  view.index = std::make_shared<const PoseIndex>(pose_index_of(*view.library, pairs_));
  return view;
}

RoleViews::LearnedIntent RoleViews::learned(UserRole role, const Progress& progress) const {
  if (const std::uint64_t left = memory_left_(); left < IntentModel::most_learning_bytes + spare_bytes)
    throw std::runtime_error(
        fmt::format("learning it needs {:.1f} GB in memory, and {:.1f} GB are left; close other programs",
                    static_cast<double>(IntentModel::most_learning_bytes + spare_bytes) / gigabyte,
                    static_cast<double>(left) / gigabyte));
  return IntentModel::learn(of(role).library, pairs_, progress);
}

std::optional<Error> RoleViews::told(const std::optional<std::string>& trouble) const {
  if (!trouble) return std::nullopt;
  return Error{*trouble, library_->name()};
}

}  // namespace abrazo

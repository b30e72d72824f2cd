#include "app/scene_reader/confinement.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>

namespace abrazo::app {
namespace {

bool limit(int what, rlim_t soft, rlim_t hard) {
  rlimit now{};
  if (::getrlimit(static_cast<__rlimit_resource_t>(what), &now) != 0) return false;
  const auto lower = [&now](rlim_t wanted) {
    return now.rlim_max == RLIM_INFINITY || wanted < now.rlim_max ? wanted : now.rlim_max;
  };
  const rlimit wanted{lower(soft), lower(hard)};
  return ::setrlimit(static_cast<__rlimit_resource_t>(what), &wanted) == 0;
}

/// All kinds of file access that this version of Landlock knows; all except those allowed below are refused.
std::uint64_t every_access(long version) {
  constexpr std::uint64_t known[] = {0, (1U << 13U) - 1, (1U << 14U) - 1, (1U << 15U) - 1};
  return known[version < 3 ? version : 3];
}

/// Allows only reading in the folder. Without Landlock only the reader's own checks apply.
void allow_reading_only(const std::string& folder) {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return;
  landlock_ruleset_attr rules{};
  rules.handled_access_fs = every_access(version);
  const auto set =
      static_cast<int>(::syscall(SYS_landlock_create_ruleset, &rules, sizeof rules.handled_access_fs, 0));
  if (set < 0) return;
  if (!folder.empty()) {
    landlock_path_beneath_attr below{};
    below.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
    below.parent_fd = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (below.parent_fd >= 0) {
      ::syscall(SYS_landlock_add_rule, set, LANDLOCK_RULE_PATH_BENEATH, &below, 0);
      ::close(below.parent_fd);
    }
  }
  ::syscall(SYS_landlock_restrict_self, set, 0);
  ::close(set);
}

}  // namespace

bool confine(const Confinement& to) {
  constexpr rlim_t most_files = 16, grace_s = 2;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  bool good = ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
#ifndef ABRAZO_INSTRUMENTED  // sanitizers map terabytes of addresses
  good = good && limit(RLIMIT_AS, to.memory_bytes, to.memory_bytes);
#endif
  good = good && limit(RLIMIT_CPU, to.processor_s, to.processor_s + grace_s) && limit(RLIMIT_FSIZE, 0, 0) &&
         limit(RLIMIT_CORE, 0, 0) && limit(RLIMIT_NOFILE, most_files, most_files) &&
         limit(RLIMIT_NPROC, 0, 0);
  allow_reading_only(to.folder);
  return good;
}

}  // namespace abrazo::app

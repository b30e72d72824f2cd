#include "tests/core/session/network_drive.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <string>
#include <string_view>

namespace {

std::atomic<bool> has_locks = true, has_shared_memory = true;

bool is_on_drive(int descriptor) {
  std::array<char, 512> path{};
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = ::readlink(link.c_str(), path.data(), path.size());
  return length > 0 && std::string_view(path.data(), static_cast<std::size_t>(length)).find("/netdrive/") !=
                           std::string_view::npos;
}

bool is_about_locks(int command) {
  return command == F_SETLK || command == F_SETLKW || command == F_GETLK || command == F_OFD_SETLK;
}

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

int checked_fcntl(const char* name, int descriptor, int command, void* argument) {
  if (!has_locks && is_about_locks(command) && is_on_drive(descriptor)) {
    errno = ENOLCK;
    return -1;
  }
  return next<int (*)(int, int, ...)>(name)(descriptor, command, argument);
}

void* checked_mmap(const char* name, void* address, std::size_t length, int protection, int flags,
                   int descriptor, off_t offset) {
  if (!has_shared_memory && descriptor >= 0 && (flags & MAP_SHARED) != 0 && is_on_drive(descriptor)) {
    errno = ENODEV;
    return MAP_FAILED;
  }
  return next<void* (*)(void*, std::size_t, int, int, int, off_t)>(name)(address, length, protection, flags,
                                                                         descriptor, offset);
}

}  // namespace

namespace abrazo::test {

void network_drive_has(bool locks, bool shared_memory) {
  has_locks = locks;
  has_shared_memory = shared_memory;
}

}  // namespace abrazo::test

// In place of the system's, also for the libraries that are loaded.
// NOLINTBEGIN
extern "C" {
int fcntl(int descriptor, int command, ...) {
  va_list list;
  va_start(list, command);
  void* const argument = va_arg(list, void*);
  va_end(list);
  return checked_fcntl("fcntl", descriptor, command, argument);
}
int fcntl64(int descriptor, int command, ...) {
  va_list list;
  va_start(list, command);
  void* const argument = va_arg(list, void*);
  va_end(list);
  return checked_fcntl("fcntl64", descriptor, command, argument);
}
void* mmap(void* address, size_t length, int protection, int flags, int descriptor, off_t offset) noexcept {
  return checked_mmap("mmap", address, length, protection, flags, descriptor, offset);
}
void* mmap64(void* address, size_t length, int protection, int flags, int descriptor,
             off64_t offset) noexcept {
  return checked_mmap("mmap64", address, length, protection, flags, descriptor, offset);
}
}
// NOLINTEND

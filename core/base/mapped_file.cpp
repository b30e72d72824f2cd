#include "core/base/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <mutex>

namespace abrazo {

namespace {

/// One mapping the signal handler looks after. Only lock-free members: a handler may interrupt anything.
struct Watch {
  std::atomic<bool> taken = false;
  std::atomic<std::uintptr_t> begin = 0, end = 0;  ///< empty while not in use
  std::atomic<bool> lost_pages = false;
};
static_assert(std::atomic<std::uintptr_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

constexpr std::size_t most_mappings = 64;
std::array<Watch, most_mappings> watches;
std::uintptr_t page_bytes = 4096;
struct sigaction handler_before;

/// Maps zeros over the lost page, so that the interrupted read continues, and over all pages after it, whose
/// contents no caller relies on any more: replacing pages one by one would create a mapping each, and the
/// kernel limits them to some ten thousand.
bool replace_lost_page(std::uintptr_t address) {
  for (Watch& watch : watches) {
    if (address < watch.begin || address >= watch.end) continue;
    watch.lost_pages = true;
    const std::uintptr_t first = address / page_bytes * page_bytes;
    void* const page =
        reinterpret_cast<void*>(first);  // NOLINT(performance-no-int-to-ptr): as the kernel has it
    return mmap(page, watch.end - first, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED,
                -1, 0) == page;
  }
  return false;
}

void on_bus_error(int signal, siginfo_t* info, void* context) {
  const int errno_before = errno;
  if (!replace_lost_page(reinterpret_cast<std::uintptr_t>(info->si_addr))) {
    // Not our mapping: restores the previous handler; the read is repeated and faults again.
    if ((handler_before.sa_flags & SA_SIGINFO) != 0)
      handler_before.sa_sigaction(signal, info, context);
    else
      sigaction(SIGBUS, &handler_before, nullptr);
  }
  errno = errno_before;
}

void install_handler() {
  static std::once_flag once;
  std::call_once(once, [] {
    page_bytes = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    struct sigaction action = {};
    action.sa_sigaction = on_bus_error;
    action.sa_flags = SA_SIGINFO | SA_RESTART | SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    sigaction(SIGBUS, &action, &handler_before);
  });
}

/// Index of a free row, or most_mappings.
std::size_t take_watch() {
  for (std::size_t i = 0; i < watches.size(); ++i) {
    bool expected = false;
    if (watches[i].taken.compare_exchange_strong(expected, true)) return i;
  }
  return most_mappings;
}

}  // namespace

Result<std::shared_ptr<const MappedFile>> MappedFile::map(int descriptor, const std::string& shown) {
  struct stat status = {};
  if (fstat(descriptor, &status) != 0) return Error{std::strerror(errno), shown};
  if (status.st_size <= 0) return Error{"is empty", shown};
  install_handler();
  const std::size_t watch = take_watch();
  if (watch == most_mappings) return Error{"too many files are mapped at once; close some", shown};
  const auto size = static_cast<std::size_t>(status.st_size);
  const int own = fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  void* const start = own < 0 ? MAP_FAILED : mmap(nullptr, size, PROT_READ, MAP_SHARED, own, 0);
  if (start == MAP_FAILED) {
    const Error failure{std::string("cannot be mapped: ") + std::strerror(errno), shown};
    if (own >= 0) close(own);
    watches[watch].taken = false;
    return failure;
  }
  watches[watch].lost_pages = false;
  watches[watch].begin = reinterpret_cast<std::uintptr_t>(start);
  watches[watch].end = reinterpret_cast<std::uintptr_t>(start) + size;
  return std::shared_ptr<const MappedFile>(
      new MappedFile({static_cast<const std::byte*>(start), size}, watch, own));
}

MappedFile::~MappedFile() {
  Watch& watch = watches[watch_];
  watch.end = 0;
  watch.begin = 0;
  munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
  close(descriptor_);
  watch.taken = false;
}

bool MappedFile::lost_pages() const {
  return watches[watch_].lost_pages;
}

bool MappedFile::was_changed() const {
  return state_of(descriptor_) != state_;
}

MappedFile::State MappedFile::state_of(int descriptor) {
  struct stat status = {};
  if (fstat(descriptor, &status) != 0) return {};
  return {status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

}  // namespace abrazo

#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

#include "core/base/progress.hpp"

namespace abrazo {

/// Calls `work(i)` for i in [0, count) on all processor cores, in blocks of `block`. The order of calls is
/// undefined, so `work` must write to row i only.
/// @return false if `progress` cancelled. Rethrows what `work` throws.
template <typename Work>
bool for_each_row(std::size_t count, std::size_t block, const Progress& progress, std::string_view doing,
                  const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stop = false;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto run_block = [&] {
    const std::size_t begin = next.fetch_add(block);
    if (begin >= count || stop) return false;
    try {
      for (std::size_t i = begin; i < std::min(count, begin + block); ++i) work(i);
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      failure = std::current_exception();
      stop = true;
    }
    return true;
  };
  bool wanted = true;
  {
    std::vector<std::jthread> workers;
    for (unsigned core = 1; core < std::thread::hardware_concurrency(); ++core)
      workers.emplace_back([&] {
        while (run_block()) {
        }
      });
    while (wanted && run_block()) {
      const double fraction = static_cast<double>(std::min(next.load(), count)) / static_cast<double>(count);
      wanted = report(progress, fraction, doing);
      if (!wanted) stop = true;
    }
  }
  if (failure) std::rethrow_exception(failure);
  return wanted && report(progress, 1, doing);  // the others may have done the last rows, or all of them
}

}  // namespace abrazo

#pragma once

#include <deque>
#include <string>
#include <vector>

#include "core/base/atomic_file.hpp"

namespace abrazo {

/// Several files that appear together, when the last one is written; none of them where one fails or the
/// series goes out of scope before.
class FileSeries {
 public:
  Status add(const std::string& path, const std::string& content);
  Status commit();
  const std::vector<std::string>& paths() const { return paths_; }

 private:
  std::deque<AtomicFile> files_;
  std::vector<std::string> paths_;
};

}  // namespace abrazo

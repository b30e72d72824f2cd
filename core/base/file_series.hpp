#pragma once

#include <deque>
#include <string>
#include <vector>

#include "core/base/atomic_file.hpp"

namespace abrazo {

/// Several files that appear together once all are written; none if one cannot be written, a folder has its
/// name, or the series is destroyed before. If one cannot be renamed after others were, those are removed
/// again; older files that they replaced are lost, and the Error counts them.
class FileSeries {
 public:
  /// Every path only once. After an Error the series can no longer be committed.
  Status add(const std::string& path, const std::string& content);
  Status commit();
  const std::vector<std::string>& paths() const { return paths_; }

 private:
  std::deque<AtomicFile> files_;
  std::vector<std::string> paths_;
};

}  // namespace abrazo

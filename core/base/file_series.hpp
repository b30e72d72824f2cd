#pragma once

#include <deque>
#include <string>
#include <vector>

#include "core/base/atomic_file.hpp"

namespace abrazo {

/// Several files that appear together, once all of them are written; none of them where one cannot be
/// written, a folder has its name, or the series goes out of scope before. Where one cannot get its name
/// after others have theirs, those are taken away again; older files that they replaced are lost, and the
/// Error counts them.
class FileSeries {
 public:
  /// No path twice. After an Error the series cannot be committed any more.
  Status add(const std::string& path, const std::string& content);
  Status commit();
  const std::vector<std::string>& paths() const { return paths_; }

 private:
  std::deque<AtomicFile> files_;
  std::vector<std::string> paths_;
};

}  // namespace abrazo

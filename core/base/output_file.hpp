#pragma once

#include <list>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/atomic_file.hpp"
#include "core/base/result.hpp"

namespace abrazo {

/// Checks before long work that a file can be written: the folder exists, the path is a regular file or free,
/// and it is none of the `inputs`.
Status check_output(const std::string& path, const std::vector<std::string>& inputs);

/// "dance.bvh" with "_active" is "dance_active.bvh"; a name without extension gets it at the end.
std::string with_suffix(const std::string& path, const std::string& suffix);

/// Files that appear together: none gets its name before all are on the disk, so a full disk or a
/// cancellation leaves none.
class WholeFiles {
 public:
  /// Writes the content beside its place.
  Status add(const std::string& file, std::string_view content);
  /// Gives all files their names. Without it nothing remains of them.
  Status commit();

 private:
  std::list<AtomicFile> files_;  // none is moved
};

}  // namespace abrazo

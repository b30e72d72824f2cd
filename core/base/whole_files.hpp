#pragma once

#include <list>
#include <string>
#include <string_view>

#include "core/base/atomic_file.hpp"
#include "core/base/result.hpp"

namespace abrazo {

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

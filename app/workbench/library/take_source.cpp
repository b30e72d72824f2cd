#include "app/workbench/library/take_source.hpp"

#include "core/library/store/takes_of_library.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo::app {

Result<std::vector<PairedTake>> read_takes(const TakeSource& source, const std::vector<std::string>& names,
                                           std::vector<std::string>& warnings, const Progress& progress) {
  if (source.library) return takes_of_library(*source.library, names, source.name);
  return takes_of_manifest(source.name, names, warnings, progress);
}

}  // namespace abrazo::app

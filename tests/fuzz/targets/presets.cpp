#include "app/workbench/base/own_presets.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

/// A person's own presets, and one exported to a file.
ABRAZO_FUZZ_TARGET(presets)(fuzz::Bytes bytes) {
  const fuzz::ScratchFile file("presets.json", bytes);
  abrazo::app::OwnPresets presets(file.path());
  (void)fuzz::accepted(presets.read());
  (void)fuzz::accepted(abrazo::app::read_settings_file(file.path(), abrazo::Settings{}));
  abrazo::app::OwnPresets others(file.path().string() + "-others");
  (void)fuzz::accepted(others.adopt(std::string(fuzz::text_of(bytes)), "project"));
  std::error_code ignored;
  std::filesystem::remove(file.path().string() + "-others", ignored);
}

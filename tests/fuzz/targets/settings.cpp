#include "core/synthesis/settings/settings.hpp"

#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(settings)(fuzz::Bytes bytes) {
  const std::string_view text = fuzz::text_of(bytes);
  const auto read = abrazo::parse_settings(text, abrazo::Settings{}, "settings.json");
  if (fuzz::accepted(read)) {
    const auto again = abrazo::parse_settings(abrazo::settings_json(*read), abrazo::Settings{}, "again.json");
    fuzz::expect(again && *again == *read, "settings do not read back to what they were");
    for (const abrazo::SettingInfo& info : abrazo::all_settings()) {
      const double value = abrazo::setting_number(*read, info.key);
      fuzz::expect(value >= info.minimum && value <= info.maximum,
                   std::string(info.key) + " is out of range");
    }
  }
  for (const abrazo::SettingInfo& info : abrazo::all_settings()) {
    abrazo::Settings settings;
    (void)fuzz::accepted(abrazo::set_setting(settings, info.key, text));
  }
}

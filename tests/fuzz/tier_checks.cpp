#include "tests/fuzz/tier_checks.hpp"

namespace abrazo::fuzz {

void expect_tiers(Bytes bytes, const std::string& name) {
  for (const double fps : {0.0, 60.0}) {
    const TierReading reading{fps, {}};
    const auto document = parse_tiers(text_of(bytes), name, reading);
    if (!accepted(document)) continue;
    const Status fits = check_tiers(document->tiers, name);
    expect(fits.ok(), "tiers were read that do not hold together: " + (fits ? "" : fits.error().text()));
    for (const std::string& extension : tier_file_extensions()) {
      TierWriting writing;
      writing.fps = 60;
      const auto written = write_tiers(document->tiers, "again" + extension, writing);
      if (!accepted(written)) continue;
      const auto again = parse_tiers(written->text, "again" + extension, reading);
      // A table of no intervals has no tiers either.
      if (!document->tiers.empty() && extension == ".json")
        expect(again && again->tiers == document->tiers, "tiers do not read back to what they were");
    }
  }
}

}  // namespace abrazo::fuzz

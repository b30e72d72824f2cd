#include "core/library/takes/manifest.hpp"

#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(manifest)(fuzz::Bytes bytes) {
  const auto manifest = abrazo::parse_manifest(fuzz::text_of(bytes), "/data/input.json");
  if (!fuzz::accepted(manifest)) return;
  for (const auto& take : manifest->takes)
    for (const auto* performer : {&take.a, &take.b})
      if (performer->joint_map.empty()) (void)fuzz::accepted(abrazo::import_options(*performer, take.fps));
  const auto again = abrazo::parse_manifest(abrazo::manifest_json(*manifest, "/data"), "/data/again.json");
  fuzz::expect(again.ok(),
               "what was written of a manifest is refused" + (again ? "" : ": " + again.error().text()));
  fuzz::expect(again->takes.size() == manifest->takes.size(), "takes were lost in writing");
}

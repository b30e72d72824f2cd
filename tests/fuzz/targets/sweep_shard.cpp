#include "core/evaluation/sweep/sweep_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(sweep_shard)(fuzz::Bytes bytes) {
  const fuzz::ScratchFile file("shard-1-of-1.json", bytes);
  const auto shard = abrazo::read_shard_file(file.path());
  if (!fuzz::accepted(shard)) return;
  (void)abrazo::difference(shard->sweep, shard->sweep);
  fuzz::expect(abrazo::points_of(shard->sweep, shard->shard).size() == shard->points.size(),
               "a shard with other points than it should have");
  (void)abrazo::shard_json(shard->sweep, shard->shard, shard->points);
}

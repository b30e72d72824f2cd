#include "core/base/text.hpp"
#include "core/evaluation/sweep/sweep.hpp"
#include "core/session/file/data_reference.hpp"
#include "core/session/frames/time_place.hpp"
#include "core/stream/natnet/natnet_messages.hpp"
#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/protocol/stream_uri.hpp"
#include "core/stream/receive/decoders.hpp"
#include "core/stream/receive/stream_pipeline.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

namespace {

void read_uri(std::string_view text) {
  const auto uri = abrazo::parse_stream_uri(text);
  if (!fuzz::accepted(uri)) return;
  for (const auto direction : {abrazo::StreamDirection::Listen, abrazo::StreamDirection::Send})
    (void)fuzz::accepted(abrazo::check_stream_options(*uri, direction));
  // A joint map may be any file's name, which is for whoever wrote the URI to say.
  const std::string map = uri->option("map");
  if (map.find('/') == std::string::npos) (void)fuzz::accepted(abrazo::performer_options(*uri, {}));
  if (uri->scheme != abrazo::StreamUri::Scheme::Clip) (void)fuzz::accepted(abrazo::make_stream_decoder(*uri));
}

}  // namespace

/// What a person writes on one line.
ABRAZO_FUZZ_TARGET(words)(fuzz::Bytes bytes) {
  const std::string_view text = fuzz::text_of(bytes);
  read_uri(text);
  for (const double rate_hz : {0.0, 60.0, 29.97})
    (void)fuzz::accepted(abrazo::parse_time_place(text, rate_hz));
  const auto axis = abrazo::parse_sweep_axis(text);
  if (fuzz::accepted(axis)) fuzz::expect(!axis->values.empty(), "an axis without values");
  const auto shard = abrazo::parse_sweep_shard(text);
  if (fuzz::accepted(shard))
    fuzz::expect(shard->index >= 1 && shard->index <= shard->count, "a shard that there is not");
  (void)abrazo::parse_natnet_version(text);
  (void)abrazo::parse_natnet_group(text);
  (void)fuzz::accepted(abrazo::parse_data_use(text));
  (void)abrazo::parse_number(text);
  (void)abrazo::parse_integer(text);
}

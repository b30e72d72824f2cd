#include "core/video/video_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/limits.hpp"
#include "core/video/file_kind.hpp"
#include "core/video/frame_cache.hpp"
#include "core/video/mp4_index.hpp"
#include "core/video/picture_times.hpp"
#include "core/video/video_codec.hpp"

namespace abrazo {
namespace {

constexpr std::size_t cache_bytes = 192u << 20;
constexpr int most_pictures = 10'000'000;  // 4.6 days at 25 Hz
constexpr int witness_step = 8;            // interval of pictures with a stored fingerprint
constexpr int near_pictures = 48;          // decoded through rather than jumped over
constexpr int kept_behind = 12;            // pictures before one that was gone back to
constexpr int unknown = -2;

Error cancelled(const std::string& file) {
  return {"cancelled", file};
}

Status fits(int width, int height, const std::string& file) {
  if (static_cast<double>(width) * height <= limits::video_pixels) return Done{};
  return Error{fmt::format("its pictures are {} x {}; at most 8192 x 8192 can be shown", width, height),
               file};
}

}  // namespace

struct VideoReader::State {
  VideoFacts facts;
  std::unique_ptr<PictureStream> stream;
  std::vector<double> stamps_ms;
  std::vector<std::uint64_t> witnesses;  ///< of the pictures 0, 8, 16, ... when read from the beginning
  int stamped = 0;                       ///< number with the file's own time
  bool can_jump = true;
  FrameCache cache{cache_bytes};
  int position = -1;        ///< index of the picture that was decoded last; -1 before the first
  bool is_verified = true;  ///< since the last jump a picture matched its witness
  int last_asked = -1;

  Status measure(const Progress& progress);
  bool come_to(int index, int keep_from, const Progress& progress);
  bool forward_to(int index, int keep_from, const Progress& progress);
  bool land_before(int index, double earlier_s);
  bool begin_again();
  bool check_witness();
  Result<VideoFramePtr> current() const;
};

// ---- opening

Status VideoReader::State::measure(const Progress& progress) {
  PictureTimes times;
  times.nominal_hz = stream->nominal_hz();
  times.promised = stream->promised();
  while (static_cast<int>(times.stamps_ms.size()) < most_pictures && stream->next()) {
    const int index = static_cast<int>(times.stamps_ms.size());
    times.stamps_ms.push_back(stream->stamp_ms());
    if (index % witness_step == 0) witnesses.push_back(stream->fingerprint());
    if (index == 0) {
      const DecodedPicture first = stream->picture();
      if (first.rgb.empty()) break;
      facts.width = first.width;
      facts.height = first.height;
      if (const Status fitting = fits(first.width, first.height, facts.file); !fitting)
        return fitting.error();
    }
    const double fraction = times.promised > 0 ? std::min(1.0, (index + 1.0) / times.promised) : 0;
    if (!report(progress, fraction, "reading the times of the pictures")) return cancelled(facts.file);
  }
  if (times.stamps_ms.empty() || facts.width == 0)
    return Error{"holds no picture that can be decoded: " + why_no_video(facts.file), facts.file};
  stamped = times.mend_end();
  add_times(facts, times);
  can_jump = times.are_usable();
  stamps_ms = std::move(times.stamps_ms);
  position = unknown;  // behind the last one, from where nothing leads on
  return Done{};
}

Result<VideoReader> VideoReader::open(const std::filesystem::path& file, const Progress& progress) {
  auto state = std::make_unique<State>();
  state->facts.file = file.string();
  const auto codec = video_codec();
  if (!codec) return codec.error();
  state->stream = (*codec)->stream();
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure) || std::filesystem::file_size(file, failure) == 0 ||
      !is_known_container(file) ||
      !state->stream->open(std::filesystem::absolute(file)))  // never a protocol, whatever it looks like
    return Error{why_no_video(file), file.string()};
  const auto [width, height] = state->stream->promised_size();
  if (const Status fitting = fits(width, height, state->facts.file); !fitting)
    return fitting.error();  // before decoding
  state->facts.codec = state->stream->codec();
  if (const auto told = mp4_orientation(file)) {
    state->stream->turn(told->turn_deg, told->is_mirrored);
    state->facts.is_mirrored = told->is_mirrored;
    if (std::abs(told->told_deg - told->turn_deg) > 1)
      state->facts.warnings.push_back(
          fmt::format("its header turns the pictures by {:.0f} degrees; only quarter turns are applied, and "
                      "they are shown as coded",
                      told->told_deg));
  }
  state->facts.rotation_deg = state->stream->rotation_deg();
  if (const double aspect = state->stream->pixel_aspect(); std::abs(aspect - 1) > 1e-3)
    state->facts.warnings.push_back(
        fmt::format("its pixels are {:.4g} times as wide as high; they are shown square", aspect));
  if (const Status measured = state->measure(progress); !measured) return measured.error();
  return VideoReader(std::move(state));
}

// ---- one picture

bool VideoReader::State::check_witness() {
  if (is_verified || position % witness_step != 0) return true;
  is_verified = stream->fingerprint() == witnesses[static_cast<std::size_t>(position / witness_step)];
  return is_verified;
}

bool VideoReader::State::forward_to(int index, int keep_from, const Progress& progress) {
  while (position < index) {
    if (!report(progress, 0, "decoding") || !stream->next()) return false;
    ++position;
    if (can_jump && position < stamped && stream->stamp_ms() != stamps_ms[static_cast<std::size_t>(position)])
      return false;
    if (!check_witness()) return false;
    if (!is_verified || position < keep_from || cache.holds(position)) continue;
    if (auto frame = current()) cache.add(std::move(frame).value());
  }
  return position == index && is_verified;
}

/// Jumps to a picture before `index` so that the path passes a witness.
bool VideoReader::State::land_before(int index, double earlier_s) {
  const int witness = index / witness_step * witness_step;
  position = unknown;
  const double wanted_s = (stamps_ms[static_cast<std::size_t>(witness)] - stamps_ms[0]) / 1000 - earlier_s;
  if (!stream->jump(wanted_s)) return false;
  const double stamp_ms = stream->stamp_ms();
  const auto found = std::lower_bound(stamps_ms.begin(), stamps_ms.end(), stamp_ms);
  if (found == stamps_ms.end() || *found != stamp_ms) return false;
  const int landed = static_cast<int>(found - stamps_ms.begin());
  if (landed > witness) return false;
  position = landed;
  is_verified = false;
  return check_witness();
}

bool VideoReader::State::begin_again() {
  position = -1;
  is_verified = true;
  return stream->restart();
}

bool VideoReader::State::come_to(int index, int keep_from, const Progress& progress) {
  const auto wanted = [&] { return report(progress, 0, "decoding"); };
  if (position == index && is_verified) return true;
  if (position != unknown && position < keep_from && index - position <= near_pictures &&
      forward_to(index, keep_from, progress))
    return true;
  // After a jump a decoder may lack reference pictures; from farther back it has them.
  for (const double earlier_s : {0.0, 2.0, 12.0}) {
    if (!can_jump || !wanted()) break;
    if (land_before(keep_from, earlier_s) && forward_to(index, keep_from, progress)) return true;
  }
  return wanted() && begin_again() && forward_to(index, keep_from, progress);
}

Result<VideoFramePtr> VideoReader::State::current() const {
  DecodedPicture picture = stream->picture();
  if (picture.width != facts.width || picture.height != facts.height)
    return Error{fmt::format("picture {} is {} x {}, the first {} x {}; a video whose size changes cannot be "
                             "shown from there on",
                             position, picture.width, picture.height, facts.width, facts.height),
                 facts.file};
  auto frame = std::make_shared<VideoFrame>();
  frame->index = position;
  frame->time_s = facts.times_s[static_cast<std::size_t>(position)];
  frame->width = picture.width;
  frame->height = picture.height;
  frame->rgb = std::move(picture.rgb);
  return VideoFramePtr(std::move(frame));
}

Result<VideoFramePtr> VideoReader::frame(int index, const Progress& progress) {
  State& s = *state_;
  if (index < 0 || index >= s.facts.frames())
    throw std::invalid_argument("VideoReader::frame: no such index");
  const bool goes_back = index < s.last_asked;
  s.last_asked = index;
  if (VideoFramePtr kept = s.cache.find(index)) return kept;
  // Backward steps usually continue, so previous pictures are decoded too.
  const std::size_t bytes = static_cast<std::size_t>(s.facts.width) * s.facts.height * 3;
  const int behind = goes_back ? std::min(kept_behind, s.cache.room(bytes) / 2) : 0;
  if (!s.come_to(index, std::max(0, index - behind), progress)) {
    s.position = unknown;
    if (!report(progress, 0, "decoding")) return cancelled(s.facts.file);
    return Error{fmt::format("picture {} cannot be decoded as it was when the file was opened; it may have "
                             "changed since: open it again",
                             index),
                 s.facts.file};
  }
  if (VideoFramePtr kept = s.cache.find(index)) return kept;
  auto frame = s.current();
  if (frame) s.cache.add(*frame);
  return frame;
}

bool VideoReader::holds(int index) const {
  return state_->cache.holds(index);
}

const VideoFacts& VideoReader::facts() const {
  return state_->facts;
}

VideoReader::VideoReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
VideoReader::VideoReader(VideoReader&&) noexcept = default;
VideoReader& VideoReader::operator=(VideoReader&&) noexcept = default;
VideoReader::~VideoReader() = default;

}  // namespace abrazo

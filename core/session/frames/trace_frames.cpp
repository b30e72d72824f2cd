#include "core/session/frames/trace_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <nlohmann/json.hpp>

#include "core/base/limits.hpp"
#include "core/base/text.hpp"

namespace abrazo {
namespace {

constexpr std::size_t longest_line = 16u << 20;  // a frame with 10 candidates takes 30 kB
constexpr std::size_t most_frames = 50'000'000;

/// As std::getline, but of bounded length. @return false at the end; `line` is left too long to say so
bool next_line(std::istream& stream, std::string& line) {
  line.clear();
  for (int c = stream.get(); c != std::char_traits<char>::eof(); c = stream.get()) {
    if (c == '\n') return true;
    line.push_back(static_cast<char>(c));
    if (line.size() > longest_line) return true;
  }
  return !line.empty();
}

Result<TraceHeader> read_header(const std::string& line, const std::string& where) {
  if (const char* beyond = json_beyond_bounds(line)) return Error{beyond, where};
  const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("abrazo_trace"))
    return Error{
        "is no trace: its first line has to be a header with \"abrazo_trace\", as the traces "
        "of abrazo synth have it",
        where};
  if (json["abrazo_trace"] != 1)
    return Error{"is a trace of a newer version of Abrazo; render it with that version", where};
  if (const auto units = json.find("units"); units != json.end() && *units != "m")
    return Error{"\"units\" is not \"m\": positions in a trace are in metres", where};
  TraceHeader header;
  header.library =
      json.value("library", nlohmann::json()).is_string() ? json["library"].get<std::string>() : "";
  header.input = json.value("input", nlohmann::json()).is_string() ? json["input"].get<std::string>() : "";
  header.fps = json.value("fps", nlohmann::json()).is_number() ? json["fps"].get<double>() : 0;
  if (json.contains("settings")) {
    auto settings = parse_settings(json["settings"].dump(), header.settings, where);
    if (!settings) return settings.error();
    header.settings = *settings;
  }
  return header;
}

}  // namespace

Result<TraceFrames> TraceFrames::open(const std::filesystem::path& file, const Progress& progress) {
  TraceFrames trace;
  trace.file_ = file.string();
  std::error_code failure;
  const auto size = std::filesystem::file_size(file, failure);
  trace.stream_.open(file, std::ios::binary);
  if (failure || !trace.stream_)
    return Error{"cannot be opened; check the path and its permissions", trace.file_};
  std::string line;
  const auto where = [&](std::size_t number) { return fmt::format("{}:{}", trace.file_, number); };
  if (!next_line(trace.stream_, line)) return Error{"is empty; a trace begins with a header line", where(1)};
  auto header = read_header(line, where(1));
  if (!header) return header.error();
  trace.header_ = std::move(header).value();
  std::streamoff place = trace.stream_.tellg();
  for (std::size_t number = 2; next_line(trace.stream_, line); ++number) {
    if (line.size() > longest_line || trace.times_s_.size() >= most_frames)
      return Error{"is too long a line, or the trace has too many", where(number)};
    if (!trimmed(line).empty()) {
      const auto frame = read_trace_frame(line, trace.times_s_.size(), trace.header_.settings, where(number));
      if (!frame) return frame.error();
      if (!trace.times_s_.empty() && (*frame)->time_s < trace.times_s_.back())
        return Error{fmt::format("its time {} is before that of the line before, {}; the frames of a trace "
                                 "follow one another",
                                 (*frame)->time_s, trace.times_s_.back()),
                     where(number)};
      trace.times_s_.push_back((*frame)->time_s);
      trace.places_.push_back(place);
    }
    place += static_cast<std::streamoff>(line.size()) + 1;
    const double fraction =
        size > 0 ? std::min(1.0, static_cast<double>(place) / static_cast<double>(size)) : 1;
    if (!report(progress, fraction, "reading the trace")) return Error{"cancelled", trace.file_};
  }
  if (trace.times_s_.empty()) return Error{"has a header and no frame", trace.file_};
  return trace;
}

Result<FrameSnapshotPtr> TraceFrames::read(std::size_t index) {
  stream_.clear();
  stream_.seekg(places_[index]);
  std::string line;
  if (!next_line(stream_, line)) return Error{"has become shorter while it was read", file_};
  return read_trace_frame(line, index, header_.settings, file_);
}

Result<FrameSnapshotPtr> TraceFrames::at(double time_s) {
  const auto after = std::upper_bound(times_s_.begin(), times_s_.end(), time_s);
  const std::size_t index =
      static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - times_s_.begin() - 1));
  if (newest_ && newest_index_ == index) return newest_;
  auto frame = read(index);
  if (!frame) return frame;
  newest_ = *frame;
  newest_index_ = index;
  return newest_;
}

}  // namespace abrazo

#include "core/session/frames/time_place.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/base/text.hpp"

namespace abrazo {
namespace {

constexpr double longest_s = 1e7;  // months; more is a slip of the finger
constexpr std::string_view examples =
    "write a frame (690), a time (11.5s, 0:11.5), a timecode (00:00:11:15), or how far from here (+30, -1s)";

Error refused(std::string_view text, const std::string& why) {
  return {in_quotes(text) + " " + why + "; " + std::string(examples), ""};
}

bool takes(std::string_view& text, std::string_view ending) {
  if (!text.ends_with(ending)) return false;
  text = trimmed(text.substr(0, text.size() - ending.size()));
  return true;
}

/// Only digits and a point: neither a sign nor an exponent belongs in a field.
std::optional<double> plain_number(std::string_view text) {
  if (text.empty() || text.find_first_not_of("0123456789.") != std::string_view::npos) return {};
  return parse_number(text);
}

Result<TimePlace> with_unit(std::string_view whole, std::string_view number, double unit_s) {
  const auto value = plain_number(number);
  if (!value) return refused(whole, "is not a number and a unit");
  return TimePlace{.time_s = *value * unit_s};
}

Result<TimePlace> with_colons(std::string_view whole, std::string_view body, double rate_hz) {
  std::vector<std::string_view> fields = split_fields(body, ':');
  const bool timecode = fields.size() == 4;
  if (fields.size() > 4) return refused(whole, "has more fields than hours:minutes:seconds:frames");
  double frames = 0;
  if (timecode) {
    const double per_second = std::round(rate_hz);
    if (per_second < 1) return refused(whole, "needs a frame rate, and this input has none");
    const auto last = parse_integer(fields.back());
    if (!plain_number(fields.back()) || !last) return refused(whole, "does not end in a number of frames");
    if (static_cast<double>(*last) >= per_second)
      return refused(whole, "counts frames only up to " + std::to_string(std::lround(per_second) - 1) +
                                ", there are " + std::to_string(std::lround(per_second)) + " in a second");
    frames = static_cast<double>(*last) / per_second;
    fields.pop_back();
  }
  double time_s = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto value = plain_number(fields[i]);
    const bool is_last = i + 1 == fields.size();
    if (!value || ((!is_last || timecode) && fields[i].find('.') != std::string_view::npos))
      return refused(whole, "has a field that is not a number");
    if (i > 0 && *value >= 60) return refused(whole, "has more than 59 minutes or seconds in a field");
    time_s = 60 * time_s + *value;
  }
  return TimePlace{.time_s = time_s + frames};
}

Result<TimePlace> unsigned_place(std::string_view whole, std::string_view body, double rate_hz) {
  if (body.find(':') != std::string_view::npos) return with_colons(whole, body, rate_hz);
  if (takes(body, "ms")) return with_unit(whole, body, 1e-3);
  if (takes(body, "min")) return with_unit(whole, body, 60);
  if (takes(body, "s")) return with_unit(whole, body, 1);
  if (!plain_number(body)) return refused(whole, "is neither a frame nor a time");
  const auto frame = parse_integer(body);
  if (!frame) return refused(whole, "is no whole frame; " + std::string(body) + "s would be a time");
  return TimePlace{.kind = TimePlace::Kind::Frame, .frame = *frame};
}

std::string formatted(const char* format, auto... values) {
  char text[64];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

Result<TimePlace> parse_time_place(std::string_view text, double rate_hz) {
  const std::string_view whole = trimmed(text);
  if (whole.empty()) return Error{"nothing is written; " + std::string(examples), ""};
  if (whole.find(',') != std::string_view::npos)
    return refused(whole, "has a comma; the decimal sign is a point");
  std::string_view body = whole;
  constexpr std::string_view minus = "\u2212";  // as the workbench itself writes it
  const bool back = body.starts_with('-') || body.starts_with(minus);
  const bool relative = back || body.starts_with('+');
  if (relative) body = trimmed(body.substr(body.starts_with(minus) ? minus.size() : 1));
  const std::string lower = lower_case(body);
  auto place = unsigned_place(whole, lower, rate_hz);
  if (!place) return place;
  if (place->time_s > longest_s || place->frame > static_cast<std::int64_t>(1e12))
    return refused(whole, "is too far away");
  place->relative = relative;
  if (back) {
    place->frame = -place->frame;
    place->time_s = -place->time_s;
  }
  return place;
}

namespace {

Result<double> time_of_frame(std::int64_t index, const FrameHistory& history) {
  const auto span = history.span();
  const auto oldest = history.at(span.first_s), newest = history.at(span.last_s);
  const auto first = static_cast<std::int64_t>(oldest->index),
             last = static_cast<std::int64_t>(newest->index);
  const std::string name = "frame " + std::to_string(index);
  if (index < 0) return Error{name + " would be before the first one", ""};
  if (index < first)
    return Error{name + " was given up when the memory was full; the oldest kept is " + std::to_string(first),
                 ""};
  if (index > last)
    return Error{name + " has not been solved yet; the newest is " + std::to_string(last), ""};
  return history.stepped(span.first_s, static_cast<int>(index - first))->time_s;
}

}  // namespace

Result<double> find_time(const TimePlace& place, const FrameHistory& history, double cursor_s) {
  const auto span = history.span();
  if (span.frames == 0) return Error{"nothing has been solved yet", ""};
  if (place.kind == TimePlace::Kind::Frame) {
    const std::int64_t here = place.relative ? static_cast<std::int64_t>(history.at(cursor_s)->index) : 0;
    return time_of_frame(here + place.frame, history);
  }
  const double time_s = place.time_s + (place.relative ? cursor_s : 0);
  constexpr double rounding_s = 5e-4;  // half of the last digit that is shown
  if (time_s < span.first_s - rounding_s)
    return Error{(time_s < 0 ? "that would be before the beginning"
                             : clock_text(time_s) + " was given up when the memory was full") +
                     "; the oldest kept is at " + clock_text(span.first_s),
                 ""};
  if (time_s > span.last_s + rounding_s)
    return Error{clock_text(time_s) + " has not come yet; the newest is at " + clock_text(span.last_s), ""};
  return std::clamp(time_s, span.first_s, span.last_s);
}

std::string clock_text(double time_s) {
  const auto ms = static_cast<long long>(std::llround(std::abs(time_s) * 1000));
  const long long hours = ms / 3600000;
  const std::string sign = time_s < 0 && ms > 0 ? "−" : "";
  const std::string tail = formatted("%02lld:%02lld.%03lld", ms / 60000 % 60, ms / 1000 % 60, ms % 1000);
  return sign + (hours > 0 ? formatted("%lld:", hours) + tail : tail);
}

std::string timecode_text(double time_s, double rate_hz) {
  const auto per_second = std::llround(std::max(0.0, rate_hz));
  constexpr double rounding = 1e-6;  // a frame's own time must not fall into the one before
  const double time = std::max(0.0, time_s) + rounding;
  const auto seconds = static_cast<long long>(time);
  const std::string whole =
      formatted("%02lld:%02lld:%02lld", seconds / 3600, seconds / 60 % 60, seconds % 60);
  if (per_second < 1) return whole;
  const auto frames =
      static_cast<long long>((time - static_cast<double>(seconds)) * static_cast<double>(per_second));
  return whole + formatted(per_second > 100 ? ":%03lld" : ":%02lld", frames);
}

std::string time_text(TimeFormat format, double time_s, std::int64_t frame, double rate_hz) {
  if (format == TimeFormat::Seconds) return formatted("%.3f s", std::max(0.0, time_s));
  if (format == TimeFormat::Frames) return frame < 0 ? "no frame" : std::to_string(frame);
  if (format == TimeFormat::Timecode) return timecode_text(time_s, rate_hz);
  return clock_text(time_s);
}

}  // namespace abrazo

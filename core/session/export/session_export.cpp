#include "core/session/export/session_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/statistics.hpp"
#include "core/session/export/export_plan.hpp"
#include "core/stream/receive/sender_clock.hpp"
#include "core/synthesis/frames/trace.hpp"

namespace abrazo {

namespace {

constexpr double all_s = std::numeric_limits<double>::infinity();

template <typename Named>
std::string names_of(const std::vector<Named>& all) {
  std::string names;
  for (const Named& one : all) names += (names.empty() ? "'" : ", '") + one.name + "'";
  return names;
}

Result<const SessionTake*> find_take(const SessionRecord& session, const std::string& name) {
  const SessionTake* found = nullptr;
  for (const SessionTake& take : session.contents().takes) {
    if (take.name != name) continue;
    if (found)
      return Error{fmt::format("has two takes named '{}', at {:.3f} and {:.3f} s; choose one by its times "
                               "instead",
                               name, found->start_s, take.start_s),
                   session.where()};
    found = &take;
  }
  if (found) return found;
  const auto& takes = session.contents().takes;
  return Error{takes.empty() ? "has no takes; leave the take out, or choose by times"
                             : fmt::format("has no take '{}'; there are {}", name, names_of(takes)),
               session.where()};
}

struct Bounds {
  double from_s = -all_s, to_s = all_s;
};

Result<Bounds> bounds_of(const SessionRecord& session, const SessionPart& part) {
  Bounds bounds;
  if (part.take) {
    const auto take = find_take(session, *part.take);
    if (!take) return take.error();
    bounds = {(*take)->start_s, (*take)->end_s};
  }
  if (part.from_s) bounds.from_s = std::max(bounds.from_s, *part.from_s);
  if (part.to_s) bounds.to_s = std::min(bounds.to_s, *part.to_s);
  if (bounds.to_s < bounds.from_s)
    return Error{fmt::format("nothing lies between {:.3f} and {:.3f} s{}", bounds.from_s, bounds.to_s,
                             part.take ? " of the take '" + *part.take + "'" : ""),
                 session.where()};
  return bounds;
}

double share(double time_s, double from_s, double to_s) {
  return to_s > from_s ? std::clamp((time_s - from_s) / (to_s - from_s), 0.0, 1.0) : 0;
}

constexpr std::array<std::string_view, 3> body_names = {"user", "active", "passive"};

Pose pose_of(const FrameSnapshot& frame, SessionBody body) {
  switch (body) {
    case SessionBody::Active:
      return frame.result.active();
    case SessionBody::Passive:
      return frame.result.passive();
    case SessionBody::User:
      break;
  }
  return frame.user;
}

/// The times at which received poses were taken, on the clock of the session. A sender's own clock is
/// steadier than arrival over a network, if it proves itself as it has to while it is received.
void use_sender_clock(std::vector<StampedPose>& poses, const std::vector<double>& sender_s) {
  std::vector<double> offsets;
  SenderClock clock;
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (clock.take(sender_s[i], poses[i].time_s) || clock.doubt() != SenderClock::Doubt::None) return;
  for (std::size_t i = 0; i < poses.size(); ++i) offsets.push_back(poses[i].time_s - sender_s[i]);
  const double offset = percentile(offsets, 0.5);
  constexpr double largest_delay_s = 0.25;
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (!(std::abs(offsets[i] - offset) < largest_delay_s) || (i > 0 && sender_s[i] <= sender_s[i - 1]))
      return;
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i].time_s = sender_s[i] + offset;
}

Result<SessionMotion> even_motion(std::vector<std::vector<StampedPose>> bodies,
                                  const std::vector<std::string>& names, double wanted_hz,
                                  const RowsRead& rows, const std::string& path) {
  const auto timing = plan_motion(times_of(bodies.front()), wanted_hz, path);
  if (!timing) return timing.error();
  SessionMotion motion;
  motion.rows = rows;
  motion.timing = *timing;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    motion.clips.push_back({names[b], timing->rate_hz, resample(bodies[b], timing->rate_hz).poses});
    std::vector<StampedPose>().swap(bodies[b]);
  }
  return motion;
}

}  // namespace

Result<SessionRange> session_range(const SessionRecord& session, const SessionPart& part) {
  const auto bounds = bounds_of(session, part);
  if (!bounds) return bounds.error();
  SessionRange range{all_s, -all_s, 0, 0};
  const Status looked =
      session.each_source(bounds->from_s, bounds->to_s, [&](const SessionSource& frame) -> Status {
        if (range.from_s == all_s) range.from_s = frame.time_s, range.first_frame = frame.frame;
        range.to_s = std::max(range.to_s, frame.time_s);
        range.last_frame = frame.frame;
        return Done{};
      });
  if (!looked) return looked.error();
  if (range.from_s <= range.to_s) return range;
  const SessionContents& contents = session.contents();
  if (contents.frames == 0)
    return Error{"has no solved frames; only received poses, if any", session.where()};
  return Error{
      fmt::format("has no frames there; they go from {:.3f} to {:.3f} s", contents.first_s, contents.last_s),
      session.where()};
}

Result<SessionMotion> session_motion(const SessionRecord& session, const SessionRange& range,
                                     std::span<const SessionBody> bodies, double rate_hz,
                                     const Progress& progress) {
  std::vector<std::vector<StampedPose>> stamped(bodies.size());
  const auto rows = session.each_frame(range.from_s, range.to_s, [&](const FrameSnapshot& frame) -> Status {
    if (!report(progress, share(frame.time_s, range.from_s, range.to_s), "Reading the frames"))
      return Error{"cancelled; nothing was written", session.where()};
    for (std::size_t b = 0; b < bodies.size(); ++b)
      stamped[b].push_back({frame.time_s, pose_of(frame, bodies[b])});
    return Done{};
  });
  if (!rows) return rows.error();
  if (rows->read == 0 || stamped.front().empty())
    return Error{"none of the frames there can be read: " + rows->damage, session.where()};
  std::vector<std::string> names;
  for (const SessionBody body : bodies) names.emplace_back(body_names[static_cast<std::size_t>(body)]);
  return even_motion(std::move(stamped), names, rate_hz, *rows, session.where());
}

Result<SessionMotion> performer_motion(const SessionRecord& session, const SessionPart& part,
                                       const std::string& performer, double rate_hz,
                                       const Progress& progress) {
  const auto bounds = bounds_of(session, part);
  if (!bounds) return bounds.error();
  const auto& performers = session.contents().performers;
  const auto found = std::find_if(performers.begin(), performers.end(), [&](const SessionPerformer& one) {
    return one.name == performer || (performer.empty() && performers.size() == 1);
  });
  if (performers.empty())
    return Error{"nothing was received from a stream; export the user instead", session.where()};
  if (found == performers.end())
    return Error{fmt::format("has no performer '{}'; there are {}", performer, names_of(performers)),
                 session.where()};
  std::vector<StampedPose> stamped;
  std::vector<double> sender_s;
  const auto rows =
      session.each_pose(found->id, bounds->from_s, bounds->to_s, [&](const ReceivedPose& pose) -> Status {
        if (!report(progress, share(pose.pose.time_s, found->first_s, found->last_s), "Reading the poses"))
          return Error{"cancelled; nothing was written", session.where()};
        const bool arrived = pose.pose.arrived_s >= 0;
        stamped.push_back({arrived ? pose.pose.arrived_s : pose.pose.time_s, pose.pose.pose});
        sender_s.push_back(pose.sender_time_s.value_or(pose.pose.time_s));
        return Done{};
      });
  if (!rows) return rows.error();
  if (stamped.empty())
    return Error{fmt::format("has no poses of '{}' there; they go from {:.3f} to {:.3f} s", found->name,
                             found->first_s, found->last_s),
                 session.where()};
  use_sender_clock(stamped, sender_s);
  return even_motion({std::move(stamped)}, {found->name}, rate_hz, *rows, session.where());
}

Result<std::vector<SessionSegment>> session_segments(const SessionRecord& session,
                                                     const SessionRange& range) {
  const auto& libraries = session.contents().libraries;
  const auto library_of = [&](std::uint64_t frame) {
    const SessionLibrary* found = nullptr;
    for (const SessionLibrary& library : libraries)
      if (library.first_frame <= frame) found = &library;
    return found;
  };
  std::vector<SessionSegment> segments;
  const Status looked =
      session.each_source(range.from_s, range.to_s, [&](const SessionSource& frame) -> Status {
        const SessionLibrary* library = library_of(frame.frame);
        if (segments.empty() || segments.back().library != library)
          segments.push_back({library, {frame.time_s, frame.time_s, frame.frame, frame.frame}});
        segments.back().range.to_s = frame.time_s;
        segments.back().range.last_frame = frame.frame;
        return Done{};
      });
  if (!looked) return looked.error();
  return segments;
}

Result<std::string> session_trace_header(const SessionRecord& session, const std::string& library_name,
                                         const SessionRange& range) {
  TraceHeader header{library_name, "", 0, {}};
  for (const SessionInput& input : session.contents().inputs)
    if (input.first_frame <= range.first_frame) header.input = input.text;
  for (const SessionSettings& change : session.contents().settings)
    if (change.frame <= range.first_frame) header.settings = change.settings;
  std::vector<double> times_s;
  const Status looked =
      session.each_source(range.from_s, range.to_s, [&](const SessionSource& frame) -> Status {
        constexpr std::size_t enough = 4096;  // for a median
        if (times_s.size() < enough) times_s.push_back(frame.time_s);
        return Done{};
      });
  if (!looked) return looked.error();
  header.fps = even_rate(median_rate_hz(times_s));
  return trace_header_line(header);
}

Result<SessionReplay> session_trace(const SessionRecord& session,
                                    std::shared_ptr<const MotionLibrary> library, const SessionRange& range,
                                    const std::function<Status(const std::string&)>& each_line,
                                    const Progress& progress) {
  return re_solve_session(
      session, library, range.from_s, range.to_s,
      [&](const FrameSnapshot& frame) -> Status {
        const long long number =
            frame.input_frame >= 0 ? frame.input_frame : static_cast<long long>(frame.index);
        return each_line(trace_frame_line(frame.result, *library, number, frame.time_s));
      },
      progress);
}

}  // namespace abrazo

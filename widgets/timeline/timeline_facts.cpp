#include <algorithm>
#include <cmath>

#include "core/session/frames/time_place.hpp"
#include "widgets/timeline/timeline_content.hpp"

namespace abrazo::widgets {
namespace {

QString words(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<int>(utf8.size())).toHtmlEscaped();
}

QString clock_at(double time_s) {
  return words(clock_text(time_s));
}

/// "turn · follower left ×1".
QString move_of(const LibraryTake& take, int frame) {
  for (const LabelInterval& label : take.labels) {
    if (frame < label.start || frame >= label.end) continue;
    QString move = words(label.label).replace('_', ' ');
    if (!label.detail.empty()) move += " · " + words(label.detail);
    return move;
  }
  return {};
}

QString source_facts(const TimelineContent& content, double time_s) {
  const int pair = content.tracks.pair_at(time_s);
  if (!content.library || pair < 0 || pair >= content.library->pair_count()) return {};
  const PairSource& source = content.library->source(pair);
  const LibraryTake& take = content.library->take_of(pair);
  QString facts = QString("<b>%1 · frame %2</b>").arg(words(take.name)).arg(source.frame);
  const QString move = move_of(take, static_cast<int>(source.frame));
  if (!move.isEmpty()) facts += "<br>" + move;
  const auto* leads = interval_at(content.tracks.leaders(), time_s);
  if (leads)
    facts +=
        QString("<br>%1 leads, as the %2")
            .arg(leads->key == static_cast<int>(Leader::User) ? "user" : "partner",
                 source.annotated == ActivePerformer::Unknown ? "setting says" : "recording is annotated");
  return facts;
}

QString figure_facts(const SampleCurve& curve, double time_s, double around_s, const char* name,
                     const char* unit) {
  const auto here = curve.columns(time_s - around_s, time_s + around_s, 1).front();
  if (is_empty(here)) return {};
  const bool one = here.most - here.least <= 1e-4F * std::abs(here.most);
  const auto figure = [](float value) { return QString::number(static_cast<double>(value), 'g', 3); };
  return QString("<br>%1 %2 %3")
      .arg(name, one ? figure(here.most) : figure(here.least) + " to " + figure(here.most), unit);
}

QString settings_facts(const TimelineContent& content, double x_px) {
  constexpr double reach_px = 8;
  QString facts;
  for (const SettingsChange& change : content.settings_marks) {
    const double x = content.axis().x(change.time_s);
    if (x_px < x - reach_px || x_px > std::max(x, content.axis().x(change.until_s)) + reach_px) continue;
    facts +=
        (facts.isEmpty() ? "<b>" : "<br><b>") + words(change.text) + "</b><br>at " + clock_at(change.time_s);
  }
  return facts;
}

QString marker_facts(const TimelineContent& content, double time_s) {
  constexpr double reach_px = 8;
  const Marker* marker = content.markers.near(time_s, reach_px * content.axis().seconds_per_pixel());
  if (!marker) return {};
  return QString("<b>%1</b><br>marker at %2").arg(words(marker_title(*marker)), clock_at(marker->time_s));
}

QString take_facts(const TimelineContent& content, double time_s) {
  const TimelineTake* take = take_at(content, time_s);
  if (!take) return {};
  return QString("<b>%1</b><br>%2, %3 s at %4<br>Double click: in and out there")
      .arg(words(take->name), take->is_running ? "being recorded" : "take")
      .arg((take->is_running ? content.playback.last_s : take->to_s) - take->from_s, 0, 'f', 1)
      .arg(clock_at(take->from_s));
}

QString user_role_facts(const TimelineContent& content, double time_s) {
  const auto* role = interval_at(content.tracks.user_roles(), time_s);
  if (!role) return {};
  return QString("<br>the user's role is to %1 since %2")
      .arg(role->key == 1 ? "lead" : "follow", clock_at(role->from_s));
}

}  // namespace

const TimelineTake* take_at(const TimelineContent& content, double time_s) {
  const auto found =
      std::find_if(content.takes.rbegin(), content.takes.rend(), [&](const TimelineTake& take) {
        return take.from_s <= time_s && (take.is_running || time_s <= take.to_s);
      });
  return found == content.takes.rend() ? nullptr : &*found;
}

QString facts_at(const TimelineContent& content, const QPointF& place) {
  const TimelineAxis& axis = content.axis();
  if (place.x() < axis.left_px || place.x() > axis.right_px()) return {};
  const double time_s = axis.time(place.x());
  if (const QString facts = tier_facts(content, place); !facts.isEmpty()) return facts;
  TimelineLane lane{};
  const bool on_lane = content.lanes.lane_at(place.y(), lane);
  if (on_lane && lane == TimelineLane::Settings) return settings_facts(content, place.x());
  if (on_lane && lane == TimelineLane::Markers) return marker_facts(content, time_s);
  if (on_lane && lane == TimelineLane::Takes) return take_facts(content, time_s);
  if (time_s < content.playback.first_s)
    return time_s < 0 ? QString()
                      : QString("Dropped: the memory for frames is full, and they are not on disk");
  QString facts = source_facts(content, time_s);
  if (facts.isEmpty()) return {};
  const double around_s = std::max(axis.seconds_per_pixel(), 0.01);
  if (on_lane && lane == TimelineLane::Cost)
    facts += figure_facts(content.tracks.costs(), time_s, around_s, "cost",
                          content.tracks.is_by_intent_at(time_s) ? "m" : "m²");
  if (on_lane && lane == TimelineLane::Role) facts += user_role_facts(content, time_s);
  if (on_lane && lane == TimelineLane::Energy)
    facts += figure_facts(content.tracks.energies(), time_s, around_s, "energy", "m²");
  if (time_s < content.memory_first_s && !content.lanes.is_of_take()) facts += "<br><i>on disk</i>";
  return facts + "<br>" + clock_at(time_s);
}

Leader leader_of(bool user_is_active, int pair, const MotionLibrary* library) {
  const Leader as_set = user_is_active ? Leader::User : Leader::Partner;
  if (!library || pair < 0 || pair >= library->pair_count()) return as_set;
  const PairSource& source = library->source(pair);
  if (source.annotated == ActivePerformer::Unknown) return as_set;
  // The performer that the user replaces: the active one of the library pair, or the other.
  const bool user_is_a = user_is_active != source.swapped;
  return (source.annotated == ActivePerformer::A) == user_is_a ? Leader::User : Leader::Partner;
}

}  // namespace abrazo::widgets

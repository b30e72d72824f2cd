#include "widgets/timeline/timeline_painter.hpp"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <map>

#include "widgets/common/qt_versions.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/timeline/curve_picture.hpp"
#include "widgets/timeline/timeline_content.hpp"

namespace abrazo::widgets {
namespace {

constexpr double names_left = 14;
constexpr double tick_apart = 90;

QString tick_text(double time_s, double step_s) {
  if (std::abs(time_s) < 60 && step_s < 60)
    return QString::number(time_s, 'f', step_s < 0.1 ? 2 : step_s < 1 ? 1 : 0) + " s";
  const auto hundredths = static_cast<long long>(std::llround(time_s * 100));
  const auto two = [](long long value) { return QString("%1").arg(value, 2, 10, QChar('0')); };
  const long long minutes = hundredths / 6000;
  QString words =
      minutes >= 60 ? QString("%1:%2").arg(minutes / 60).arg(two(minutes % 60)) : QString::number(minutes);
  words += ":" + two(hundredths / 100 % 60);
  if (step_s < 1) words += "." + two(hundredths % 100);
  return words;
}

class Painting {
 public:
  Painting(QPainter& painter, const TimelineContent& content, const QSize& whole)
      : p(painter), c(content), axis(content.axis()), colours(content.palette), size(whole) {}

  void everything() {
    p.fillRect(QRect({}, size), colours.panel);
    p.setFont(interface_font(12));
    p.setClipRect(QRectF(0, c.lanes.top_px(), size.width(), c.lanes.bottom_px() - c.lanes.top_px()));
    names();
    paint_tier_names(p, c);
    p.setClipRect(lanes_area());
    sources();
    blocks(TimelineLane::Moves, c.tracks.moves());
    blocks(TimelineLane::Role, c.tracks.leaders());
    curve(TimelineLane::Cost, c.tracks.costs(), colours.user);
    curve(TimelineLane::Energy, c.tracks.energies(), colours.energy_deformation);
    settings();
    takes();
    paint_tiers(p, c);
    p.setClipRect(QRectF(axis.left_px - 6, 0, axis.width_px + 12, c.lanes.bottom_px()));
    range();
    ruler();
    on_disk();
    evicted();
    live_end();
    markers();
    p.setClipping(false);
    if (c.focused) focus();
  }

 private:
  QRectF lanes_area() const {
    return {axis.left_px, c.lanes.top_px(), axis.width_px, c.lanes.bottom_px() - c.lanes.top_px()};
  }
  QRectF lane(TimelineLane which) const {
    return {axis.left_px, c.lanes.top_of(which), axis.width_px, info_of(which).height_px};
  }
  bool shows(TimelineLane which) const {
    const QRectF area = lane(which);
    return c.lanes.is_shown(which) && area.bottom() > c.lanes.top_px() && area.top() < c.lanes.bottom_px();
  }
  QRectF block(const TimelineTracks::Interval& interval, TimelineLane which) const {
    const double left = std::max(axis.x(interval.from_s), axis.left_px);
    const double right = std::min(axis.x(interval.to_s), axis.right_px());
    return {left, lane(which).top() + 3, std::max(0.0, right - left), info_of(which).height_px - 6};
  }
  TimelineTracks::Lane in_view(const TimelineTracks::Lane& lane) const {
    return drawn(lane, axis.first_s, axis.last_s(), axis.seconds_per_pixel());
  }

  void names() {
    p.setPen(colours.secondary);
    for (int i = 0; i < timeline_lane_count; ++i) {
      const auto which = static_cast<TimelineLane>(i);
      if (!shows(which)) continue;
      const QRectF area(names_left, lane(which).top(), axis.left_px - names_left - 8, lane(which).height());
      p.drawText(area, Qt::AlignVCenter, text(info_of(which).name));
    }
  }

  void ruler() {
    const double step = axis.tick_s(tick_apart);
    const QColor line = mixed(colours.secondary, colours.panel, 0.55);
    for (const double tick : axis.ticks(tick_apart)) {
      const double x = std::round(axis.x(tick)) + 0.5;
      p.setPen(line);
      p.drawLine(QPointF(x, 4), QPointF(x, TimelineLanes::ruler_px - 2));
      if (tick < -1e-9) continue;
      p.setPen(colours.secondary);
      const QString label = tick_text(tick, step);
      if (x + 5 + tabular_width(p.font(), label) < size.width())
        draw_tabular(p, QRectF(x + 5, 2, 80, TimelineLanes::ruler_px - 4), Qt::AlignLeft, label);
    }
  }

  void sources() {
    if (!shows(TimelineLane::Source)) return;
    for (const auto& interval : in_view(c.tracks.sources())) {
      if (interval.key < 0) continue;
      QRectF area = block(interval, TimelineLane::Source);
      const QColor colour = take_colour(colours, interval.key);
      constexpr double rounded_from = 5;
      if (area.width() < rounded_from) {
        area.setWidth(std::max(1.0, area.width() - 0.5));
        p.fillRect(area, colour);
        continue;
      }
      p.setPen(Qt::NoPen);
      p.setBrush(colour);
      p.setRenderHint(QPainter::Antialiasing);
      p.drawRoundedRect(area.adjusted(0.5, 0, -0.5, 0), 2, 2);
      p.setRenderHint(QPainter::Antialiasing, false);
      source_text(interval, area.adjusted(5, 0, -3, 0));
    }
  }

  /// The take, and the frame that the interval begins with where it fits.
  void source_text(const TimelineTracks::Interval& interval, const QRectF& area) {
    if (!c.library) return;
    const QString take =
        text(short_take_name(c.library->takes()[static_cast<std::size_t>(interval.key)].name));
    const double take_width = tabular_width(p.font(), take);
    if (area.width() < take_width) return;
    const QColor ink = colours.dark ? QColor("#e6e9ee") : colours.text;
    p.setPen(ink);
    draw_tabular(p, area, Qt::AlignLeft, take);
    const int pair = c.tracks.pair_at(std::max(interval.from_s, axis.first_s) + 1e-9);
    if (pair < 0 || pair >= c.library->pair_count()) return;
    const QString frame = QString::number(c.library->source(pair).frame);
    constexpr double apart = 6;
    if (area.width() < take_width + apart + tabular_width(p.font(), frame)) return;
    p.setPen(mixed(ink, take_colour(colours, interval.key), 0.72));
    draw_tabular(p, area.adjusted(take_width + apart, 0, 0, 0), Qt::AlignLeft, frame);
  }

  struct Look {
    QColor edge, fill;
    QString name;
  };
  Look look_of(TimelineLane which, int key) const {
    Look look;
    if (which == TimelineLane::Role) {
      const bool user = key == static_cast<int>(Leader::User);
      look.edge = user ? colours.active : colours.passive;
      look.name = user ? "user leads" : "partner leads";
    } else {
      look.edge = label_colour(colours, key < 0 ? std::string_view() : c.tracks.label(key));
      if (key >= 0) look.name = text(c.tracks.label(key)).replace('_', ' ');
    }
    look.fill = mixed(look.edge, colours.panel, colours.dark ? 0.26 : 0.20);
    return look;
  }

  void blocks(TimelineLane which, const TimelineTracks::Lane& intervals) {
    if (!shows(which)) return;
    std::map<int, Look> looks;  // there are few, and many blocks
    for (const auto& interval : in_view(intervals)) {
      const QRectF area = block(interval, which);
      const auto known = looks.find(interval.key);
      const Look& look =
          known != looks.end() ? known->second : looks[interval.key] = look_of(which, interval.key);
      constexpr double edge_px = 2.5, filled_from = 1.5;
      if (area.width() > filled_from) p.fillRect(area, look.fill);
      p.fillRect(QRectF(area.left(), area.top(), std::clamp(area.width(), 1.0, edge_px), area.height()),
                 look.edge);
      constexpr double no_letter = 20;
      if (look.name.isEmpty() || area.width() < no_letter) continue;
      const QString fitting =
          p.fontMetrics().elidedText(look.name, Qt::ElideRight, static_cast<int>(area.width()) - 12);
      constexpr int readable = 6;  // fewer letters of a name are useless
      if (fitting != look.name && fitting.size() < readable) continue;
      p.setPen(colours.text);
      p.drawText(area.adjusted(8, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, fitting);
    }
  }

  void curve(TimelineLane which, const SampleCurve& samples, const QColor& colour) {
    if (!shows(which)) return;
    const double scale = p.device()->devicePixelRatioF();
    const QRectF area = lane(which).adjusted(0, 3, 0, -2);
    auto columns = samples.columns(axis.first_s, axis.last_s(), static_cast<int>(axis.width_px * scale));
    const double upper = usual_upper(columns);
    if (!(upper > 0)) return;
    const double seconds_per_column = axis.seconds_per_pixel() / scale;
    bridge_columns(columns, [&](std::size_t first, std::size_t end) {
      return c.tracks.has_gap_of_curves(axis.first_s + static_cast<double>(first) * seconds_per_column,
                                        axis.first_s + static_cast<double>(end) * seconds_per_column);
    });
    QImage line = curve_picture(columns, upper, static_cast<int>(area.height() * scale), 1.2 * scale, colour);
    line.setDevicePixelRatio(scale);
    p.drawImage(area.topLeft(), line);
  }

  void settings() {
    if (!shows(TimelineLane::Settings)) return;
    const QRectF area = lane(TimelineLane::Settings);
    const auto& marks = c.settings_marks;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const double x = axis.x(marks[i].time_s), until = axis.x(marks[i].until_s);
      const double next = i + 1 < marks.size() ? axis.x(marks[i + 1].time_s) : axis.right_px();
      if (next < axis.left_px || x > axis.right_px()) continue;
      const QColor tick = mixed(colours.warning, colours.panel, 0.85);
      p.fillRect(QRectF(x - 1, area.top() + 3, std::max(2.0, until - x), area.height() - 6),
                 until - x > 3 ? mixed(tick, colours.panel, 0.4) : tick);
      p.fillRect(QRectF(x - 1, area.top() + 3, 2, area.height() - 6), tick);
      const double left = std::max(x, until) + 5;
      const QString change = text(marks[i].text);
      const QString fitting =
          p.fontMetrics().elidedText(change, Qt::ElideRight, static_cast<int>(next - left) - 6);
      constexpr int readable = 5;
      if (fitting != change && fitting.size() < readable) continue;
      p.setPen(colours.secondary);
      p.drawText(QRectF(left, area.top(), next - left, area.height()), Qt::AlignVCenter, fitting);
    }
  }

  void range() {
    const auto between = c.playback.range();
    if (!between) return;
    const double in = axis.x(between->from_s), out = axis.x(between->to_s);
    const QRectF whole(in, 0, out - in, TimelineLanes::ruler_px);
    QColor shade = colours.accent;
    shade.setAlphaF(colour_part(c.playback.loop ? 0.42 : 0.28));
    p.fillRect(whole & QRectF(axis.left_px, 0, axis.width_px, TimelineLanes::ruler_px), shade);
    shade.setAlphaF(colour_part(0.07));
    p.fillRect(QRectF(in, c.lanes.top_px(), out - in, c.lanes.bottom_px() - c.lanes.top_px()) & lanes_area(),
               shade);
    for (const double x : {in, out}) {
      if (x < axis.left_px - 4 || x > axis.right_px() + 4) continue;
      p.fillRect(QRectF(x - 1, 1, 2, TimelineLanes::ruler_px), mixed(colours.accent, colours.text, 0.75));
      const double grip = x == in ? x : x - 5;
      p.fillRect(QRectF(grip, 1, 5, 7), mixed(colours.accent, colours.text, 0.75));
    }
  }

  void takes() {
    if (!shows(TimelineLane::Takes)) return;
    const QRectF row = lane(TimelineLane::Takes);
    for (const TimelineTake& take : c.takes) {
      const double end_s = take.is_running ? c.playback.last_s : take.to_s;
      const double left = std::max(axis.x(take.from_s), axis.left_px);
      const double right = std::min(axis.x(end_s), axis.right_px());
      if (right < left) continue;
      const QRectF area(left, row.top() + 3, std::max(2.0, right - left), row.height() - 6);
      const QColor ink = take.is_running ? colours.live : mixed(colours.text, colours.panel, 0.7);
      p.fillRect(area, mixed(ink, colours.panel, take.is_running ? 0.5 : 0.22));
      p.fillRect(QRectF(area.topLeft(), QSizeF(2, area.height())), ink);
      const QString name = (take.is_running ? "● " : "") + text(take.name);
      const QString fitting =
          p.fontMetrics().elidedText(name, Qt::ElideRight, static_cast<int>(area.width()) - 10);
      constexpr int readable = 5;
      if (fitting != name && fitting.size() < readable) continue;
      p.setPen(colours.text);
      p.drawText(area.adjusted(7, -3, 0, 3), Qt::AlignVCenter, fitting);
    }
  }

  /// Frames that memory no longer has but the session file does: they can be gone to like any other.
  void on_disk() {
    if (c.lanes.is_of_take()) return;
    const double end = std::min(axis.x(std::min(c.memory_first_s, c.playback.last_s)), axis.right_px());
    const double begin = std::max(axis.x(c.playback.first_s), axis.left_px);
    if (end - begin < 1) return;
    QColor shade = colours.secondary;
    shade.setAlphaF(colour_part(0.10));
    p.fillRect(QRectF(begin, 0, end - begin, TimelineLanes::ruler_px), shade);
    p.fillRect(QRectF(begin, TimelineLanes::ruler_px - 1, end - begin, 1.5),
               mixed(colours.secondary, colours.panel, 0.7));
  }

  void evicted() {
    const double end = std::min(axis.x(c.playback.first_s), axis.right_px());
    const double begin = std::max(axis.x(0), axis.left_px);
    if (end - begin < 1 || c.playback.first_s <= 0.5) return;
    p.fillRect(QRectF(begin, 0, end - begin, c.lanes.bottom_px()),
               QBrush(mixed(colours.secondary, colours.panel, 0.45), Qt::BDiagPattern));
    if (c.lost.isEmpty() || c.lanes.is_of_take()) return;
    p.save();
    p.setFont(interface_font(11, QFont::DemiBold));
    const double wide = p.fontMetrics().horizontalAdvance(c.lost) + 14, high = 20;
    const double left = wide < end - begin ? end - wide : begin;
    const QRectF label(left, c.lanes.bottom_px() - high - 4, wide, high);
    p.fillRect(label, colours.panel);
    p.fillRect(QRectF(end - 1, 4, 1.5, c.lanes.bottom_px() - 4), colours.warning);
    p.setPen(colours.warning);
    p.drawText(label, Qt::AlignCenter, c.lost);
    p.restore();
  }

  void live_end() {
    const double x = std::round(axis.x(c.playback.last_s));
    if (c.playback.last_s <= 0 || x < axis.left_px || x > axis.right_px()) return;
    const QColor line = c.playback.is_live ? colours.live : colours.secondary;
    p.fillRect(QRectF(x, 4, 1.5, c.lanes.bottom_px() - 4), mixed(line, colours.panel, 0.8));
  }

  void markers() {
    for (const Marker& marker : c.markers.all()) {
      const double x = std::round(axis.x(marker.time_s));
      if (x < axis.left_px - 1 || x > axis.right_px() + 1) continue;
      const bool chosen = marker.id == c.selected_marker;
      const QColor ink = chosen ? mixed(colours.accent, colours.text, 0.6) : colours.secondary;
      QColor line = ink;
      line.setAlphaF(colour_part(chosen ? 0.9 : 0.4));
      p.fillRect(QRectF(x, TimelineLanes::ruler_px, 1, c.lanes.bottom_px() - TimelineLanes::ruler_px), line);
      p.setRenderHint(QPainter::Antialiasing);
      p.setPen(Qt::NoPen);
      p.setBrush(ink);
      const double y = TimelineLanes::ruler_px;
      p.drawPolygon(QPolygonF({{x - 4, y - 6}, {x + 5, y - 6}, {x + 0.5, y + 1}}));
      p.setRenderHint(QPainter::Antialiasing, false);
      if (shows(TimelineLane::Markers)) flag(marker, x, ink, chosen);
    }
  }

  void flag(const Marker& marker, double x, const QColor& ink, bool chosen) {
    const QRectF area = lane(TimelineLane::Markers);
    if (area.bottom() > c.lanes.bottom_px() + 4) return;
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(Qt::NoPen);
    p.setBrush(ink);
    const double y = area.top() + 4;
    p.drawPolygon(QPolygonF({{x, y}, {x + 10, y}, {x + 7, y + 4.5}, {x + 10, y + 9}, {x, y + 9}}));
    p.setRenderHint(QPainter::Antialiasing, false);
    const Marker* next = c.markers.after(marker.time_s, 0);
    const double room = (next ? axis.x(next->time_s) : axis.right_px()) - x - 20;
    const QString title = text(marker_title(marker));
    const QString fitting = p.fontMetrics().elidedText(title, Qt::ElideRight, static_cast<int>(room));
    p.setPen(chosen ? colours.text : colours.secondary);
    if (room > 8) p.drawText(QRectF(x + 14, area.top(), room, area.height() - 2), Qt::AlignVCenter, fitting);
  }

  void focus() {
    p.setPen(QPen(colours.accent, 1));
    p.setBrush(Qt::NoBrush);
    p.drawRect(QRectF(0.5, 0.5, size.width() - 1, size.height() - 1));
  }

  QPainter& p;
  const TimelineContent& c;
  const TimelineAxis& axis;
  const Palette& colours;
  const QSize size;
};

}  // namespace

void paint_timeline(QPainter& painter, const TimelineContent& content, const QSize& size) {
  Painting(painter, content, size).everything();
}

void paint_timeline_cursor(QPainter& painter, const TimelineContent& content, const QSize&) {
  const TimelineAxis& axis = content.axis();
  const double x = std::round(axis.x(content.playback.cursor_s)) + 0.5;
  if (x < axis.left_px - 1 || x > axis.right_px() + 1) return;
  const QColor ink = content.palette.dark ? QColor(Qt::white) : content.palette.text;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(ink, 1.6));
  painter.drawLine(QPointF(x, 5), QPointF(x, content.lanes.bottom_px()));
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  painter.drawPolygon(QPolygonF({{x - 5, 0}, {x + 5, 0}, {x, 7}}));
}

void paint_timeline_overview(QPainter& painter, const TimelineContent& content, const QSize& size) {
  if (!content.viewport.is_partial()) return;
  const TimelineAxis& axis = content.axis();
  const Palette& colours = content.palette;
  const TimelineAxis whole = content.viewport.whole();
  const QRectF bar(axis.left_px, content.lanes.bottom_px() + 4, axis.width_px,
                   size.height() - content.lanes.bottom_px() - 7);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colours.raised);
  painter.drawRoundedRect(bar, 3, 3);
  painter.setClipRect(bar.adjusted(0, -1, 1, 1));
  if (const auto range = content.playback.range()) {
    QColor shade = colours.accent;
    shade.setAlphaF(colour_part(0.45));
    painter.fillRect(QRectF(whole.x(range->from_s), bar.top(), whole.x(range->to_s) - whole.x(range->from_s),
                            bar.height()),
                     shade);
  }
  constexpr double least_px = 8;
  const double left = std::max(whole.x(axis.first_s), bar.left()),
               right = std::min(whole.x(axis.last_s()), bar.right());
  const double width = std::max(least_px, right - left);
  painter.setBrush(mixed(colours.secondary, colours.panel, 0.55));
  painter.drawRoundedRect(QRectF(std::min(left, bar.right() - width), bar.top(), width, bar.height()), 3, 3);
  for (const Marker& marker : content.markers.all())
    painter.fillRect(QRectF(whole.x(marker.time_s), bar.top(), 1, bar.height()), colours.secondary);
  painter.fillRect(QRectF(whole.x(content.playback.cursor_s) - 0.75, bar.top() - 1, 1.5, bar.height() + 2),
                   colours.dark ? QColor(Qt::white) : colours.text);
  painter.setClipping(false);
}

}  // namespace abrazo::widgets

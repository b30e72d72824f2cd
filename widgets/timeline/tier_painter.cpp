#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/session/frames/time_place.hpp"
#include "widgets/common/qt_versions.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/common/value_look.hpp"
#include "widgets/timeline/timeline_content.hpp"

namespace abrazo::widgets {
namespace {

constexpr double tier_names_left = 14, text_left = 8;
constexpr double no_letter_px = 20;
constexpr int readable = 4;  // fewer letters of a name are useless

class TierPainting {
 public:
  TierPainting(QPainter& painter, const TimelineContent& content)
      : p(painter), c(content), axis(content.axis()), colours(content.palette), tiers(content.tiers) {}

  void names() {
    for (const TierLane& lane : c.lanes.tiers()) {
      if (!shows(lane)) continue;
      const QRectF area(0, c.lanes.top_of_tier(lane.tier), axis.left_px - 6, TimelineLanes::tier_px);
      const bool active = lane.tier == tiers.active_tier;
      if (active) {
        p.fillRect(area.adjusted(6, 2, 0, -2), colours.raised);
        p.fillRect(QRectF(area.left() + 6, area.top() + 2, 2.5, area.height() - 4), colours.accent.lighter());
      }
      p.setFont(interface_font(12, active ? QFont::DemiBold : QFont::Normal));
      p.setPen(active ? colours.text : colours.secondary);
      const QRectF name = area.adjusted(tier_names_left, 0, -4, 0);
      p.drawText(name, Qt::AlignVCenter,
                 p.fontMetrics().elidedText(text(lane.name), Qt::ElideRight, static_cast<int>(name.width())));
    }
    p.setFont(interface_font(12));
  }

  void lanes() {
    for (const TierLane& lane : c.lanes.tiers()) {
      const AnnotationTier* tier = tiers.shown().tier(lane.tier);
      if (!tier || !shows(lane)) continue;
      const double top = c.lanes.top_of_tier(tier->id);
      QColor ground = colours.raised;
      ground.setAlphaF(colour_part(tier->id == tiers.active_tier ? 0.55 : 0.28));
      p.fillRect(QRectF(axis.left_px, top + 2, axis.width_px, TimelineLanes::tier_px - 4), ground);
      for (const Suggestion& suggestion : tiers.shown().suggestions())
        if (suggestion.tier == tier->id) suggested(*tier, suggestion);
      for (const Annotation& annotation : tier->annotations) confirmed(*tier, annotation);
      drawn_anew(*tier);
    }
    snap_line();
  }

  void running() {
    for (const RunningLabel& label : tiers.running) {
      const AnnotationTier* tier = tiers.annotations.tier(label.tier);
      if (!tier) continue;
      const QRectF area = block(tier->id, std::min(label.from_s, c.playback.cursor_s),
                                std::max(label.from_s, c.playback.cursor_s));
      const QColor ink = value_colour(colours, *tier, label.value);
      p.fillRect(area, mixed(ink, colours.panel, 0.5));
      p.fillRect(QRectF(area.topLeft(), QSizeF(2.5, area.height())), ink);
      words("● " + value_words(*tier, label.value), area, colours.text);
    }
  }

 private:
  bool shows(const TierLane& lane) const {
    const double top = c.lanes.top_of_tier(lane.tier);
    return c.lanes.is_shown(lane) && top + TimelineLanes::tier_px > c.lanes.top_px() &&
           top < c.lanes.bottom_px();
  }
  QRectF block(int tier, double from_s, double to_s) const {
    const double left = std::max(axis.x(from_s), axis.left_px - 4);
    const double right = std::min(axis.x(to_s), axis.right_px() + 4);
    return {left, c.lanes.top_of_tier(tier) + 3, std::max(0.0, right - left), TimelineLanes::tier_px - 6};
  }
  bool in_view(double from_s, double to_s) const { return to_s >= axis.first_s && from_s <= axis.last_s(); }

  void words(const QString& whole, const QRectF& area, const QColor& ink) {
    if (area.width() < no_letter_px) return;
    const QString fitting =
        p.fontMetrics().elidedText(whole, Qt::ElideRight, static_cast<int>(area.width() - text_left - 4));
    if (fitting != whole && fitting.size() < readable) return;
    p.setPen(ink);
    p.drawText(area.adjusted(text_left, 0, -2, 0), Qt::AlignVCenter | Qt::AlignLeft, fitting);
  }

  void confirmed(const AnnotationTier& tier, const Annotation& annotation) {
    if (!in_view(annotation.start_s, annotation.end_s)) return;
    QRectF area = block(tier.id, annotation.start_s, annotation.end_s);
    area.setWidth(std::max(1.0, area.width() - 1));
    const QColor ink = value_colour(colours, tier, annotation.value);
    const bool chosen = annotation.id == tiers.selected;
    p.fillRect(area, mixed(ink, colours.panel, chosen ? 0.52 : colours.dark ? 0.34 : 0.28));
    p.fillRect(QRectF(area.topLeft(), QSizeF(std::min(area.width(), 2.5), area.height())), ink);
    QString said = value_words(tier, annotation.value);
    if (said.isEmpty()) said = "?";
    if (!annotation.detail.empty()) said += " · " + text(annotation.detail);
    words(said, area, colours.text);
    if (!chosen) return;
    p.setPen(QPen(colours.dark ? QColor(Qt::white) : colours.text, 1.4));
    p.setBrush(Qt::NoBrush);
    p.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5));
  }

  void suggested(const AnnotationTier& tier, const Suggestion& suggestion) {
    if (!in_view(suggestion.start_s, suggestion.end_s)) return;
    const QRectF area = block(tier.id, suggestion.start_s, suggestion.end_s).adjusted(1, 1, -1, -1);
    const QColor ink = value_colour(colours, tier, suggestion.value);
    QColor hatch = ink;
    hatch.setAlphaF(colour_part(0.45));
    p.fillRect(area, QBrush(hatch, Qt::BDiagPattern));
    const bool chosen = suggestion.id == tiers.suggestion;
    p.setPen(QPen(chosen ? (colours.dark ? QColor(Qt::white) : colours.text) : ink, chosen ? 1.6 : 1,
                  Qt::DashLine));
    p.setBrush(Qt::NoBrush);
    p.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5));
    const QString said = QString("%1? %2 %")
                             .arg(value_words(tier, suggestion.value))
                             .arg(std::lround(100 * suggestion.confidence));
    p.setFont(italic());
    const double wide = std::min(area.width(), p.fontMetrics().horizontalAdvance(said) + 14.0);
    if (area.width() >= no_letter_px)
      p.fillRect(QRectF(area.left() + 4, area.top() + 3, wide - 8, area.height() - 6),
                 mixed(colours.panel, ink, 0.9));
    words(said, area, colours.secondary);
    p.setFont(interface_font(12));
  }
  static QFont italic() {
    QFont font = interface_font(12);
    font.setItalic(true);
    return font;
  }

  void drawn_anew(const AnnotationTier& tier) {
    if (!tiers.drag || tiers.drag->tier() != tier.id || !tiers.dragged.moved) return;
    const bool draws = tiers.drag->kind() == TierDrag::Kind::Draw;
    const bool refused = !tiers.dragged.refused.empty();
    if (!draws && !refused) return;
    const QRectF area = block(tier.id, tiers.dragged.from_s, tiers.dragged.to_s);
    const QColor ink = refused ? colours.live : colours.dark ? QColor(Qt::white) : colours.text;
    QColor fill = ink;
    fill.setAlphaF(colour_part(0.18));
    p.fillRect(area, fill);
    p.setPen(QPen(ink, 1.2, refused ? Qt::DashLine : Qt::SolidLine));
    p.setBrush(Qt::NoBrush);
    p.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5));
    words(QString("%1 s").arg(tiers.dragged.to_s - tiers.dragged.from_s, 0, 'f', 2), area, colours.text);
  }

  void snap_line() {
    if (!tiers.drag || !tiers.dragged.snapped_s) return;
    const double x = std::round(axis.x(*tiers.dragged.snapped_s)) + 0.5;
    p.setPen(QPen(colours.warning, 1, Qt::DashLine));
    p.drawLine(QPointF(x, c.lanes.top_px()), QPointF(x, c.lanes.bottom_px()));
  }

  QPainter& p;
  const TimelineContent& c;
  const TimelineAxis& axis;
  const Palette& colours;
  const TimelineTiers& tiers;
};

QString place_words(double time_s, double fps) {
  QString words = QString("%1 s").arg(time_s, 0, 'f', 3);
  if (fps > 0) words += QString(" (frame %1)").arg(std::lround(time_s * fps));
  return words;
}

}  // namespace

void paint_tier_names(QPainter& painter, const TimelineContent& content) {
  TierPainting(painter, content).names();
}

void paint_tiers(QPainter& painter, const TimelineContent& content) {
  TierPainting(painter, content).lanes();
}

void paint_running_labels(QPainter& painter, const TimelineContent& content) {
  if (content.tiers.running.empty()) return;
  const TimelineAxis& axis = content.axis();
  painter.save();
  painter.setFont(interface_font(12));
  painter.setClipRect(QRectF(axis.left_px, content.lanes.top_px(), axis.width_px,
                             content.lanes.bottom_px() - content.lanes.top_px()));
  TierPainting(painter, content).running();
  painter.restore();
}

QString tier_facts(const TimelineContent& content, const QPointF& place) {
  const int id = content.lanes.tier_at(place.y());
  const AnnotationTier* tier = content.tiers.annotations.tier(id);
  if (!tier) return {};
  const double time_s = content.axis().time(place.x());
  const double fps = content.tiers.rules.fps;
  if (const Annotation* annotation = tier->at(time_s)) {
    QString facts = "<b>" + value_words(*tier, annotation->value).toHtmlEscaped() + "</b>";
    if (!annotation->detail.empty()) facts += "<br>" + text(annotation->detail).toHtmlEscaped();
    if (!annotation->confidence.empty())
      facts += "<br>confidence: " + text(annotation->confidence).toHtmlEscaped();
    return facts + QString("<br>%1 to %2, %3 s")
                       .arg(place_words(annotation->start_s, fps), place_words(annotation->end_s, fps))
                       .arg(annotation->duration_s(), 0, 'f', 3);
  }
  for (const Suggestion& each : content.tiers.annotations.suggestions())
    if (each.tier == id && time_s >= each.start_s && time_s < each.end_s)
      return QString("<b>%1?</b> %2 %<br>%3<br>only suggested")
          .arg(value_words(*tier, each.value).toHtmlEscaped())
          .arg(std::lround(100 * each.confidence))
          .arg(text(each.reason).toHtmlEscaped());
  return "Drag to draw a label here";
}

}  // namespace abrazo::widgets

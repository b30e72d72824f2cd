#include "widgets/library/take_delegate.hpp"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QImage>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/common/plain_text.hpp"
#include "widgets/common/qt_versions.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/library/take_model.hpp"

namespace abrazo::widgets {
namespace {

constexpr int words_left = 56, right_margin = 12;
constexpr int strip_top = 40, strip_height = 7;
constexpr int role_height = 2, heat_height = 4;
constexpr int belief_top = 9, belief_height = 3, halo = 2;  ///< below the strip, in which the bars come first

/// As much as fits; the moves are also in the strip.
QString facts(const TakeRow& row, const QFont& font, double room) {
  const QString brief = QString("%1 frames · %2 s · %3")
                            .arg(row.frames)
                            .arg(row.seconds, 0, 'f', row.seconds < 100 ? 1 : 0)
                            .arg(QString::fromStdString(row.leader));
  const QString whole = brief + QString(" · %1 moves").arg(row.moves.size());
  return tabular_width(font, whole) <= room ? whole : brief;
}

/// Text of a row while its strip is browsed.
QString facts_at(const TakeRow& row, int frame) {
  QString words = QString("frame %1 · %2 s").arg(frame).arg(row.fps > 0 ? frame / row.fps : 0, 0, 'f', 2);
  const double place = frame / static_cast<double>(std::max(1, row.frames));
  for (const TakeRow::Move& move : row.moves)
    if (move.from <= place && place < move.to)
      words += " · " + QString::fromStdString(move.label).replace('_', ' ');
  return words;
}

}  // namespace

QRect take_strip(const QRect& row) {
  return {row.left() + words_left, row.top() + strip_top, row.width() - words_left - right_margin,
          strip_height};
}

int frame_at(const QRect& row, double x, int frames) {
  const QRect strip = take_strip(row);
  const double share = (x - strip.left()) / std::max(1, strip.width());
  return std::clamp(static_cast<int>(share * frames), 0, std::max(0, frames - 1));
}

TakeDelegate::TakeDelegate(const TakeModel& model, const TakeFilter& filter, QObject* parent)
    : QStyledItemDelegate(parent), m_model(model), m_filter(filter), m_palette(palette_of(Theme::Dark)) {}

QSize TakeDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
  return {200, take_row_height};
}

void TakeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  const int take = m_filter.takeAt(index);
  if (take < 0) return;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  paintGround(*painter, option, take);
  const double ratio = painter->device()->devicePixelRatioF();
  painter->drawPixmap(QPointF(option.rect.left() + 12, option.rect.top() + 7), m_model.picture(take, ratio));
  paintWords(*painter, option.rect, take);
  const QRect strip = take_strip(option.rect);
  painter->setRenderHint(QPainter::Antialiasing, false);
  paintStrip(*painter, strip, take);
  paintHeat(*painter, strip, take);
  paintBelief(*painter, strip, take);
  paintMarks(*painter, strip, take);
  painter->restore();
}

void TakeDelegate::paintGround(QPainter& painter, const QStyleOptionViewItem& option, int take) const {
  const QRect& row = option.rect;
  if (take == m_model.sourceTake()) {
    painter.fillRect(row, m_palette.raised);
    painter.fillRect(QRect(row.topLeft(), QSize(2, row.height())), m_palette.warning);
  } else if (option.state & QStyle::State_MouseOver) {
    painter.fillRect(row, mixed(m_palette.raised, m_palette.panel, 0.5));
  }
  if (!(option.state & QStyle::State_Selected)) return;
  painter.setPen(QPen(m_palette.accent, option.state & QStyle::State_HasFocus ? 2.0 : 1.2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(QRectF(row).adjusted(5, 1.5, -3, -1.5), 4, 4);
}

void TakeDelegate::paintWords(QPainter& painter, const QRect& row, int take) const {
  const TakeRow& about = m_model.row(take);
  const QRectF words(row.left() + words_left, row.top() + 4, row.width() - words_left - right_margin, 18);
  const TakeCoverage& coverage = m_model.coverage();
  const int times = coverage.times_selected(take);
  const QString state = m_model.isUsers(take)    ? QString("plays the user")
                        : m_model.isVetoed(take) ? QString("vetoed")
                        : times > 0 ? (coverage.is_estimated() ? "≈ " : "") + QString::number(times) + " ×"
                                    : QString();
  painter.setFont(interface_font(12));
  painter.setPen(m_model.isVetoed(take) ? m_palette.passive : m_palette.secondary);
  draw_tabular(painter, words, Qt::AlignRight, state);
  const double taken = state.isEmpty() ? 0 : tabular_width(painter.font(), state) + 8;
  painter.setFont(interface_font(13, QFont::DemiBold));
  painter.setPen(m_model.isVetoed(take) || m_model.isUsers(take) ? m_palette.secondary : m_palette.text);
  const auto name = painter.fontMetrics().elidedText(QString::fromStdString(about.name), Qt::ElideRight,
                                                     static_cast<int>(words.width() - taken));
  painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft, name);
  painter.setFont(interface_font(11));
  const bool looked_at = take == m_model.cursorTake();
  painter.setPen(looked_at ? m_palette.text : m_palette.secondary);
  const QString line =
      looked_at ? facts_at(about, m_model.cursorFrame()) : facts(about, painter.font(), words.width());
  draw_tabular(painter, words.translated(0, 16), Qt::AlignLeft,
               painter.fontMetrics().elidedText(line, Qt::ElideRight, static_cast<int>(words.width()) - 4));
}

void TakeDelegate::paintStrip(QPainter& painter, const QRect& strip, int take) const {
  const auto at = [&](double share) {
    return strip.left() + static_cast<int>(std::lround(share * strip.width()));
  };
  painter.fillRect(strip, mixed(m_palette.border, m_palette.panel, 0.7));
  for (const TakeRow::Move& move : m_model.row(take).moves) {
    const int from = at(move.from), width = std::max(1, at(move.to) - from);
    // The pixel that is left free parts two moves of one kind.
    painter.fillRect(QRect(from, strip.top(), width > 2 ? width - 1 : width, strip.height()),
                     label_colour(m_palette, move.label));
  }
  for (const TakeRow::Role& role : m_model.row(take).roles) {
    if (role.active == ActivePerformer::Unknown) continue;
    const int from = at(role.from), top = strip.top() - role_height - 1;
    const bool a = role.active == ActivePerformer::A;
    painter.fillRect(QRect(from, top, at(role.to) - from, role_height),
                     a ? m_palette.active : m_palette.passive);
  }
}

/// Amber bars, the higher the more often a part was selected; on a root scale, since one held pair would
/// flatten the rest.
void TakeDelegate::paintHeat(QPainter& painter, const QRect& strip, int take) const {
  const std::vector<int> heat = m_model.coverage().heat(take, strip.width() / 2);
  const int most = heat.empty() ? 0 : *std::max_element(heat.begin(), heat.end());
  const int top = strip.bottom() + 2;
  painter.fillRect(QRect(strip.left(), top + heat_height, strip.width(), 1), m_palette.border);
  for (std::size_t i = 0; i < heat.size(); ++i) {
    if (heat[i] == 0) continue;
    const double height = std::max(1.0, heat_height * std::sqrt(heat[i] / static_cast<double>(most)));
    painter.fillRect(
        QRectF(strip.left() + 2.0 * static_cast<double>(i), top + heat_height - height, 2, height + 1),
        m_palette.warning);
  }
}

/// A band of light, the stronger the likelier, with a faint halo that makes it seen among the bars.
void TakeDelegate::paintBelief(QPainter& painter, const QRect& strip, int take) const {
  const auto light = m_model.belief().along(take);
  if (std::all_of(light.begin(), light.end(), [](std::uint8_t level) { return level == 0; })) return;
  const QColor colour = m_palette.dark ? m_palette.accent.lighter(150) : m_palette.accent;
  QImage band(TakeBelief::parts, 1, QImage::Format_ARGB32_Premultiplied);
  for (int part = 0; part < TakeBelief::parts; ++part) {
    QColor here = colour;
    here.setAlphaF(colour_part(light[static_cast<std::size_t>(part)] / double{TakeBelief::levels}));
    band.setPixelColor(part, 0, here);
  }
  const QRect place(strip.left(), strip.bottom() + belief_top, strip.width(), belief_height);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setOpacity(0.3);
  painter.drawImage(place.adjusted(0, -halo, 0, halo), band);
  painter.setOpacity(1);
  painter.drawImage(place, band);
}

bool TakeDelegate::helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                             const QModelIndex& index) {
  const int take = m_filter.takeAt(index);
  const QRect strip = take_strip(option.rect).adjusted(0, -4, 0, belief_top + belief_height + halo);
  if (event->type() != QEvent::ToolTip || take < 0 || !strip.contains(event->pos()) ||
      !m_model.belief().is_any())
    return QStyledItemDelegate::helpEvent(event, view, option, index);
  const int frame = frame_at(option.rect, event->pos().x(), m_model.row(take).frames);
  QToolTip::showText(event->globalPos(), plain_tip(m_model.beliefText(take, frame)), view);
  return true;
}

void TakeDelegate::paintMarks(QPainter& painter, const QRect& strip, int take) const {
  const int frames = std::max(1, m_model.row(take).frames);
  const auto line = [&](int frame, const QColor& colour, int width) {
    const int x = strip.left() + static_cast<int>(static_cast<double>(frame) / frames * strip.width());
    painter.fillRect(QRect(x, strip.top() - 4, width, strip.height() + 10), colour);
  };
  if (take == m_model.sourceTake()) line(m_model.sourceFrame(), m_palette.text, 1);
  if (take == m_model.cursorTake()) line(m_model.cursorFrame(), m_palette.ghost_active, 2);
}

}  // namespace abrazo::widgets

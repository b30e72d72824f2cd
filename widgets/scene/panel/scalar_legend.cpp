#include "widgets/scene/panel/scalar_legend.hpp"

#include <QContextMenuEvent>
#include <QLinearGradient>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <optional>

#include "widgets/common/entry_frame.hpp"
#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/qt_versions.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int bar_width = 168, lock_size = 20;
constexpr int plain_height = 62, height_with_key = 80;
constexpr double ground_share = 0.8;  ///< of the scene's colour behind it

QToolButton* button(const QString& name, const QString& tip, QWidget* parent) {
  auto* made = new QToolButton(parent);
  made->setObjectName("flat");
  made->setAccessibleName(name);
  made->setToolTip(tip);
  made->setFocusPolicy(Qt::TabFocus);
  return made;
}

/// Asks for a range, below its corner.
class RangeEntry : public EntryFrame {
 public:
  static void open(QWidget& legend, const QString& prompt, const QString& start, Take take) {
    QWidget& window = *legend.window();
    for (auto* other : window.findChildren<EntryFrame*>()) delete other;
    auto* entry = new RangeEntry(window, prompt, start, std::move(take));
    entry->openAt(legend.mapTo(&window, QPoint(0, legend.height())));
  }

 protected:
  void settle() override {
    adjustSize();
    moveInside(corner());
  }

 private:
  RangeEntry(QWidget& window, const QString& prompt, const QString& start, Take take)
      : EntryFrame(window, prompt, start, std::move(take)) {}
};

/// Without an exponent where digits are as short: "1250", not "1.25e+03".
QString short_number(double value, int digits) {
  const bool is_long = std::abs(value) >= std::pow(10.0, digits) && std::abs(value) < 1e6;
  return QString::number(value, is_long ? 'f' : 'g', is_long ? 0 : digits);
}

struct TypedRange {
  double lower = 0, upper = 0;
};

/// "0.15", or "0.01 to 0.15" where the lower end can be set.
std::optional<TypedRange> typed_range(const QString& typed, bool has_lower) {
  const QStringList ends = QString(typed).replace(',', '.').split("to");
  if (ends.size() > (has_lower ? 2 : 1)) return std::nullopt;
  TypedRange range;
  bool is_upper = false, is_lower = true;
  range.upper = ends.back().trimmed().toDouble(&is_upper);
  if (ends.size() == 2) range.lower = ends.front().trimmed().toDouble(&is_lower);
  const bool is_range = is_upper && is_lower && std::isfinite(range.lower) && std::isfinite(range.upper) &&
                        range.upper > std::max(0.0, range.lower);
  return is_range ? std::optional(range) : std::nullopt;
}

QColor colour(const Colour& c) {
  return {c[0], c[1], c[2]};
}

}  // namespace

LegendScale scalar_legend(MeshScalar scalar, const ColourScale& scale, bool lacks_values) {
  const ScalarInfo info = scalar_info(scalar);
  const bool logs = scale.is_logarithmic && !scale.is_signed;
  QString unit = *info.unit ? QString(" [%1]").arg(info.unit) : QString();
  if (logs) unit += *info.unit ? " log" : " (log)";
  const auto number = [&scale](double share) {
    return scale.upper > 0 ? short_number(share * scale.upper, 3) : QString("–");
  };
  LegendScale legend{info.title + unit, "0", number(1), info.is_signed, scale.map, {}, lacks_values};
  legend.part = scale.part;
  legend.upper = scale.upper;
  legend.has_lower = !info.is_signed && !logs;
  legend.lower = legend.has_lower ? scale.lower : 0;
  if (legend.lower != 0) legend.low = short_number(legend.lower, 3);
  if (info.is_signed) {
    legend.low = "−" + number(1);
    legend.high = "+" + number(1);
  } else if (logs) {
    legend.low = "≤ " + number(std::pow(10.0, -ColourScale::decades));
    legend.middle = number(std::pow(10.0, -ColourScale::decades / 2));
  }
  return legend;
}

LegendScale volume_legend(double doublings) {
  const auto number = [doublings](double sign) {
    return doublings > 0 ? "× " + QString::number(std::exp2(sign * doublings), 'g', 2) : QString("–");
  };
  LegendScale legend{"Volume ratio (log)", number(-1), number(1), true, ColourMap::Viridis, "× 1"};
  legend.upper = doublings > 0 ? std::exp2(doublings) : 0;
  return legend;
}

ScalarLegend::ScalarLegend(QWidget* parent)
    : QWidget(parent),
      m_lock(button("Keep the range of colours", "Keep this range: do not adapt it to the frame", this)),
      m_more(button("Range and colour map",
                    "Range and colour map; a double click on the legend sets the range", this)) {
  setAccessibleName("Colour legend");
  setFixedSize(bar_width + 12, plain_height);
  m_lock->setCheckable(true);
  m_lock->setGeometry(width() - lock_size - 2, 40, lock_size, lock_size);
  m_more->setGeometry(width() - 2 * lock_size - 2, 40, lock_size, lock_size);
  connect(m_lock, &QToolButton::toggled, this, [this](bool locked) {
    dressButtons();
    emit lockToggled(locked);
  });
  connect(m_more, &QToolButton::clicked, this,
          [this] { showMenu(m_more->mapToGlobal(QPoint(0, m_more->height()))); });
  setColours(palette_of(Theme::Dark));
  m_lock->hide();  // there is no scale before the first frame
  show_under_pointer(*this, *m_more,
                     [this] { return !m_isPicture && (!m_scale.is_diverging || m_scale.upper > 0); });
}

void ScalarLegend::setColours(const Palette& palette) {
  m_palette = palette;
  dressButtons();
  update();
}

void ScalarLegend::dressButtons() {
  m_lock->setIcon(icon(m_lock->isChecked() ? Icon::Lock : Icon::Unlock,
                       m_lock->isChecked() ? m_palette.text : m_palette.secondary));
  m_more->setIcon(icon(Icon::More, m_palette.secondary));
}

void ScalarLegend::setLocked(bool locked) {
  const QSignalBlocker silent(m_lock);
  m_lock->setChecked(locked);
  dressButtons();
}

void ScalarLegend::becomePicture() {
  m_isPicture = true;
  m_lock->hide();
  m_more->hide();
  update();
}

void ScalarLegend::setMap(ColourMap map, bool logarithmic) {
  m_map = map;
  m_isLogarithmic = logarithmic;
}

void ScalarLegend::show(const LegendScale& scale) {
  if (scale == m_scale) return;
  m_scale = scale;
  m_lock->setVisible(!m_isPicture);
  setFixedHeight(scale.lacks_values ? height_with_key : plain_height);
  update();
}

void ScalarLegend::mouseDoubleClickEvent(QMouseEvent*) {
  askRange();
}

void ScalarLegend::askRange() {
  if (!(m_scale.upper > 0)) return;
  const QString upper = short_number(m_scale.upper, 4);
  // In the unit of the scale, whose numbers an example of another would contradict.
  const QString shown = m_scale.has_lower ? short_number(m_scale.lower, 4) + " to " + upper : upper;
  const auto take = [this, shown](const QString& typed) -> QString {
    const auto range = typed_range(typed, m_scale.has_lower);
    if (!range)
      return "'" + typed +
             (m_scale.has_lower
                  ? "' is not a range; write its upper end above 0, or both as in " + shown
                  : QString("' is not an end of a range; write a number above 0, both ends follow it"));
    setLocked(true);
    emit rangeRequested(range->lower, range->upper);
    return {};
  };
  RangeEntry::open(*this, (m_scale.has_lower ? "Range: " : "Upper end of the range: ") + m_scale.title, shown,
                   take);
}

void ScalarLegend::contextMenuEvent(QContextMenuEvent* event) {
  showMenu(event->globalPos());
}

void ScalarLegend::showMenu(const QPoint& global) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (m_scale.upper > 0) {
    menu->addAction("Set the range…", this, &ScalarLegend::askRange);
    menu->addSeparator();
  }
  const auto add = [&](const QString& name, bool ticked, ColourMap map, bool logarithmic) {
    QAction* action = menu->addAction(name);
    action->setCheckable(true);
    action->setChecked(ticked);
    connect(action, &QAction::triggered, this,
            [this, map, logarithmic] { emit mapRequested(map, logarithmic); });
  };
  if (m_scale.is_diverging) return menu->popup(global);  // a signed value has one map only
  add("Viridis", m_map == ColourMap::Viridis, ColourMap::Viridis, m_isLogarithmic);
  add("Cividis", m_map == ColourMap::Cividis, ColourMap::Cividis, m_isLogarithmic);
  menu->addSeparator();
  add("Logarithmic, two decades", m_isLogarithmic, m_map, !m_isLogarithmic);
  menu->popup(global);
}

void ScalarLegend::paintEvent(QPaintEvent*) {
  if (m_scale.title.isEmpty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  // Over a body the words would have little contrast.
  QColor ground = m_palette.scene_top;
  ground.setAlphaF(colour_part(ground_share));
  painter.setBrush(ground);
  painter.setPen(Qt::NoPen);
  painter.drawRoundedRect(rect(), 6, 6);
  const QRectF bar(width() - bar_width - 4, 26, bar_width, 8);
  painter.setFont(interface_font(13));
  painter.setPen(m_palette.text);
  painter.drawText(QRectF(0, 2, width() - 4, 20), Qt::AlignRight | Qt::AlignVCenter, m_scale.title);

  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  for (int stop = 0; stop <= 8; ++stop)
    gradient.setColorAt(
        stop / 8.0, colour(m_scale.is_diverging ? diverging_colour(stop / 8.0)
                                                : sequential_colour(stop / 8.0, m_scale.map, m_scale.part)));
  painter.setBrush(gradient);
  painter.setPen(Qt::NoPen);
  painter.drawRoundedRect(bar, 2, 2);

  painter.setFont(interface_font(12));
  painter.setPen(m_palette.secondary);
  const int buttons = m_isPicture ? 0 : !m_scale.is_diverging || m_scale.upper > 0 ? 2 : 1;
  const QRectF ends(bar.left(), 39, bar.width() - buttons * lock_size, 20);
  draw_tabular(painter, ends, Qt::AlignRight, m_scale.high);
  draw_tabular(painter, ends, Qt::AlignLeft, m_scale.low);
  if (!m_scale.middle.isEmpty())
    draw_tabular(painter, QRectF(bar.left(), 39, bar.width(), 20), Qt::AlignHCenter, m_scale.middle);
  if (!m_scale.lacks_values) return;
  painter.setBrush(colour(no_value_colour));
  painter.drawRoundedRect(QRectF(bar.left(), 65, 14, 8), 2, 2);
  painter.drawText(QRectF(bar.left() + 20, 60, 120, 18), Qt::AlignLeft | Qt::AlignVCenter, "no value");
}

}  // namespace abrazo::widgets

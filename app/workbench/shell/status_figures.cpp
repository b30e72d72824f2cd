#include "app/workbench/shell/status_figures.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/base/statistics.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::app {
namespace {

using widgets::UserInput;

constexpr std::size_t values_kept = 1200;  // ten seconds at 120 Hz

void keep_latest(std::vector<double>& values) {
  if (values.size() > values_kept)
    values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(values_kept));
}

QString hertz(double rate_hz) {
  return QString("%1 Hz").arg(rate_hz, 0, 'f', 0);
}

}  // namespace

StatusFigures::StatusFigures(QWidget* parent)
    : QWidget(parent), m_palette(widgets::palette_of(widgets::Theme::Dark)) {
  setFixedHeight(24);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  m_sinceRefresh.start();
}

void StatusFigures::setColours(const widgets::Palette& palette) {
  m_palette = palette;
  update();
}

void StatusFigures::setInput(const Input& input, int library_pairs) {
  showInput(input);
  m_pairs = library_pairs;
  m_nextIndex = 0;
  m_solve_us.clear();
  m_speed_m_s.clear();
  update();
}

void StatusFigures::showInput(const Input& input) {
  if (input == m_input) return;
  m_input = input;
  setToolTip(widgets::plain_tip(input.name));
  update();
}

QStringList StatusFigures::words() const {
  QStringList words{m_input.name};
  for (const auto* figures : {&m_left, &m_right})
    for (const Figure& figure : *figures) words << figure.name + " " + figure.value;
  return words;
}

void StatusFigures::refresh(const FrameHistory& history, std::uint64_t rendered_frames,
                            const std::optional<LiveLoop::ClipProgress>& clip) {
  if (clip && clip->run != m_run) m_nextIndex = 0;
  m_run = clip ? clip->run : 0;
  const double elapsed_s = static_cast<double>(m_sinceRefresh.restart()) / 1000;
  if (elapsed_s > 0) m_renderRate = static_cast<double>(rendered_frames - m_rendered) / elapsed_s;
  m_rendered = rendered_frames;
  FrameSnapshotPtr newest;
  for (const FrameSnapshotPtr& frame : history.next_since(m_nextIndex)) {
    newest = frame;
    m_nextIndex = frame->index + 1;
    m_solve_us.push_back(frame->result.timing.total_us);
    const double speed_m_s = m_series.read(*frame)[static_cast<std::size_t>(widgets::Series::PartnerSpeed)];
    if (std::isfinite(speed_m_s)) m_speed_m_s.push_back(speed_m_s);
  }
  keep_latest(m_solve_us);
  keep_latest(m_speed_m_s);
  const auto span = history.span();
  const auto ms = [this](double share) {
    return QString::number(percentile(m_solve_us, share) / 1000, 'f', 2);
  };
  const QString render = "render", rendered = QString("%1 fps").arg(m_renderRate, 0, 'f', 0);
  const QString in = m_isHeld ? "held" : hertz(m_input.from != UserInput::None ? m_input.rate_hz : 0);
  if (newest) {
    m_ok = newest->result.status != StepStatus::Failed;
    m_left = {{"in", in}, {"steps", hertz(newest->input_rate_hz)}};
    if (clip) m_left.clear();
    if (m_input.lost) m_left.push_back({"lost", QString::number(*m_input.lost)});
    m_left.insert(m_left.end(),
                  {{"solve", ms(0.5) + " ms"},
                   {"p99", ms(0.99) + " ms"},
                   {render, rendered},
                   {"partner p99", QString("%1 m/s").arg(percentile(m_speed_m_s, 0.99), 0, 'f', 1)}});
    if (newest->dropped_inputs > 0) m_left.push_back({"replaced", QString::number(newest->dropped_inputs)});
  } else {
    std::erase_if(m_left, [](const Figure& figure) { return figure.name == "solving"; });
    for (Figure& figure : m_left) {
      if (figure.name == "in") figure.value = m_isHeld ? in : hertz(0);
      if (figure.name == "steps") figure.value = hertz(0);
      if (figure.name == render) figure.value = rendered;
    }
  }
  if (clip && !clip->is_whole())
    m_left.insert(m_left.begin(), {"solving", QString("%1 of %2").arg(clip->solved).arg(clip->frames)});
  m_right = {{"library", QString("%L1 pairs").arg(m_pairs)},
             {clip ? "clip" : "history", QString("%1 s · %2 MB")
                                             .arg(span.last_s - span.first_s, 0, 'f', 0)
                                             .arg(static_cast<double>(span.bytes) / (1 << 20), 0, 'f', 0)}};
  update();
}

void StatusFigures::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QFont plain = widgets::interface_font(12), strong = widgets::interface_font(12, QFont::DemiBold);
  const auto draw = [&](double x, const QString& text, const QFont& font, const QColor& colour) {
    painter.setFont(font);
    painter.setPen(colour);
    widgets::draw_tabular(painter, QRectF(x, 0, width(), height()), Qt::AlignLeft, text);
    return widgets::tabular_width(font, text);
  };
  const auto wide = [&](const Figure& f) {
    return widgets::tabular_width(plain, f.name) + 5 + widgets::tabular_width(strong, f.value) + 18;
  };
  double right = width() - 14.0;
  // NOLINTNEXTLINE(modernize-loop-convert): clang 14 does not compile gcc 12's std::views::reverse
  for (auto figure = m_right.rbegin(); figure != m_right.rend(); ++figure) {
    double x = right - wide(*figure) + 18;
    right = x - 18;
    x += draw(x, figure->name, plain, m_palette.secondary) + 5;
    draw(x, figure->value, strong, m_palette.text);
  }
  // Green is a performer who is there; a clip always is.
  const QColor state = m_input.from == UserInput::None   ? m_palette.warning
                       : !m_ok                           ? m_palette.live
                       : m_input.from == UserInput::Clip ? m_palette.secondary
                                                         : m_palette.good;
  double x = 26;
  painter.setPen(Qt::NoPen);
  painter.setBrush(state);
  painter.drawEllipse(QPointF(16, height() / 2.0), 4, 4);
  // A long name leaves room for the figures; it is in the tooltip.
  const QString name = QFontMetricsF(plain).elidedText(m_input.name, Qt::ElideRight, width() / 3.0);
  x += draw(x, name, plain, state) + 22;
  for (const Figure& figure : m_left) {
    if (x + wide(figure) > right) break;  // rather nothing than two texts over one another
    const double after = x + wide(figure);
    x += draw(x, figure.name, plain, m_palette.secondary) + 5;
    draw(x, figure.value, strong, m_palette.text);
    x = after;
  }
}

}  // namespace abrazo::app

#include "widgets/scene/scene_overlay.hpp"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLinearGradient>
#include <QPainter>
#include <QToolButton>

#include "widgets/common/icons.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int bar_width = 168;
constexpr int lock_size = 20;

QToolButton* chip(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName("chip");
  button->setText(text);
  button->setToolTip(tip);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::NoFocus);
  button->setCursor(Qt::PointingHandCursor);
  return button;
}

}  // namespace

ScalarLegend::ScalarLegend(QWidget* parent) : QWidget(parent), m_lock(new QToolButton(this)) {
  setFixedSize(bar_width + 12, 62);
  m_lock->setObjectName("flat");
  m_lock->setCheckable(true);
  m_lock->setFocusPolicy(Qt::NoFocus);
  m_lock->setToolTip("Keep this range: do not adapt it to the frame");
  m_lock->setGeometry(width() - lock_size - 2, 40, lock_size, lock_size);
  connect(m_lock, &QToolButton::toggled, this, [this](bool locked) {
    dressLock();
    emit lockToggled(locked);
  });
  setColours(palette_of(Theme::Dark));
}

void ScalarLegend::setColours(const Palette& palette) {
  m_palette = palette;
  dressLock();
  update();
}

void ScalarLegend::dressLock() {
  m_lock->setIcon(icon(m_lock->isChecked() ? Icon::Lock : Icon::Unlock,
                       m_lock->isChecked() ? m_palette.text : m_palette.secondary));
}

bool ScalarLegend::isLocked() const {
  return m_lock->isChecked();
}

void ScalarLegend::show(MeshScalar scalar, double upper) {
  if (scalar == m_scalar && upper == m_upper) return;
  m_scalar = scalar;
  m_upper = upper;
  update();
}

void ScalarLegend::paintEvent(QPaintEvent*) {
  const ScalarInfo info = scalar_info(m_scalar);
  QPainter painter(this);
  const QRectF bar(width() - bar_width - 4, 26, bar_width, 8);
  painter.setFont(interface_font(13));
  painter.setPen(m_palette.text);
  const QString unit = *info.unit ? QString(" [%1]").arg(info.unit) : QString();
  painter.drawText(QRectF(0, 2, width() - 4, 20), Qt::AlignRight | Qt::AlignVCenter, info.title + unit);

  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  for (int stop = 0; stop <= 8; ++stop) {
    const auto [r, g, b] = info.is_signed ? diverging_colour(stop / 8.0) : sequential_colour(stop / 8.0);
    gradient.setColorAt(stop / 8.0, QColor(r, g, b));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(gradient);
  painter.setPen(Qt::NoPen);
  painter.drawRoundedRect(bar, 2, 2);

  painter.setFont(interface_font(12));
  painter.setPen(m_palette.secondary);
  const QString upper = m_upper > 0 ? QString::number(m_upper, 'g', 3) : QString("–");
  const QRectF ends(bar.left(), 39, bar.width() - lock_size, 20);
  draw_tabular(painter, ends, Qt::AlignRight, info.is_signed ? "+" + upper : upper);
  draw_tabular(painter, ends, Qt::AlignLeft, info.is_signed ? "−" + upper : QString("0"));
}

ScalarChips::ScalarChips(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  auto* group = new QButtonGroup(this);
  const std::array<std::array<const char*, 2>, 3> texts = {
      {{"Residual",
        "How far each neighbourhood is bent from the selected pair: |δ − L(v′)|, mean of an edge's ends"},
       {"Weight",
        "Share of an edge in the Laplacian coordinates of its ends: inverse of the recorded distance"},
       {"Length change", "Length in the result less length in the selected pair"}}};
  for (std::size_t s = 0; s < texts.size(); ++s) {
    m_scalars[s] = chip(texts[s][0], texts[s][1], this);
    group->addButton(m_scalars[s]);
    row->addWidget(m_scalars[s]);
    connect(m_scalars[s], &QToolButton::clicked, this,
            [this, s] { emit scalarChosen(static_cast<MeshScalar>(s)); });
  }
  m_scalars[0]->setChecked(true);
  m_betweenOnly = chip("Inter-body only", "Show only the edges between the two bodies", this);
  row->addWidget(m_betweenOnly);
  connect(m_betweenOnly, &QToolButton::clicked, this, &ScalarChips::betweenOnlyChosen);
}

void ScalarChips::setScalar(MeshScalar scalar) {
  m_scalars[static_cast<std::size_t>(scalar)]->setChecked(true);
}
void ScalarChips::setBetweenOnly(bool only) {
  m_betweenOnly->setChecked(only);
}

FrameFacts::FrameFacts(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFixedHeight(60);
  setColours(palette_of(Theme::Dark));
}

void FrameFacts::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void FrameFacts::show(const QString& first, const QString& second, const QString& trouble) {
  if (first == m_first && second == m_second && trouble == m_trouble) return;
  m_first = first;
  m_second = second;
  m_trouble = trouble;
  update();
}

void FrameFacts::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(interface_font(13));
  painter.setPen(m_palette.dark ? mixed(m_palette.text, m_palette.secondary, 0.5) : m_palette.secondary);
  draw_tabular(painter, QRectF(0, 20, width(), 18), Qt::AlignLeft, m_first);
  draw_tabular(painter, QRectF(0, 38, width(), 18), Qt::AlignLeft, m_second);
  painter.setPen(m_palette.warning);
  const QString fitting = painter.fontMetrics().elidedText(m_trouble, Qt::ElideRight, width() - 8);
  painter.drawText(QRectF(0, 2, width(), 18), Qt::AlignLeft | Qt::AlignVCenter, fitting);
}

}  // namespace abrazo::widgets

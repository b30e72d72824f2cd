#include "widgets/scene/scene_overlay.hpp"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLinearGradient>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <cmath>

#include "widgets/common/icons.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/scene/scene_options_panel.hpp"

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

LegendScale scalar_legend(MeshScalar scalar, double upper) {
  const ScalarInfo info = scalar_info(scalar);
  const QString unit = *info.unit ? QString(" [%1]").arg(info.unit) : QString();
  const QString number = upper > 0 ? QString::number(upper, 'g', 3) : QString("–");
  return {info.title + unit, info.is_signed ? "−" + number : QString("0"),
          info.is_signed ? "+" + number : number, info.is_signed};
}

LegendScale volume_legend(double doublings) {
  const auto number = [doublings](double sign) {
    return doublings > 0 ? "× " + QString::number(std::exp2(sign * doublings), 'g', 2) : QString("–");
  };
  return {"Volume ratio (log)", number(-1), number(1), true};
}

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

void ScalarLegend::setLocked(bool locked) {
  const QSignalBlocker silent(m_lock);
  m_lock->setChecked(locked);
  dressLock();
}

void ScalarLegend::show(const LegendScale& scale) {
  if (scale == m_scale) return;
  m_scale = scale;
  update();
}

void ScalarLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRectF bar(width() - bar_width - 4, 26, bar_width, 8);
  painter.setFont(interface_font(13));
  painter.setPen(m_palette.text);
  painter.drawText(QRectF(0, 2, width() - 4, 20), Qt::AlignRight | Qt::AlignVCenter, m_scale.title);

  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  for (int stop = 0; stop <= 8; ++stop) {
    const auto [r, g, b] =
        m_scale.is_diverging ? diverging_colour(stop / 8.0) : sequential_colour(stop / 8.0);
    gradient.setColorAt(stop / 8.0, QColor(r, g, b));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(gradient);
  painter.setPen(Qt::NoPen);
  painter.drawRoundedRect(bar, 2, 2);

  painter.setFont(interface_font(12));
  painter.setPen(m_palette.secondary);
  const QRectF ends(bar.left(), 39, bar.width() - lock_size, 20);
  draw_tabular(painter, ends, Qt::AlignRight, m_scale.high);
  draw_tabular(painter, ends, Qt::AlignLeft, m_scale.low);
}

ScalarChips::ScalarChips(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  auto* group = new QButtonGroup(this);
  const std::array<std::array<const char*, 2>, mesh_scalar_count> texts = {
      {{"Residual",
        "How far each neighbourhood is bent from the selected pair: |δ − L(v′)|, mean of an edge's ends"},
       {"Weight",
        "Share of an edge in the Laplacian coordinates of its ends: inverse of the recorded distance"},
       {"Length change", "Length in the result less length in the selected pair"},
       {"Energy",
        "Share of the deformation energy E_L (Eq. 11): what each vertex has, split among its edges by "
        "weight; "
        "all edges add up to 100 %"}}};
  for (std::size_t s = 0; s < texts.size(); ++s) {
    m_scalars[s] = chip(texts[s][0], texts[s][1], this);
    group->addButton(m_scalars[s]);
    row->addWidget(m_scalars[s]);
    connect(m_scalars[s], &QToolButton::clicked, this,
            [this, s] { emit scalarChosen(static_cast<MeshScalar>(s)); });
  }
  m_scalars[0]->setChecked(true);
  m_cells =
      chip("Volume ratio",
           "Tetrahedra of the mesh, coloured by their volume in the result over that in the selected pair; "
           "magenta with a rim: turned over",
           this);
  row->addWidget(m_cells);
  connect(m_cells, &QToolButton::clicked, this, &ScalarChips::cellsChosen);
  m_betweenOnly = chip("Inter-body only", "Show only the edges between the two bodies", this);
  row->addWidget(m_betweenOnly);
  connect(m_betweenOnly, &QToolButton::clicked, this, &ScalarChips::betweenOnlyChosen);
  m_filter = chip("Filter…", "Edges by length or at one joint, tetrahedra apart, cutting plane", this);
  row->addWidget(m_filter);
  m_options = new SceneOptionsPanel(this);
  connect(m_options, &SceneOptionsPanel::optionsRequested, this, &ScalarChips::optionsRequested);
  connect(m_filter, &QToolButton::clicked, this, [this] {
    setOptions(m_shown);  // a click must not leave the chip checked: it says that something is filtered
    m_options->move(m_filter->mapToGlobal({0, m_filter->height() + 4}));
    m_options->show();
  });
}

void ScalarChips::setScalar(MeshScalar scalar) {
  m_scalars[static_cast<std::size_t>(scalar)]->setChecked(true);
}
void ScalarChips::setBetweenOnly(bool only) {
  m_betweenOnly->setChecked(only);
}

void ScalarChips::setCells(bool shown) {
  m_cells->setChecked(shown);
}

void ScalarChips::setOptions(const SceneOptions& options) {
  m_shown = options;
  m_options->setOptions(options);
  m_filter->setChecked(options.shortest_m > 0 || options.longest_m < MeshFilter::no_limit ||
                       options.picked_joint_only || options.apart > 0 || options.cuts);
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

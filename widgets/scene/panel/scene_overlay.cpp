#include "widgets/scene/panel/scene_overlay.hpp"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include "widgets/common/chip.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/scene/panel/scene_options_panel.hpp"

namespace abrazo::widgets {
namespace {

QToolButton* overlay_chip(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = text_chip(text, tip, parent);
  button->setCheckable(true);
  button->setCursor(Qt::PointingHandCursor);
  return button;
}

}  // namespace

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
    m_scalars[s] = overlay_chip(texts[s][0], texts[s][1], this);
    group->addButton(m_scalars[s]);
    row->addWidget(m_scalars[s]);
    connect(m_scalars[s], &QToolButton::clicked, this,
            [this, s] { emit scalarChosen(static_cast<MeshScalar>(s)); });
  }
  m_scalars[0]->setChecked(true);
  m_cells = overlay_chip(
      "Volume ratio",
      "Tetrahedra of the mesh, coloured by their volume in the result over that in the selected pair; "
      "magenta with a rim: inverted",
      this);
  row->addWidget(m_cells);
  connect(m_cells, &QToolButton::clicked, this, &ScalarChips::cellsChosen);
  m_betweenOnly = overlay_chip("Inter-body only", "Show only the edges between the two bodies", this);
  row->addWidget(m_betweenOnly);
  connect(m_betweenOnly, &QToolButton::clicked, this, &ScalarChips::betweenOnlyChosen);
  m_filter = overlay_chip(
      "Filter…", "Edges by length or of the selection, exploded tetrahedra, cutting plane, trails", this);
  row->addWidget(m_filter);
  m_options = new SceneOptionsPanel(this);
  connect(m_options, &SceneOptionsPanel::optionsRequested, this, &ScalarChips::optionsRequested);
  connect(m_filter, &QToolButton::clicked, this, [this] {
    setOptions(m_shown);  // a click must not leave the chip checked: that indicates an active filter
    m_options->adjustSize();
    // Below the chips on the left, over the scene: on the right are the legend and the candidates.
    m_options->move(mapToGlobal({0, height() + 4}));
    m_options->show();
    m_options->setFocus();
  });
}

void ScalarChips::fitInto(int width_px) {
  const bool was_short = m_filter->text() == "Filter";
  if (!was_short) m_fullWidth = sizeHint().width();
  const bool is_short = width_px < m_fullWidth;
  if (is_short == was_short) return;
  const auto say = [is_short](QToolButton* button, const char* whole, const char* brief) {
    button->setText(QString::fromUtf8(is_short ? brief : whole));
  };
  say(m_scalars[static_cast<std::size_t>(MeshScalar::LengthChange)], "Length change", "Length");
  say(m_cells, "Volume ratio", "Volume");
  say(m_betweenOnly, "Inter-body only", "Inter-body");
  say(m_filter, "Filter…", "Filter");
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
  m_filter->setChecked(options.filters());
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

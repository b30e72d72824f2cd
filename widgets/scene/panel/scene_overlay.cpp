#include "widgets/scene/panel/scene_overlay.hpp"

#include <QActionGroup>
#include <QMenu>
#include <QPainter>
#include <QScreen>
#include <QToolButton>
#include <algorithm>

#include "widgets/common/chip.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/scene/panel/scene_options_panel.hpp"

namespace abrazo::widgets {
namespace {

constexpr int chip_gap = 6;  ///< between chips [px]

QToolButton* overlay_chip(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = text_chip(text, tip, parent);
  button->setCheckable(true);
  button->setCursor(Qt::PointingHandCursor);
  return button;
}

}  // namespace

ScalarChips::ScalarChips(QWidget* parent) : QWidget(parent) {
  m_colour = text_chip({}, "What colours the edges of the mesh, and its tetrahedra", this);
  m_colour->setAccessibleName("Colour of the mesh");
  m_colour->setCursor(Qt::PointingHandCursor);
  m_colour->setPopupMode(QToolButton::InstantPopup);
  m_colour->setMenu(makeColours());
  sayColour();
  m_betweenOnly = overlay_chip("Inter-body only", "Show only the edges between the two bodies", this);
  connect(m_betweenOnly, &QToolButton::clicked, this, &ScalarChips::betweenOnlyChosen);
  m_filter = overlay_chip(
      "Filter…", "Edges by length or of the selection, exploded tetrahedra, cutting plane, trails", this);
  m_options = new SceneOptionsPanel(this);
  connect(m_options, &SceneOptionsPanel::optionsRequested, this, &ScalarChips::optionsRequested);
  connect(m_filter, &QToolButton::clicked, this, &ScalarChips::openFilter);
}

QMenu* ScalarChips::makeColours() {
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
  auto* menu = new QMenu(m_colour);
  menu->setToolTipsVisible(true);
  auto* group = new QActionGroup(menu);
  for (std::size_t s = 0; s < texts.size(); ++s) {
    m_scalars[s] = group->addAction(menu->addAction(QString::fromUtf8(texts[s][0])));
    m_scalars[s]->setCheckable(true);
    m_scalars[s]->setToolTip(QString::fromUtf8(texts[s][1]));
    connect(m_scalars[s], &QAction::triggered, this,
            [this, s] { emit scalarChosen(static_cast<MeshScalar>(s)); });
  }
  m_scalars[0]->setChecked(true);
  menu->addSeparator();
  m_cells = menu->addAction("Volume ratio of the tetrahedra", this, &ScalarChips::cellsChosen);
  m_cells->setCheckable(true);
  m_cells->setToolTip(
      "Tetrahedra of the mesh, coloured by their volume in the result over that in the selected pair; "
      "magenta with a rim: inverted");
  return menu;
}

void ScalarChips::sayColour() {
  for (const QAction* scalar : m_scalars)
    if (scalar->isChecked())
      m_colour->setText(scalar->text() + (m_cells->isChecked() ? " + volume ▾" : " ▾"));
  if (m_room > 0) fitInto(m_room);
}

/// Below the chips, in the left third of the scene and over what is left of it: in the middle is the pair
/// that is filtered.
void ScalarChips::openFilter() {
  setOptions(m_shown);  // a click must not leave the chip checked: that indicates an active filter
  m_options->adjustSize();
  const QRect desk = screen()->availableGeometry();
  const QPoint below = mapToGlobal(QPoint(0, height() + 4));
  const int third = parentWidget()->mapToGlobal(QPoint(parentWidget()->width() / 3, 0)).x();
  m_options->move(std::max(desk.left(), std::min(below.x(), third - m_options->width())),
                  std::max(desk.top(), std::min(below.y(), desk.bottom() - m_options->height())));
  m_options->show();
  m_options->setFocus();
}

void ScalarChips::fitInto(int width_px) {
  m_room = width_px;
  say(false);
  if (inRows(width_px).size() > 1) say(true);
  int y = 0, right = 0;
  for (const auto& row : inRows(width_px)) {
    int x = 0;
    for (QToolButton* chip : row) {
      chip->setGeometry(QRect(QPoint(x, y), chip->sizeHint()));
      x += chip->width() + chip_gap;
    }
    right = std::max(right, x - chip_gap);
    y += row.front()->height() + chip_gap;
  }
  setFixedSize(right, y - chip_gap);
}

int ScalarChips::freeFrom(int x_px) const {
  int y = 0;
  for (const QToolButton* chip : findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly))
    if (chip->geometry().right() > x_px) y = std::max(y, chip->geometry().bottom() + chip_gap);
  return y;
}

void ScalarChips::say(bool is_short) {
  const auto say = [is_short](QToolButton* button, const char* whole, const char* brief) {
    button->setText(QString::fromUtf8(is_short ? brief : whole));
  };
  say(m_betweenOnly, "Inter-body only", "Inter-body");
  say(m_filter, "Filter…", "Filter");
}

/// As many beside one another as there is room for.
std::vector<std::vector<QToolButton*>> ScalarChips::inRows(int width_px) const {
  const std::vector<QToolButton*> all = {m_colour, m_betweenOnly, m_filter};
  std::vector<std::vector<QToolButton*>> rows;
  int x = 0;
  for (QToolButton* chip : all) {
    const int width = chip->sizeHint().width();
    if (rows.empty() || x + width > width_px) {
      rows.emplace_back();
      x = 0;
    }
    rows.back().push_back(chip);
    x += width + chip_gap;
  }
  return rows;
}

void ScalarChips::setScalar(MeshScalar scalar) {
  m_scalars[static_cast<std::size_t>(scalar)]->setChecked(true);
  m_options->setUnit(scalar_info(scalar).unit);
  sayColour();
}
void ScalarChips::setBetweenOnly(bool only) {
  m_betweenOnly->setChecked(only);
}

void ScalarChips::setCells(bool shown) {
  m_cells->setChecked(shown);
  sayColour();
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

void FrameFacts::show(const Line& first, const QString& second, const QString& trouble) {
  if (first == m_first && second == m_second && trouble == m_trouble) return;
  m_first = first;
  m_second = second;
  m_trouble = trouble;
  update();
}

/// As wide as it is drawn: with all digits as wide as the widest.
QString FrameFacts::fitting(const QString& line) const {
  const QFont font = interface_font(13);
  const int room = width() - 8;
  QString kept = line;
  while (!kept.isEmpty() && tabular_width(font, kept) > room) {
    const auto last = kept.lastIndexOf(" · ");
    if (last < 0) return QFontMetrics(font).elidedText(kept, Qt::ElideRight, room);
    kept.truncate(last);
  }
  return kept;
}

QString FrameFacts::firstLine() const {
  return tabular_width(interface_font(13), m_first.whole) <= width() - 8 ? m_first.whole
                                                                         : fitting(m_first.brief);
}

void FrameFacts::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(interface_font(13));
  painter.setPen(m_palette.dark ? mixed(m_palette.text, m_palette.secondary, 0.5) : m_palette.secondary);
  draw_tabular(painter, QRectF(0, 20, width(), 18), Qt::AlignLeft, firstLine());
  draw_tabular(painter, QRectF(0, 38, width(), 18), Qt::AlignLeft, fitting(m_second));
  painter.setPen(m_palette.warning);
  painter.drawText(QRectF(0, 2, width(), 18), Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(m_trouble, Qt::ElideRight, width() - 8));
}

}  // namespace abrazo::widgets

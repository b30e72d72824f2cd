#include "widgets/scene/scene_tree.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <initializer_list>
#include <vector>

#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int row_height = 22;

struct Row {
  const char* name;
  int depth;
  std::vector<ScenePart> parts;  ///< what its dot switches; a group switches all of its own
};

const std::vector<Row>& rows() {
  using P = ScenePart;
  static const std::vector<Row> all = {{"User", 0, {P::User}},
                                       {"Result", 0, {P::Leader, P::Follower}},
                                       {"Leader", 1, {P::Leader}},
                                       {"Follower", 1, {P::Follower}},
                                       {"Selected pair", 0, {P::SelectedPair}},
                                       {"Interaction mesh", 0, {P::MeshBetween, P::MeshWithin}},
                                       {"between bodies", 1, {P::MeshBetween}},
                                       {"within bodies", 1, {P::MeshWithin}},
                                       {"tetrahedra", 1, {P::Tetrahedra}},
                                       {"Constraints", 0, {P::Bones, P::FootLocks, P::Contacts}},
                                       {"bones", 1, {P::Bones}},
                                       {"foot locks", 1, {P::FootLocks}},
                                       {"collisions", 1, {P::Contacts}},
                                       {"Joints", 0, {P::Joints}},
                                       {"Morph steps", 0, {P::MorphSteps}},
                                       {"Trails", 0, {P::Trails}},
                                       {"Floor", 0, {P::Floor}}};
  return all;
}

int row_at(int y) {
  const int row = y / row_height;
  return y >= 0 && row < static_cast<int>(rows().size()) ? row : -1;
}

}  // namespace

SceneTree::SceneTree(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setMouseTracking(true);
  setFixedHeight(row_height * static_cast<int>(rows().size()) + 6);
}

QSize SceneTree::sizeHint() const {
  return {260, height()};
}

void SceneTree::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void SceneTree::setInputName(const QString& name) {
  m_input = name;
  update();
}

void SceneTree::setVisibility(const PartVisibility& visibility) {
  m_visibility = visibility;
  update();
}

void SceneTree::setCounts(const PartCounts& counts) {
  m_counts = counts;
  update();
}

bool SceneTree::isOn(int row) const {
  const auto& parts = rows()[static_cast<std::size_t>(row)].parts;
  return std::any_of(parts.begin(), parts.end(),
                     [this](ScenePart p) { return m_visibility[static_cast<std::size_t>(p)]; });
}

QString SceneTree::note(int row) const {
  const Row& shown = rows()[static_cast<std::size_t>(row)];
  const auto count = [this](ScenePart part) { return m_counts[static_cast<std::size_t>(part)]; };
  if (row == 0) return m_input;
  const QString name = shown.name;
  if (name == "Leader") return "active";
  if (name == "Follower") return "passive";
  if (name == "Selected pair") return "ghost";
  if (name == "Interaction mesh")
    return QString("%1 edges").arg(count(ScenePart::MeshBetween) + count(ScenePart::MeshWithin));
  if (shown.parts.size() != 1 || shown.parts[0] == ScenePart::Floor) return {};
  return QString::number(count(shown.parts[0]));
}

void SceneTree::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(interface_font(13));
  for (int r = 0; r < static_cast<int>(rows().size()); ++r) {
    const Row& row = rows()[static_cast<std::size_t>(r)];
    const QRectF line(0, r * row_height, width(), row_height);
    if (r == m_hovered) painter.fillRect(line, mixed(m_palette.raised, m_palette.panel, 0.6));
    const double x = 12 + 14 * row.depth;
    const bool on = isOn(r);
    painter.setPen(QPen(m_palette.secondary, 1.2));
    painter.setBrush(on ? QBrush(m_palette.secondary) : QBrush(Qt::NoBrush));
    painter.drawEllipse(QPointF(x, line.center().y()), 3.2, 3.2);
    QColor ink = on ? m_palette.text : m_palette.secondary;
    if (on && r == 2) ink = m_palette.dark ? m_palette.active.lighter(118) : m_palette.active;
    if (on && r == 3) ink = m_palette.passive;
    painter.setPen(ink);
    painter.drawText(line.adjusted(x + 13, 0, -80, 0), Qt::AlignVCenter | Qt::AlignLeft, row.name);
    painter.setPen(m_palette.secondary);
    draw_tabular(painter, line.adjusted(0, 0, -12, 0), Qt::AlignRight, note(r));
  }
}

void SceneTree::mousePressEvent(QMouseEvent* event) {
  const int row = row_at(event->y());
  if (row < 0 || event->button() != Qt::LeftButton) return;
  const bool on = !isOn(row);
  PartVisibility changed = m_visibility;
  for (const ScenePart part : rows()[static_cast<std::size_t>(row)].parts)
    changed[static_cast<std::size_t>(part)] = on;
  emit visibilityRequested(changed);
}

void SceneTree::mouseMoveEvent(QMouseEvent* event) {
  m_hovered = row_at(event->y());
  update();
}

void SceneTree::leaveEvent(QEvent*) {
  m_hovered = -1;
  update();
}

}  // namespace abrazo::widgets

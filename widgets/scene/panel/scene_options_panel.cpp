#include "widgets/scene/panel/scene_options_panel.hpp"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "widgets/common/parts.hpp"

namespace abrazo::widgets {
namespace {

constexpr double longest_m = 3;  // shown as "any": no edge of a dancing couple is longer
constexpr int apart_steps = 200, cut_mm = 1000;
constexpr int half_turn_deg = 180, quarter_turn_deg = 90;
constexpr double degrees_per_radian = 57.29577951308232;

int degrees(double radians) {
  return static_cast<int>(std::lround(radians * degrees_per_radian));
}

QSlider* slider(QWidget* parent, const QString& name, int from, int to) {
  auto* made = new QSlider(Qt::Horizontal, parent);
  made->setRange(from, to);
  made->setAccessibleName(name);
  made->setMinimumWidth(110);
  return made;
}

}  // namespace

SceneOptionsPanel::SceneOptionsPanel(QWidget* parent) : QFrame(parent, Qt::Popup) {
  setFrameShape(QFrame::StyledPanel);
  setAccessibleName("Filter of the scene");
  auto* form = new QFormLayout(this);
  form->setContentsMargins(14, 12, 14, 12);
  m_shortest = length("Shortest edge", "Hide edges that are shorter");
  m_longest = length("Longest edge", "Hide edges that are longer");
  m_least = value("Least value", "Hide edges whose coloured value, without its sign, is lower");
  m_most = value("Highest value", "Hide edges whose coloured value, without its sign, is higher");
  m_isolates = tick("Only the selection (X)",
                    "While something is selected, only the edges and tetrahedra that belong to it");
  m_apart = slider(this, "Exploded tetrahedra", 0, apart_steps);
  m_apart->setToolTip("Moves the tetrahedra away from the middle of the pair");
  m_cuts = tick("Cut (C)", "Hides everything beyond a plane");
  m_inWorld = tick("Plane stays in the world (Shift+C)",
                   "Otherwise it moves with the camera. In the scene its outline is dragged to move it, its "
                   "knob to turn it");
  m_cut = slider(this, "Offset of the cutting plane", -cut_mm, cut_mm);
  m_cut->setToolTip("Distance of the plane from the middle of the pair; Ctrl and the wheel in the scene");
  m_turn = slider(this, "Turn of the cutting plane", -half_turn_deg, half_turn_deg);
  m_tilt = slider(this, "Tilt of the cutting plane", -quarter_turn_deg, quarter_turn_deg);
  m_turn->setToolTip("Around the vertical axis; Ctrl+Alt and drag in the scene");
  m_tilt->setToolTip("From vertical to horizontal; Ctrl+Alt and drag in the scene");
  m_trail = length("Length of trails", "Of the trails; Shift and the wheel in the scene");
  m_trail->setRange(shortest_trail_s, longest_trail_s);
  m_trail->setSingleStep(0.25);
  m_trail->setSuffix(" s");
  form->addRow("Shortest edge", m_shortest);
  form->addRow("Longest edge", m_longest);
  form->addRow("Least value", m_least);
  form->addRow("Highest value", m_most);
  form->addRow(m_isolates);
  form->addRow("Exploded tetrahedra", withValue(m_apart, m_apartValue));
  form->addRow(m_cuts);
  form->addRow(m_inWorld);
  form->addRow("Offset", withValue(m_cut, m_cutValue));
  form->addRow("Turn", withValue(m_turn, m_turnValue));
  form->addRow("Tilt", withValue(m_tilt, m_tiltValue));
  form->addRow("Trails", m_trail);
  const auto ask = [this] { emit optionsRequested(asked()); };
  for (QDoubleSpinBox* box : {m_shortest, m_longest, m_least, m_most, m_trail})
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, ask);
  for (QToolButton* one : {m_isolates, m_cuts, m_inWorld}) connect(one, &QToolButton::toggled, this, ask);
  for (QSlider* one : {m_apart, m_cut, m_turn, m_tilt}) {
    connect(one, &QSlider::valueChanged, this, &SceneOptionsPanel::showValues);
    connect(one, &QSlider::valueChanged, this, ask);
  }
  setOptions({});
}

/// The slider with its value beside it.
QWidget* SceneOptionsPanel::withValue(QSlider* slider, QLabel*& value) {
  auto* both = new QWidget(this);
  auto* row = row_in(both);
  row->addWidget(slider, 1);
  value = new QLabel(both);
  value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  value->setMinimumWidth(value->fontMetrics().horizontalAdvance("+1.00 m "));
  row->addWidget(value);
  return both;
}

void SceneOptionsPanel::showValues() {
  const auto show = [](QLabel* label, const QSlider* slider, const QString& text) {
    label->setText(text);
    label->setEnabled(slider->isEnabled());
  };
  const double cut_m = static_cast<double>(m_cut->value()) / 1000;
  show(m_apartValue, m_apart, QString("%1 %").arg(m_apart->value()));
  show(m_cutValue, m_cut, QString("%1%2 m").arg(cut_m > 0 ? "+" : "").arg(cut_m, 0, 'f', 2));
  show(m_turnValue, m_turn, QString("%1°").arg(m_turn->value()));
  show(m_tiltValue, m_tilt, QString("%1°").arg(m_tilt->value()));
}

/// Escape closes it; without this the window's shortcut would clear the selection instead.
bool SceneOptionsPanel::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QFrame::event(event);
}

std::vector<QWidget*> SceneOptionsPanel::fields() const {
  return {m_shortest, m_longest, m_least, m_most, m_trail, m_isolates,
          m_cuts,     m_inWorld, m_apart, m_cut,  m_turn,  m_tilt};
}

QToolButton* SceneOptionsPanel::tick(const QString& text, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setObjectName("chip");
  button->setText(text);
  button->setToolTip(tip);
  button->setCheckable(true);
  return button;
}

QDoubleSpinBox* SceneOptionsPanel::length(const QString& name, const QString& tip) {
  auto* box = new QDoubleSpinBox(this);
  box->setRange(0, longest_m);
  box->setSingleStep(0.05);
  box->setDecimals(2);
  box->setSuffix(" m");
  describe(*box, name, tip);
  return box;
}

QDoubleSpinBox* SceneOptionsPanel::value(const QString& name, const QString& tip) {
  auto* box = new QDoubleSpinBox(this);
  box->setRange(0, greatest_value);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setDecimals(2);
  box->setSpecialValueText("any");
  describe(*box, name, tip);
  return box;
}

void SceneOptionsPanel::setUnit(const QString& unit) {
  for (QDoubleSpinBox* box : {m_least, m_most}) box->setSuffix(unit.isEmpty() ? unit : " " + unit);
}

SceneOptions SceneOptionsPanel::asked() const {
  SceneOptions options = m_options;
  options.shortest_m = m_shortest->value();
  options.longest_m = m_longest->value() >= longest_m ? MeshFilter::no_limit : m_longest->value();
  options.least_value = m_least->value();
  options.most_value = m_most->value() > 0 ? m_most->value() : MeshFilter::no_limit;
  options.isolates = m_isolates->isChecked();
  options.apart = static_cast<double>(m_apart->value()) / 100;
  options.cuts = m_cuts->isChecked();
  options.cut_in_world = m_inWorld->isChecked();
  options.cut_m = static_cast<double>(m_cut->value()) / 1000;
  // A slider has whole degrees: an untouched one keeps its exact value.
  if (m_turn->value() != degrees(m_options.cut_azimuth_rad))
    options.cut_azimuth_rad = m_turn->value() / degrees_per_radian;
  if (m_tilt->value() != degrees(m_options.cut_elevation_rad))
    options.cut_elevation_rad = m_tilt->value() / degrees_per_radian;
  options.trail_s = m_trail->value();
  return options;
}

void SceneOptionsPanel::setOptions(const SceneOptions& options) {
  m_options = options;
  for (QWidget* one : fields()) one->blockSignals(true);
  m_shortest->setValue(options.shortest_m);
  m_longest->setValue(std::min(options.longest_m, longest_m));
  m_least->setValue(options.least_value);
  m_most->setValue(std::isfinite(options.most_value) ? options.most_value : 0);
  m_isolates->setChecked(options.isolates);
  m_apart->setValue(static_cast<int>(std::lround(100 * options.apart)));
  m_cuts->setChecked(options.cuts);
  m_inWorld->setChecked(options.cut_in_world);
  m_cut->setValue(static_cast<int>(std::lround(1000 * options.cut_m)));
  m_turn->setValue(degrees(options.cut_azimuth_rad));
  m_tilt->setValue(degrees(options.cut_elevation_rad));
  m_trail->setValue(options.trail_s);
  for (QWidget* one : std::initializer_list<QWidget*>{m_inWorld, m_cut}) one->setEnabled(options.cuts);
  for (QSlider* one : {m_turn, m_tilt}) one->setEnabled(options.cuts && options.cut_in_world);
  for (QWidget* one : fields()) one->blockSignals(false);
  showValues();
}

}  // namespace abrazo::widgets

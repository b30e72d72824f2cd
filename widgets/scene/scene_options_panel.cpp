#include "widgets/scene/scene_options_panel.hpp"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace abrazo::widgets {
namespace {

constexpr double longest_m = 3;  // shown as "any": no edge of two people who dance is longer
constexpr int apart_steps = 200, cut_mm = 1000;

QSlider* slider(QWidget* parent, const QString& name, int from, int to) {
  auto* made = new QSlider(Qt::Horizontal, parent);
  made->setRange(from, to);
  made->setAccessibleName(name);
  made->setMinimumWidth(150);
  return made;
}

}  // namespace

SceneOptionsPanel::SceneOptionsPanel(QWidget* parent) : QFrame(parent, Qt::Popup) {
  setFrameShape(QFrame::StyledPanel);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(14, 12, 14, 12);
  m_shortest = length("Shortest edge", "Hide edges that are shorter");
  m_longest = length("Longest edge", "Hide edges that are longer");
  m_pickedOnly = tick("Only at the selected joint",
                      "Once a joint is selected, only the edges and tetrahedra that meet there");
  m_apart = slider(this, "Apart", 0, apart_steps);
  m_apart->setToolTip("Moves the tetrahedra away from the middle of the pair");
  m_cuts = tick("Cut away the front", "Leaves out what is nearer to the eye than a plane");
  m_cut = slider(this, "Cutting plane", -cut_mm, cut_mm);
  m_cut->setInvertedAppearance(true);
  m_cut->setToolTip("From far before the middle of the pair to far behind it");
  form->addRow("Shortest edge", m_shortest);
  form->addRow("Longest edge", m_longest);
  form->addRow(m_pickedOnly);
  form->addRow("Tetrahedra apart", m_apart);
  form->addRow(m_cuts);
  form->addRow("Plane", m_cut);
  const auto ask = [this] { emit optionsRequested(asked()); };
  for (QDoubleSpinBox* box : {m_shortest, m_longest})
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, ask);
  for (QToolButton* one : {m_pickedOnly, m_cuts}) connect(one, &QToolButton::toggled, this, ask);
  for (QSlider* one : {m_apart, m_cut}) connect(one, &QSlider::valueChanged, this, ask);
  setOptions({});
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
  box->setAccessibleName(name);
  box->setToolTip(tip);
  return box;
}

SceneOptions SceneOptionsPanel::asked() const {
  SceneOptions options = m_options;
  options.shortest_m = m_shortest->value();
  options.longest_m = m_longest->value() >= longest_m ? MeshFilter::no_limit : m_longest->value();
  options.picked_joint_only = m_pickedOnly->isChecked();
  options.apart = static_cast<double>(m_apart->value()) / 100;
  options.cuts = m_cuts->isChecked();
  options.cut_m = static_cast<double>(m_cut->value()) / 1000;
  return options;
}

void SceneOptionsPanel::setOptions(const SceneOptions& options) {
  m_options = options;
  for (QWidget* one :
       std::initializer_list<QWidget*>{m_shortest, m_longest, m_pickedOnly, m_apart, m_cuts, m_cut})
    one->blockSignals(true);
  m_shortest->setValue(options.shortest_m);
  m_longest->setValue(std::min(options.longest_m, longest_m));
  m_pickedOnly->setChecked(options.picked_joint_only);
  m_apart->setValue(static_cast<int>(std::lround(100 * options.apart)));
  m_cuts->setChecked(options.cuts);
  m_cut->setValue(static_cast<int>(std::lround(1000 * options.cut_m)));
  m_cut->setEnabled(options.cuts);
  for (QWidget* one :
       std::initializer_list<QWidget*>{m_shortest, m_longest, m_pickedOnly, m_apart, m_cuts, m_cut})
    one->blockSignals(false);
}

}  // namespace abrazo::widgets

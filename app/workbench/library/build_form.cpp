#include "app/workbench/library/build_form.hpp"

#include <QComboBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <set>

#include "core/base/text.hpp"
#include "core/motion/joints/marker_model.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/parts.hpp"

namespace abrazo::app {
namespace {

const QString as_found = "as found";

QComboBox* add_field(QGridLayout* grid, int row, int column, const QString& name, const QString& tip) {
  auto* label = new QLabel(name);
  auto* box = new QComboBox;
  label->setBuddy(box);
  label->setObjectName("secondary");
  widgets::describe(*box, name, tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  grid->addWidget(label, row, 2 * column);
  grid->addWidget(box, row, 2 * column + 1);
  return box;
}

/// The number a text begins with, as "0.01 · centimetres"; nothing when it does not begin with one above 0.
std::optional<double> number_in(const QString& text) {
  const std::string words = text.toStdString();
  const auto parts = split_words(words);
  const auto number = parts.empty() ? std::nullopt : parse_number(parts.front());
  return number && *number > 0 ? number : std::nullopt;
}

/// @return whether that changed anything
template <typename Value>
bool put(Value& place, const Value& value) {
  if (place == value) return false;
  place = value;
  return true;
}

}  // namespace

BuildForm::BuildForm(BuildPlanModel& model, QWidget* parent) : QWidget(parent), m_model(model) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  m_take = add_field(grid, 0, 0, "Take", "Two performers in one take were captured together");
  m_role = add_field(grid, 1, 0, "Role", "Who is active: leads, attacks. “either” keeps both assignments");
  m_rate = add_field(grid, 0, 1, "Frame rate", "Frames per second, overrides the file");
  m_unit = add_field(grid, 1, 1, "Unit", "Metres per unit of the file");
  m_up = add_field(grid, 0, 2, "Up axis", "The axis of the file that points up");
  m_joints = add_field(grid, 1, 2, "Joints", "Which points of the file are the 25 joints");
  m_skeleton = add_field(grid, 1, 3, "Skeleton", "The .asf of an .amc");
  m_start = new QSpinBox;
  widgets::describe(*m_start, "First frame",
                    "First frame of the file that is used: where one performer's recording began earlier");
  m_start->setRange(0, 100'000'000);
  auto* start = new QLabel("First frame");
  start->setBuddy(m_start);
  start->setObjectName("secondary");
  grid->addWidget(start, 0, 6);
  grid->addWidget(m_start, 0, 7);
  for (const int column : {1, 3, 5, 7}) grid->setColumnStretch(column, 1);
  for (QComboBox* box : {m_take, m_rate, m_unit}) widgets::make_typeable(*box);
  m_role->addItems({"either", "leads", "follows"});
  m_rate->addItems({as_found, "30", "60", "100", "120", "240"});
  m_unit->addItems({as_found, "1 · metres", "0.01 · centimetres", "0.001 · millimetres", "0.0254 · inches",
                    "0.056444444 · CMU"});
  m_up->addItem(as_found);
  for (const UpAxis up : every_up_axis) m_up->addItem(QString::fromStdString(axis_label(up)));
  connectParts();
  show({});
}

void BuildForm::connectParts() {
  const auto chosen = qOverload<int>(&QComboBox::activated);
  connect(m_take, chosen, this,
          [this](int at) { m_model.setTake(m_rows, at == 0 ? QString() : m_take->itemText(at)); });
  connect(m_role, chosen, this, [this](int at) { m_model.setRole(m_rows, static_cast<PlannedRole>(at)); });
  connect(m_start, qOverload<int>(&QSpinBox::valueChanged), this,
          [this](int frame) { m_model.setStart(m_rows, frame); });
  const auto say_rate = [this] {
    reread([this](Manifest::Performer&, std::optional<double>& fps) {
      return put(fps, number_in(m_rate->currentText()));
    });
  };
  const auto say_unit = [this] {
    reread([this](Manifest::Performer& source, std::optional<double>&) {
      return put(source.metres_per_unit, number_in(m_unit->currentText()));
    });
  };
  connect(m_rate, chosen, this, say_rate);
  // Only typed values: leaving the field must not copy the first row's value to the others.
  const auto when_typed = [this](QComboBox* box, auto say) {
    connect(box->lineEdit(), &QLineEdit::editingFinished, this, [box, say] {
      if (!box->lineEdit()->isModified()) return;
      box->lineEdit()->setModified(false);
      say();
    });
  };
  when_typed(m_take, [this] {
    if (m_rows.empty()) return;
    m_model.setTake(m_rows, m_take->currentText() == "not used" ? QString() : m_take->currentText());
  });
  when_typed(m_rate, say_rate);
  connect(m_unit, chosen, this, say_unit);
  when_typed(m_unit, say_unit);
  connect(m_up, chosen, this, [this](int at) {
    reread([at](Manifest::Performer& source, std::optional<double>&) {
      source.up_axis =
          at == 0 ? std::nullopt : std::optional(every_up_axis[static_cast<std::size_t>(at - 1)]);
      return true;
    });
  });
  connect(m_joints, chosen, this, [this] { chooseJoints(); });
  connect(m_skeleton, chosen, this, [this] { chooseSkeleton(); });
}

/// Requests each file of the chosen performers once, if `say` changes its options.
void BuildForm::reread(const std::function<bool(Manifest::Performer&, std::optional<double>&)>& say) {
  std::set<std::filesystem::path> asked;
  for (const int row : m_rows) {
    Manifest::Performer source = m_model.performer(row).source;
    std::optional<double> fps = m_model.performer(row).fps;
    if (!asked.insert(source.motion).second || !say(source, fps)) continue;
    emit surveyRequested(source, fps);
  }
}

void BuildForm::chooseJoints() {
  QString name = m_joints->currentData().toString();
  if (name == "…") name = widgets::choose_file(this, "Joint map", {}, "Joint maps (*.json);;All files (*)");
  if (name.isEmpty() && m_joints->currentIndex() != 0) return show(m_rows);
  reread([&](Manifest::Performer& source, std::optional<double>&) {
    return put(source.joint_map, name.toStdString());
  });
}

void BuildForm::chooseSkeleton() {
  QString file = m_skeleton->currentData().toString();
  if (file == "…") file = widgets::choose_file(this, "Skeleton", {}, "Skeletons (*.asf);;All files (*)");
  if (file.isEmpty() && m_skeleton->currentIndex() != 0) return show(m_rows);
  reread([&](Manifest::Performer& source, std::optional<double>&) {
    source.skeleton = file.toStdString();
    return true;
  });
}

void BuildForm::setSkeletons(const QStringList& files) {
  m_skeletons = files;
}

void BuildForm::showTakes() {
  QStringList takes;
  for (const PlannedPerformer& performer : m_model.plan().performers)
    if (const QString take = QString::fromStdString(performer.take); !take.isEmpty() && !takes.contains(take))
      takes << take;
  m_take->clear();
  m_take->addItem("not used");
  m_take->addItems(takes);
}

void BuildForm::showJoints(const PlannedPerformer& performer) {
  const QString said = QString::fromStdString(performer.source.joint_map);
  m_joints->clear();
  m_joints->addItem(as_found, QString());
  for (const JointMap& map : builtin_joint_maps())
    m_joints->addItem(QString::fromStdString(map.name), QString::fromStdString(map.name));
  for (const MarkerModel& model : builtin_marker_models())
    m_joints->addItem(QString::fromStdString(model.name) + " markers", QString::fromStdString(model.name));
  if (!said.isEmpty() && m_joints->findData(said) < 0) m_joints->addItem(QFileInfo(said).fileName(), said);
  m_joints->addItem("From a file…", "…");
  m_joints->setCurrentIndex(std::max(0, m_joints->findData(said)));
}

void BuildForm::showSkeleton(const PlannedPerformer& performer) {
  const QString said = QString::fromStdString(performer.source.skeleton.string());
  m_skeleton->clear();
  m_skeleton->addItem(as_found, QString());
  QStringList files = m_skeletons;
  if (!said.isEmpty() && !files.contains(said)) files << said;
  for (const QString& file : files) m_skeleton->addItem(QFileInfo(file).fileName(), file);
  m_skeleton->addItem("From a file…", "…");
  m_skeleton->setCurrentIndex(std::max(0, m_skeleton->findData(said)));
  const auto extension = lower_case(performer.source.motion.extension().string());
  m_skeleton->setEnabled(extension == ".amc");
}

void BuildForm::show(const std::vector<int>& rows) {
  m_rows = rows;
  setEnabled(!rows.empty());
  const QSignalBlocker quiet(m_start);
  showTakes();
  if (rows.empty()) return;
  const PlannedPerformer& first = m_model.performer(rows.front());
  m_take->setCurrentText(first.take.empty() ? "not used" : QString::fromStdString(first.take));
  m_role->setCurrentIndex(static_cast<int>(first.role));
  m_rate->setCurrentText(first.fps ? QString::number(*first.fps) : as_found);
  const auto unit = first.source.metres_per_unit;
  m_unit->setCurrentText(unit ? QString::fromStdString(exact_text(*unit)) : as_found);
  m_up->setCurrentIndex(first.source.up_axis ? 1 + static_cast<int>(*first.source.up_axis) : 0);
  m_start->setMaximum(std::max(0, first.frames() - 2));
  m_start->setValue(first.source.start);
  showJoints(first);
  showSkeleton(first);
}

}  // namespace abrazo::app

#include "app/workbench/library/import_panel.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/dialog_size.hpp"
#include "app/workbench/base/error_words.hpp"
#include "core/base/text.hpp"
#include "core/motion/joints/joint_order.hpp"
#include "core/opening/import_rules.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/section_header.hpp"
#include "widgets/library/motion_picture.hpp"

namespace abrazo::app {
namespace {

constexpr const char* from_file = "\x01";  ///< the entry that asks for a file

struct UnitEntry {
  const char* name;
  double metres;
};
constexpr std::array unit_entries = {UnitEntry{"metres", 1.0}, UnitEntry{"centimetres", 0.01},
                                     UnitEntry{"millimetres", 0.001}, UnitEntry{"inches", 0.0254}};

QString number(double value, int digits = 5) {
  return QString::number(value, 'g', digits);
}

QString unit_words(double metres) {
  for (const UnitEntry& unit : unit_entries)
    if (std::abs(unit.metres - metres) < 1e-12) return unit.name;
  return number(metres) + " m";
}

/// From markers, or by names: a map is named after a program whose names others use as well.
QString joints_found_words(const ImportReport& report) {
  const auto computed = static_cast<int>(report.inferred_joints.size());
  const QString map = QString::fromStdString(report.joint_map);
  const auto has_points = [](const std::string& points) { return !points.empty(); };
  if (std::ranges::none_of(report.joint_points, has_points))
    return QString("%1 of %2 joints from markers (“%3”), %4 computed from those beside them")
        .arg(joint_count - computed)
        .arg(joint_count)
        .arg(map)
        .arg(computed);
  const auto& maps = builtin_joint_maps();
  const bool is_builtin = std::ranges::find(maps, report.joint_map, &JointMap::name) != maps.end();
  const QString found = QString("%1 of %2 joints found by %3“%4”")
                            .arg(joint_count - computed)
                            .arg(joint_count)
                            .arg(is_builtin ? "names as in " : "", map);
  return computed > 0 ? QString("%1, %2 inferred").arg(found).arg(computed) : found;
}

QLabel* small_label(QWidget* parent) {
  auto* label = widgets::quiet_label({}, parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

/// Chooses the entry that stands for what was said; the first where nothing was.
void choose_data(QComboBox& box, const QVariant& data) {
  const int found = data.isValid() ? box.findData(data) : 0;
  box.setCurrentIndex(found < 0 ? 0 : found);
  if (found < 0 && box.isEditable()) box.setEditText(number(data.toDouble()));
}

std::optional<double> number_said(const QComboBox& box) {
  const int known = box.findText(box.currentText());
  if (known == 0) return std::nullopt;
  if (known > 0) return box.itemData(known).toDouble();
  const auto value = parse_number(box.currentText().trimmed().toStdString());
  return value ? *value : std::nan("");
}

}  // namespace

ImportPanel::ImportPanel(const MotionReading& reading, QWidget* parent)
    : QDialog(parent), m_reading(reading), m_palette(widgets::palette_of(widgets::Theme::Dark)) {
  setWindowTitle("Import motion · " + QFileInfo(QString::fromStdString(reading.file)).fileName());
  resize_within_screen(*this, {1180, 700});
  auto* column = widgets::column_in(this, {}, 0);
  column->addWidget(makeReason());
  auto* row = widgets::nested_row({}, 0);
  row->addWidget(makeFileColumn());
  row->addWidget(makePicture(), 1);
  row->addWidget(makeSpaceColumn());
  column->addLayout(row, 1);
  column->addWidget(makeFoot());
  connectParts();
  m_picture->showNothing("Reading the file…");
  m_import->setEnabled(false);
}

QComboBox* ImportPanel::addField(QVBoxLayout* column, const QString& name, bool editable) {
  auto* box = new QWidget(this);
  auto* row = widgets::row_in(box, {12, 2, 12, 2});
  auto* label = widgets::quiet_label(name, box);
  label->setFixedWidth(82);
  auto* field = new QComboBox(box);
  field->setAccessibleName(name);
  if (editable) widgets::make_typeable(*field);
  field->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  label->setBuddy(field);
  row->addWidget(label);
  row->addWidget(field, 1);
  column->addWidget(box);
  return field;
}

/// Why a person is asked, before everything that can be answered.
QWidget* ImportPanel::makeReason() {
  m_reason = new QLabel(this);
  m_reason->setObjectName("reason");
  m_reason->setAccessibleName("Reason");
  m_reason->setWordWrap(true);
  m_reason->setTextFormat(Qt::PlainText);
  m_reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_reason->setContentsMargins(12, 8, 12, 8);
  m_reason->hide();
  return m_reason;
}

QWidget* ImportPanel::makeFileColumn() {
  auto* side = new QWidget(this);
  side->setObjectName("panel");
  side->setFixedWidth(262);
  auto* column = widgets::column_in(side, {0, 6, 0, 6}, 2);
  column->addWidget(new widgets::SectionHeader("File", side));
  m_file = small_label(side);
  m_file->setContentsMargins(12, 0, 12, 6);
  column->addWidget(m_file);
  column->addWidget(new widgets::SectionHeader("In this file", side));
  m_performer = addField(column, "Performer");
  m_animation = addField(column, "Animation");
  m_order = addField(column, "Joint order");
  m_facts = small_label(side);
  m_facts->setContentsMargins(12, 4, 12, 4);
  column->addWidget(m_facts);
  column->addStretch(1);
  return side;
}

QWidget* ImportPanel::makePicture() {
  auto* centre = new QWidget(this);
  auto* column = widgets::column_in(centre, {10, 10, 10, 8});
  auto* head = new QHBoxLayout;
  m_time = small_label(centre);
  m_names = new QToolButton(centre);
  m_names->setObjectName("chip");
  m_names->setText("Names at points");
  m_names->setCheckable(true);
  m_names->setChecked(true);
  head->addWidget(m_time, 1);
  head->addWidget(m_names);
  column->addLayout(head);
  m_picture = new widgets::MotionPicture(centre);
  m_picture->setToolTip("Drag to turn, or use the arrow keys");
  column->addWidget(m_picture, 1);
  auto* row = new QHBoxLayout;
  m_play = new QToolButton(centre);
  m_play->setObjectName("quiet");
  widgets::describe(*m_play, "Play", "Play");
  m_play->setCheckable(true);
  m_frame = new QSlider(Qt::Horizontal, centre);
  m_frame->setAccessibleName("Frame of the picture");
  row->addWidget(m_play);
  row->addWidget(m_frame, 1);
  column->addLayout(row);
  return centre;
}

QWidget* ImportPanel::makeSpaceColumn() {
  auto* side = new QWidget(this);
  side->setObjectName("panel");
  side->setFixedWidth(318);
  auto* column = widgets::column_in(side, {0, 6, 0, 6}, 2);
  column->addWidget(new widgets::SectionHeader("Space and time", side));
  const auto add_note = [&](QLabel*& note) {
    note = small_label(side);
    auto* row = widgets::nested_row({106, 0, 12, 4});
    row->addWidget(note);
    column->addLayout(row);
  };
  m_unit = addField(column, "Unit", true);
  add_note(m_height);
  m_up = addField(column, "Up axis");
  m_rate = addField(column, "Frame rate", true);
  m_floor = addField(column, "Floor", true);
  add_note(m_toes);
  column->addWidget(new widgets::SectionHeader("Joints", side));
  m_joints = addField(column, "Joint map");
  m_found = small_label(side);
  m_found->setContentsMargins(12, 2, 12, 2);
  column->addWidget(m_found);
  m_table = new QTableWidget(joint_count, 2, side);
  m_table->setAccessibleName("Joints and what they were found from");
  m_table->horizontalHeader()->hide();
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(22);
  m_table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  m_table->setColumnWidth(0, 92);
  m_table->setShowGrid(false);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setSelectionMode(QAbstractItemView::NoSelection);
  m_table->setTabKeyNavigation(false);
  auto* list = widgets::nested_row({8, 0, 4, 0});
  list->addWidget(m_table);
  column->addLayout(list, 3);
  m_warnings = new QLabel;
  m_warnings->setObjectName("warnings");
  m_warnings->setAccessibleName("Warnings");
  m_warnings->setWordWrap(true);
  m_warnings->setTextFormat(Qt::PlainText);
  m_warnings->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_warnings->setAlignment(Qt::AlignTop);
  m_warnings->setContentsMargins(10, 8, 10, 8);
  m_warningsArea = new QScrollArea(side);
  m_warningsArea->setWidgetResizable(true);
  m_warningsArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_warningsArea->setWidget(m_warnings);
  auto* frame = widgets::nested_column({12, 6, 12, 4});
  frame->addWidget(m_warningsArea);
  column->addLayout(frame);
  return side;
}

QWidget* ImportPanel::makeFoot() {
  auto* foot = new QWidget(this);
  foot->setObjectName("panel");
  auto* row = widgets::row_in(foot, {12, 10, 12, 10});
  m_remember = new QCheckBox("Do the same for files like this one", foot);
  m_remember->setToolTip("Files with the same points in this folder, or with a similar name: " +
                         QString::fromStdString(name_pattern(m_reading.file)));
  auto* rules = new QPushButton("Rules…", foot);
  m_state = small_label(foot);
  m_assign = new QPushButton("Assign joints…", foot);
  auto* cancel = new QPushButton("Cancel", foot);
  m_import = new QPushButton("Import", foot);
  m_import->setDefault(true);
  rules->setAutoDefault(false), m_assign->setAutoDefault(false), cancel->setAutoDefault(false);
  row->addWidget(m_remember);
  row->addWidget(rules);
  row->addWidget(m_state, 1);
  for (QPushButton* button : {m_assign, cancel, m_import}) row->addWidget(button);
  connect(rules, &QPushButton::clicked, this, &ImportPanel::rulesRequested);
  connect(m_assign, &QPushButton::clicked, this, [this] { emit jointsRequested(m_view.unmapped); });
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(m_import, &QPushButton::clicked, this, &QDialog::accept);
  return foot;
}

void ImportPanel::connectParts() {
  for (QComboBox* field : {m_performer, m_animation, m_order, m_unit, m_up, m_rate, m_floor, m_joints}) {
    connect(field, qOverload<int>(&QComboBox::activated), this, [this, field] { take(field); });
    if (field->isEditable())
      connect(field->lineEdit(), &QLineEdit::editingFinished, this, [this, field] { take(field); });
  }
  connect(m_frame, &QSlider::valueChanged, this, &ImportPanel::showFrame);
  connect(m_names, &QToolButton::toggled, m_picture, &widgets::MotionPicture::setNames);
  connect(m_play, &QToolButton::toggled, this, [this](bool on) { on ? m_clock.start() : m_clock.stop(); });
  m_clock.setInterval(33);
  connect(&m_clock, &QTimer::timeout, this, [this] {
    if (!m_view.is_readable()) return;
    const double step = m_view.imported.clip.fps * m_clock.interval() / 1000.0;
    const int frames = m_frame->maximum() + 1;
    m_frame->setValue((m_frame->value() + std::max(1, static_cast<int>(std::lround(step)))) % frames);
  });
}

void ImportPanel::setColours(const widgets::Palette& palette) {
  m_palette = palette;
  m_picture->setColours(palette);
  for (auto* header : findChildren<widgets::SectionHeader*>()) header->setColours(palette);
  m_play->setIcon(widgets::icon(widgets::Icon::Play, palette.text));
  setStyleSheet(QString("QLabel#warnings, QLabel#reason { color: %1; background: %2; border: 1px solid %1; } "
                        "QLabel#warnings { border-radius: 5px; }")
                    .arg(palette.warning.name(), widgets::mixed(palette.warning, palette.panel, 0.1).name()));
  if (!m_isWaiting) showJoints();
}

void ImportPanel::setRemembers(bool on) {
  m_remember->setChecked(on);
}

bool ImportPanel::remembers() const {
  return m_remember->isChecked();
}

QString ImportPanel::reason() const {
  return m_reason->isHidden() ? QString() : m_reason->text();
}

QString ImportPanel::warnings() const {
  QStringList all;
  for (const QLabel* label : {m_reason, m_warnings})
    if (!label->isHidden()) all << label->text();
  return all.join("\n\n");
}

void ImportPanel::chooseJoints(const QString& name_or_file) {
  if (name_or_file.toStdString() == m_reading.joint_map) return;
  m_reading.joint_map = name_or_file.toStdString();
  request();
}

void ImportPanel::request() {
  m_isWaiting = true;
  m_import->setEnabled(false);
  m_state->setText("Reading…");
  emit viewRequested(m_reading);
}

/// What was typed stays to be mended; the file is still read as before.
void ImportPanel::refuse(QComboBox* field, const QString& why) {
  m_state->setText(why);
  field->setFocus();
}

void ImportPanel::take(QComboBox* field) {
  if (m_isWaiting && m_view.reading.file.empty()) return;
  MotionReading next = m_reading;
  const auto said = [field] { return field->currentData().toString().toStdString(); };
  if (field->isEditable()) {
    const auto value = number_said(*field);
    const bool may_be_anything = field == m_floor;
    if (value && (!std::isfinite(*value) || (!may_be_anything && *value <= 0)))
      return refuse(field, field->accessibleName() + ": expected a number" +
                               (may_be_anything ? " of metres" : " above 0") + ", or an entry of the list");
    (field == m_unit ? next.metres_per_unit : field == m_rate ? next.fps : next.floor_m) = value;
  } else if (field == m_joints && said() == from_file) {
    const QString file = widgets::choose_file(this, "Joint map or marker model", {},
                                              "Joint maps and marker models (*.json);;All files (*)");
    if (file.isEmpty()) return showFields();
    next.joint_map = file.toStdString();
  } else {
    (field == m_performer   ? next.performer
     : field == m_animation ? next.animation
     : field == m_order     ? next.joints
     : field == m_up        ? next.up
                            : next.joint_map) = said();
    if (field == m_animation) next.performer.clear();
  }
  if (next == m_reading) return;
  m_reading = next;
  request();
}

void ImportPanel::show(const ImportView& view) {
  m_isWaiting = false;
  m_view = view;
  m_reading = view.reading;
  m_state->setText({});
  m_import->setEnabled(view.is_readable());
  m_assign->setVisible(view.unmapped != nullptr);
  showFields();
  showJoints();
  showReason();
  showWarnings();
  showSpace();
  const int last = view.is_readable() ? static_cast<int>(view.imported.clip.poses.size()) - 1 : 0;
  m_frame->setRange(0, last);
  m_frame->setEnabled(last > 0);
  showFrame();
}

void ImportPanel::showFields() {
  const ImportReport& report = m_view.imported.report;
  const bool readable = m_view.is_readable();
  const auto fill = [](QComboBox* box, const QString& first) {
    box->clear();
    box->addItem(first, QString());
  };
  const auto found = [readable](const QString& value, bool guessed) {
    return !readable ? QString("as found") : guessed ? "guessed: " + value : "as found: " + value;
  };
  m_performer->clear();
  for (const std::string& name : m_view.performers)
    m_performer->addItem(QString::fromStdString(name), QString::fromStdString(name));
  m_performer->setCurrentIndex(static_cast<int>(m_view.performer));
  m_performer->parentWidget()->setVisible(m_view.performers.size() > 1);
  m_animation->clear();
  for (const std::string& name : report.animations)
    m_animation->addItem(QString::fromStdString(name), QString::fromStdString(name));
  m_animation->parentWidget()->setVisible(report.animations.size() > 1);
  fill(m_order, "as found");
  for (const JointOrder& order : builtin_joint_orders())
    m_order->addItem(QString::fromStdString(order.name), QString::fromStdString(order.name));
  choose_data(*m_order, QString::fromStdString(m_reading.joints));
  const QString suffix = QFileInfo(QString::fromStdString(m_reading.file)).suffix().toLower();
  m_order->parentWidget()->setVisible(suffix == "npy" || suffix == "npz");

  const bool unit_said = m_reading.metres_per_unit.has_value();
  fill(m_unit, unit_said ? "as found" : found(unit_words(report.metres_per_unit), report.unit_guessed));
  for (const UnitEntry& unit : unit_entries) m_unit->addItem(unit.name, unit.metres);
  choose_data(*m_unit, unit_said ? QVariant(*m_reading.metres_per_unit) : QVariant());
  const QString axis = QString::fromStdString(axis_label(report.up_axis));
  fill(m_up, m_reading.up.empty() ? found(axis, report.up_axis_guessed) : "as found");
  for (const UpAxis up : every_up_axis)
    m_up->addItem(QString::fromStdString(axis_label(up)), QString::fromStdString(name_of(up)));
  choose_data(*m_up, QString::fromStdString(m_reading.up));
  fill(m_rate, m_reading.fps ? "as found" : found(number(report.fps) + " fps", report.fps_guessed));
  for (const double rate : {24.0, 25.0, 30.0, 50.0, 60.0, 100.0, 120.0, 240.0})
    m_rate->addItem(number(rate) + " fps", rate);
  choose_data(*m_rate, m_reading.fps ? QVariant(*m_reading.fps) : QVariant());
  fill(m_floor, m_reading.floor_m ? "as found"
                                  : found(QString::number(-report.floor_shift_m, 'f', 3) + " m",
                                          report.floor_shift_m != 0));
  m_floor->addItem("0 m, as in the file", 0.0);
  if (readable) {
    const double under = std::round((report.floor_y_m - 0.04) * 1000) / 1000;
    m_floor->addItem(QString("%1 m, 4 cm below the toes").arg(under, 0, 'f', 3), under);
  }
  choose_data(*m_floor, m_reading.floor_m ? QVariant(*m_reading.floor_m) : QVariant());

  const QString map = QString::fromStdString(m_reading.joint_map);
  fill(m_joints, map.isEmpty() ? found(QString::fromStdString(report.joint_map), false) : "as found");
  for (const JointMap& one : builtin_joint_maps())
    m_joints->addItem(QString::fromStdString(one.name), QString::fromStdString(one.name));
  for (const MarkerModel& one : builtin_marker_models())
    m_joints->addItem("markers: " + QString::fromStdString(one.name), QString::fromStdString(one.name));
  if (!map.isEmpty() && m_joints->findData(map) < 0) m_joints->addItem(QFileInfo(map).fileName(), map);
  m_joints->addItem("A joint map or marker model in a file…", QString(from_file));
  choose_data(*m_joints, map);
}

void ImportPanel::showJoints() {
  const ImportReport& report = m_view.imported.report;
  const auto is_inferred = [&report](int joint) {
    return std::count(report.inferred_joints.begin(), report.inferred_joints.end(), joint) > 0;
  };
  m_table->setVisible(m_view.is_readable());
  m_found->setText(m_view.is_readable() ? joints_found_words(report) : QString());
  for (int joint = 0; joint < joint_count; ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    const QString points = QString::fromStdString(report.joint_points[j]);
    const QString from = points.isEmpty() ? (is_inferred(joint) ? "computed" : "from the markers")
                                          : (is_inferred(joint) ? "inferred: " : "") + points;
    const QString cells[] = {QString::fromUtf8(joint_names[j].data()), from};
    for (const int column : {0, 1}) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setToolTip(cells[column]);
      item->setForeground(is_inferred(joint) ? m_palette.warning
                          : column == 1      ? m_palette.secondary
                                             : m_palette.text);
      m_table->setItem(joint, column, item);
    }
  }
}

void ImportPanel::showReason() {
  QStringList lines;
  if (m_view.trouble) lines << "The file cannot be read: " + words(*m_view.trouble);
  for (const std::string& question : m_view.questions())
    lines << "Please check: " + widgets::text(question) + ".";
  m_reason->setText(lines.join("\n"));
  m_reason->setVisible(!lines.isEmpty());
}

void ImportPanel::showWarnings() {
  QStringList lines;
  for (const ImportWarning& warning : m_view.imported.report.warnings)
    if (!warning.asks) lines << widgets::text(warning.detail);
  m_warnings->setText(lines.join("\n\n"));
  m_warnings->parentWidget()->parentWidget()->setVisible(!lines.isEmpty());
  m_warnings->setVisible(!lines.isEmpty());
  fitWarnings();
}

/// As tall as its text, so that no line is cut; a longer one scrolls by whole lines.
void ImportPanel::fitWarnings() {
  constexpr int most_lines = 11;
  const QMargins margins = m_warnings->contentsMargins();
  const int around = margins.top() + margins.bottom() + 2 * m_warningsArea->frameWidth() + 2;
  const int line = m_warnings->fontMetrics().lineSpacing();
  const int whole =
      m_warnings->heightForWidth(m_warningsArea->viewport()->width()) + 2 * m_warningsArea->frameWidth();
  m_warningsArea->setFixedHeight(std::min(whole, most_lines * line + around));
  m_warningsArea->verticalScrollBar()->setSingleStep(line);
}

void ImportPanel::showSpace() {
  const ImportReport& report = m_view.imported.report;
  const Clip& clip = m_view.imported.clip;
  m_file->setText(QString::fromStdString(m_reading.file));
  m_height->setVisible(m_view.is_readable());
  m_toes->setVisible(m_view.is_readable());
  m_facts->setVisible(m_view.is_readable());
  if (!m_view.is_readable()) return;
  m_height->setText(QString("%1 m to the head joint").arg(report.height_m, 0, 'f', 2));
  const std::optional<double> floor_m = m_view.floor_to_enter();
  m_toes->setText(
      QString("the toes rest at %1 m in the file").arg(report.floor_y_m, 0, 'f', 3) +
      (floor_m ? QString("; enter %1 m if the feet should stand on the floor").arg(*floor_m, 0, 'f', 3)
               : QString()));
  m_toes->setStyleSheet(floor_m ? QString("color: %1").arg(m_palette.warning.name()) : QString());
  m_facts->setText(QString("%1 frames · %2 s · moves %3 m")
                       .arg(clip.poses.size())
                       .arg(static_cast<double>(clip.poses.size()) / clip.fps, 0, 'f', 1)
                       .arg(m_view.moves_m, 0, 'f', 1));
  widgets::PicturedSpace space;
  space.high.y() = std::max(report.height_m + 0.15, 0.5);
  space.height = report.height_m;
  space.height_words = QString::number(report.height_m, 'f', 2) + " m";
  // A person of another size is shown on a grid that still has lines.
  space.grid = std::pow(10.0, std::floor(std::log10(std::max(report.height_m, 1e-3)))) / 2;
  m_picture->setSpace(space);
}

void ImportPanel::showFrame() {
  showTime();
  if (!m_view.is_readable())
    return m_picture->showNothing(m_view.trouble ? words(*m_view.trouble) : QString("Reading the file…"));
  const auto frame = static_cast<std::size_t>(m_frame->value());
  widgets::PicturedFrame shown;
  shown.pose = m_view.imported.clip.poses[frame];
  shown.known.fill(true);
  shown.points = shown.pose;
  shown.is_body = true;
  for (std::size_t j = 0; j < joint_count; ++j) {
    const std::string& points = m_view.imported.report.joint_points[j];
    const bool is_one_point = !points.empty() && points.find(" + ") == std::string::npos;
    shown.names.push_back(is_one_point ? points : std::string(joint_names[j]));
  }
  m_picture->show(shown);
}

void ImportPanel::showTime() {
  if (!m_view.is_readable()) return m_time->clear();
  const double fps = m_view.imported.clip.fps;
  m_time->setText(QString("%1 s · frame %2 · %3 fps")
                      .arg(m_frame->value() / fps, 0, 'f', 3)
                      .arg(m_frame->value())
                      .arg(number(fps)));
}

}  // namespace abrazo::app

#include "app/workbench/library/mapping_dialog.hpp"

#include <QComboBox>
#include <QCompleter>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QStyledItemDelegate>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/dialog_size.hpp"
#include "app/workbench/base/error_words.hpp"
#include "app/workbench/library/mapping_words.hpp"
#include "app/workbench/library/marker_table.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/statistics.hpp"
#include "core/base/text.hpp"
#include "core/opening/joint_maps.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/library/motion_picture.hpp"

namespace abrazo::app {
namespace {

enum Column { Joint, Points, Source };

std::size_t at(int joint) {
  return static_cast<std::size_t>(joint);
}

const char* rule_words(JointGuess::By by) {
  switch (by) {
    case JointGuess::By::Name:
      return "by name ?";
    case JointGuess::By::Place:
      return "by place ?";
    case JointGuess::By::Others:
      return "estimated ?";
    case JointGuess::By::Nothing:
      return "";
  }
  return "";
}

/// Completes the name that is being typed, also behind a weight or a plus: "0.5 LASI + 0.5 RA".
class PointCompleter : public QCompleter {
 public:
  PointCompleter(const QStringList& points, QObject* parent) : QCompleter(points, parent) {
    setCaseSensitivity(Qt::CaseInsensitive);
    setFilterMode(Qt::MatchContains);
  }
  QStringList splitPath(const QString& typed) const override { return {typed.mid(begin(typed))}; }
  QString pathFromIndex(const QModelIndex& index) const override {
    const auto* line = qobject_cast<const QLineEdit*>(widget());
    const QString typed = line ? line->text() : QString();
    return typed.left(begin(typed)) + QCompleter::pathFromIndex(index);
  }

 private:
  /// Where the last name begins.
  static QString::size_type begin(const QString& typed) {
    const auto plus = typed.lastIndexOf(" + ");
    const auto term = plus < 0 ? 0 : plus + 3;
    const auto blank = typed.indexOf(' ', term);
    bool is_weight = false;
    if (blank > 0) (void)typed.mid(term, blank - term).toDouble(&is_weight);
    return is_weight ? blank + 1 : term;
  }
};

/// Edits the points of a joint with their names at hand.
class PointDelegate : public QStyledItemDelegate {
 public:
  PointDelegate(QStringList points, QObject* parent)
      : QStyledItemDelegate(parent), m_points(std::move(points)) {}
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override {
    QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
    if (auto* line = qobject_cast<QLineEdit*>(editor)) line->setCompleter(new PointCompleter(m_points, line));
    return editor;
  }

 private:
  QStringList m_points;
};

/// A recording may be hundreds of megabytes.
NamedMotion without_frames(const NamedMotion& motion) {
  NamedMotion about;
  about.name = motion.name;
  about.points = motion.points;
  about.parents = motion.parents;
  about.fps = motion.fps;
  about.metres_per_unit = motion.metres_per_unit;
  about.up_axis = motion.up_axis;
  about.animations = motion.animations;
  about.warnings = motion.warnings;
  return about;
}

}  // namespace

MappingDialog::MappingDialog(NamedMotion motion, QWidget* parent)
    : QDialog(parent),
      m_motion(std::move(motion)),
      m_table(new QTableWidget(joint_count, 3, this)),
      m_markers(new MarkerTable(m_motion, this)),
      m_pages(new QTabWidget(this)),
      m_preview(new widgets::MotionPicture(this)),
      m_frame(new QSlider(Qt::Horizontal, this)),
      m_palette(widgets::palette_of(widgets::Theme::Dark)) {
  setWindowTitle(QString("Which points are which joints? · %1").arg(QString::fromStdString(m_motion.name)));
  resize_within_screen(*this, {1080, 760});
  auto* column = widgets::column_in(this, {16, 14, 16, 14}, 10);
  column->addWidget(new QLabel(QString("No joint map fits the %1 points of this file. Say which joints they "
                                       "are, or where on the body if they "
                                       "are markers. Guesses are marked.")
                                   .arg(m_motion.points.size()),
                               this));
  auto* row = new QHBoxLayout;
  m_table->setAccessibleName("Joints and their points");
  m_table->setHorizontalHeaderLabels({"Joint", "Points", "Found"});
  widgets::make_rows(*m_table, 24);
  m_table->setTabKeyNavigation(false);
  m_table->horizontalHeader()->setSectionResizeMode(Points, QHeaderView::Stretch);
  m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_table->setColumnWidth(Source, 96);
  QStringList points;
  for (const std::string& point : m_motion.points) points << QString::fromStdString(point);
  m_table->setItemDelegateForColumn(Points, new PointDelegate(points, m_table));
  m_pages->addTab(m_table, "Joints");
  m_pages->addTab(m_markers, "Markers");
  row->addWidget(m_pages, 5);
  auto* side = new QVBoxLayout;
  side->addWidget(m_preview, 1);
  m_frame->setAccessibleName("Frame of the preview");
  m_frame->setRange(0, std::max(0, static_cast<int>(m_motion.frames.size()) - 1));
  m_frame->setValue(static_cast<int>(frame_to_look_at(m_motion)));
  side->addWidget(m_frame);
  row->addLayout(side, 4);
  column->addLayout(row, 1);
  column->addWidget(makeFacts());
  column->addWidget(makeState());
  column->addWidget(makeFoot());
  connectParts();
  guessAgain();
  if (names_say_nothing(m_motion)) guessFromMotion();
}

MappingDialog::~MappingDialog() {
  if (m_job) Job::retire(std::move(m_job), parent());
}

QWidget* MappingDialog::makeFacts() {
  auto* box = new QWidget(this);
  auto* row = widgets::row_in(box);
  const auto add = [row](const QString& name, QWidget* field) {
    auto* label = widgets::quiet_label(name);
    label->setBuddy(field);
    field->setAccessibleName(name);
    row->addWidget(label);
    row->addWidget(field);
  };
  m_up = new QComboBox(box);
  m_up->addItem("as found");
  for (const UpAxis up : every_up_axis) m_up->addItem(QString::fromStdString(axis_label(up)));
  m_unit = new QComboBox(box);
  m_unit->addItem("as found", 0.0);
  for (const auto& [name, metres] :
       {std::pair("metres", 1.0), {"centimetres", 0.01}, {"millimetres", 0.001}, {"inches", 0.0254}})
    m_unit->addItem(name, metres);
  m_rate = new QLineEdit(box);
  m_rate->setPlaceholderText("as found");
  m_rate->setMaximumWidth(90);
  add("Up axis", m_up);
  add("Unit", m_unit);
  add("Frame rate", m_rate);
  m_facts = new QLabel(box);
  m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addSpacing(12);
  row->addWidget(m_facts, 1);
  return box;
}

/// Two lines, so that nothing moves whatever is said.
QWidget* MappingDialog::makeState() {
  m_state = new QLabel(this);
  m_state->setObjectName("state");
  m_state->setWordWrap(true);
  m_state->setTextFormat(Qt::PlainText);
  m_state->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  m_state->setFixedHeight(2 * m_state->fontMetrics().lineSpacing() + 4);
  return m_state;
}

QWidget* MappingDialog::makeFoot() {
  auto* foot = new QWidget(this);
  auto* row = widgets::row_in(foot);
  auto* load = new QPushButton("Load…", foot);
  load->setToolTip("A joint map or a marker model");
  m_save = new QPushButton("Save map…", foot);
  m_again = new QPushButton("Guess again", foot);
  m_from_motion = new QPushButton("Guess from motion", foot);
  m_from_motion->setToolTip(
      "Where each marker is on the body, from positions, symmetry and distances over time");
  auto* cancel = new QPushButton("Cancel", foot);
  m_use = new QPushButton("Use", foot);
  m_use->setDefault(true);
  m_use->setToolTip("Files with the same point names are then read this way without a question");
  for (QWidget* widget : std::initializer_list<QWidget*>{load, m_save, m_again, m_from_motion})
    row->addWidget(widget);
  row->addStretch(1);
  row->addWidget(cancel);
  row->addWidget(m_use);
  connect(load, &QPushButton::clicked, this, &MappingDialog::load);
  connect(m_save, &QPushButton::clicked, this, &MappingDialog::save);
  connect(m_again, &QPushButton::clicked, this, &MappingDialog::guessAgain);
  connect(m_from_motion, &QPushButton::clicked, this, &MappingDialog::guessFromMotion);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(m_use, &QPushButton::clicked, this, &QDialog::accept);
  return foot;
}

void MappingDialog::connectParts() {
  connect(m_table, &QTableWidget::cellChanged, this, [this](int joint, int column) {
    if (!m_filling && column == Points) setPoints(joint, m_table->item(joint, Points)->text());
  });
  connect(m_table, &QTableWidget::currentCellChanged, this, [this](int joint) { chooseJoint(joint); });
  connect(m_preview, &widgets::MotionPicture::pointClicked, this, [this](int point) {
    if (namesMarkers())
      m_markers->setCurrentCell(point, MarkerTable::Place);
    else
      togglePoint(point);
  });
  connect(m_markers, &QTableWidget::currentCellChanged, this, &MappingDialog::showFrame);
  connect(m_markers, &MarkerTable::changed, this, &MappingDialog::showFacts);
  connect(m_markers, &MarkerTable::refused, this, &MappingDialog::refuse);
  for (QTableWidget* table : {m_table, static_cast<QTableWidget*>(m_markers)})
    connect(table, &QTableWidget::currentCellChanged, this, &MappingDialog::leaveRefusal);
  connect(m_pages, &QTabWidget::currentChanged, this, &MappingDialog::showPage);
  connect(m_frame, &QSlider::valueChanged, this, &MappingDialog::showFrame);
  connect(m_up, qOverload<int>(&QComboBox::activated), this, &MappingDialog::changed);
  connect(m_unit, qOverload<int>(&QComboBox::activated), this, &MappingDialog::changed);
  connect(m_rate, &QLineEdit::editingFinished, this, &MappingDialog::changed);
}

void MappingDialog::setColours(const widgets::Palette& palette) {
  m_palette = palette;
  m_preview->setColours(palette);
  m_markers->setColours(palette);
  changed();
}

void MappingDialog::guessAgain() {
  JointGuess guess = guess_joints(m_motion, at(m_frame->value()));
  for (const int joint : estimate_missing_joints(guess.map)) guess.by[at(joint)] = JointGuess::By::Others;
  m_map = std::move(guess.map);
  m_given.clear();
  m_by = guess.by;
  changed();
  m_table->setCurrentCell(m_joint, Points);
}

bool MappingDialog::namesMarkers() const {
  return m_pages->currentWidget() == m_markers;
}

MarkerModel MappingDialog::model() const {
  return m_markers->naming().model(m_motion.name);
}

Result<std::string> MappingDialog::keep(const QString& folder) const {
  return namesMarkers() ? remember_map(model(), folder.toStdString())
                        : remember_map(m_map, folder.toStdString());
}

void MappingDialog::guessFromMotion() {
  if (m_job) return;
  m_pages->setCurrentWidget(m_markers);
  m_from_motion->setEnabled(false);
  tell("Guessing where the markers are…");
  // A copy: the work may outlive the dialog.
  m_job = std::make_unique<Job>([this, motion = m_motion](const Progress&) -> Job::Finish {
    return [this, guess = guess_markers(motion)] { showGuess(guess); };
  });
  connect(m_job.get(), &Job::finished, this, [this] {
    Job::retire(std::move(m_job), this);
    m_from_motion->setEnabled(true);
  });
}

void MappingDialog::showGuess(const Result<MarkerGuess>& guess) {
  if (guess)
    m_markers->propose(*guess);
  else
    tell(words(guess.error()));
}

void MappingDialog::showPage() {
  m_save->setText(namesMarkers() ? "Save marker model…" : "Save map…");
  m_again->setVisible(!namesMarkers());
  showFrame();
  showFacts();
}

void MappingDialog::showRow(int joint) {
  const auto& rules = m_map.rules[at(joint)];
  const QString cells[] = {QString::fromUtf8(joint_names[at(joint)].data()),
                           rules.empty() ? QString() : in_words(rules.front()),
                           rules.empty() ? "nothing yet" : rule_words(m_by[at(joint)])};
  for (int column : {Joint, Points, Source}) {
    auto* item = m_table->item(joint, column);
    if (!item) m_table->setItem(joint, column, item = new QTableWidgetItem);
    item->setText(cells[column]);
    item->setToolTip(column == Points ? "A point, or weights: 0.5 LASI + 0.5 RASI" : QString());
    item->setFlags(column == Points ? item->flags() | Qt::ItemIsEditable
                                    : item->flags() & ~Qt::ItemIsEditable);
    item->setForeground(column == Source && rules.empty() ? m_palette.warning
                        : column == Source                ? m_palette.secondary
                                                          : m_palette.text);
  }
}

void MappingDialog::changed() {
  m_filling = true;
  for (int joint = 0; joint < joint_count; ++joint) showRow(joint);
  m_filling = false;
  showFrame();
  showFacts();
}

void MappingDialog::setPoints(int joint, const QString& text) {
  const auto rule = rule_of_words(text, m_motion.points);
  if (!rule) {
    m_filling = true;
    showRow(joint);
    m_filling = false;
    return refuse(words(rule.error()));
  }
  m_given.insert(joint);
  auto& rules = m_map.rules[at(joint)];
  rules.clear();
  if (!rule->terms.empty()) rules.push_back(*rule);
  m_by[at(joint)] = JointGuess::By::Nothing;
  m_joint = joint;
  changed();
}

void MappingDialog::togglePoint(int point) {
  m_given.insert(m_joint);
  const std::string& name = m_motion.points[at(point)];
  auto& rules = m_map.rules[at(m_joint)];
  // Explicit choices replace guesses.
  if (rules.empty() || m_by[at(m_joint)] != JointGuess::By::Nothing) rules.assign(1, JointRule{});
  m_by[at(m_joint)] = JointGuess::By::Nothing;
  auto& terms = rules.front().terms;
  if (std::erase_if(terms, [&](const JointRule::Term& term) { return term.point == name; }) == 0)
    terms.push_back({name, 1});
  for (JointRule::Term& term : terms) term.weight = 1.0 / static_cast<double>(terms.size());
  if (terms.empty()) rules.clear();
  changed();
}

void MappingDialog::chooseJoint(int joint) {
  if (joint < 0) return;
  m_joint = joint;
  if (m_table->currentRow() != joint) m_table->setCurrentCell(joint, Points);
  showFrame();
}

Positions MappingDialog::upright(const Positions& points) const {
  const Eigen::RowVector3d extent = points.array().isNaN().select(0, points).colwise().maxCoeff() -
                                    points.array().isNaN().select(0, points).colwise().minCoeff();
  Positions turned = points;
  turn_to_y_up(turned, m_up->currentIndex() > 0  ? every_up_axis[at(m_up->currentIndex() - 1)]
                       : extent.z() > extent.y() ? UpAxis::Z
                                                 : UpAxis::Y);
  return turned;
}

void MappingDialog::showFrame() {
  if (m_motion.frames.empty()) return;
  widgets::PicturedFrame shown;
  shown.points = upright(m_motion.frames[at(m_frame->value())]);
  shown.names = m_motion.points;
  if (namesMarkers()) {
    if (m_markers->currentRow() >= 0) shown.chosen = {m_markers->currentRow()};
    m_preview->setSpace(spaceOf());
    return m_preview->show(shown);
  }
  shown.joint = m_joint;
  const JointBinding binding = bind_joints(m_map, m_motion.points);
  for (int j = 0; j < joint_count; ++j) {
    for (const auto& [point, weight] : binding.terms[at(j)])
      shown.pose.row(j) += weight * shown.points.row(point);
    shown.known[at(j)] = !binding.terms[at(j)].empty() && shown.pose.row(j).allFinite();
  }
  for (const auto& [point, weight] : binding.terms[at(m_joint)]) shown.chosen.push_back(point);
  m_preview->setSpace(spaceOf());
  m_preview->show(shown);
}

/// As tall as the points are in most frames, over the lowest of them.
widgets::PicturedSpace MappingDialog::spaceOf() const {
  std::vector<double> lows, highs;
  constexpr std::size_t most_frames = 60;
  const std::size_t step = std::max<std::size_t>(1, m_motion.frames.size() / most_frames);
  for (std::size_t f = 0; f < m_motion.frames.size(); f += step) {
    const Positions points = upright(m_motion.frames[f]);
    double low = 1e300, high = -1e300;
    for (Eigen::Index p = 0; p < points.rows(); ++p)
      if (points.row(p).allFinite()) low = std::min(low, points(p, 1)), high = std::max(high, points(p, 1));
    if (low <= high) lows.push_back(low), highs.push_back(high);
  }
  widgets::PicturedSpace space;
  if (lows.empty()) return space;
  space.ground = quantile(lows, 0.05);
  space.high.y() = quantile(highs, 0.5) + 1e-9;
  space.grid = (space.high.y() - space.ground) / 4;
  return space;
}

MotionReading MappingDialog::said() const {
  MotionReading reading;
  if (m_up->currentIndex() > 0) reading.up = name_of(every_up_axis[at(m_up->currentIndex() - 1)]);
  if (const double unit = m_unit->currentData().toDouble(); unit > 0) reading.metres_per_unit = unit;
  if (const auto rate = parse_number(m_rate->text().trimmed().toStdString()); rate && *rate > 0)
    reading.fps = *rate;
  return reading;
}

/// Joints without points; of markers the places that a body needs.
QStringList MappingDialog::missing() const {
  QStringList names;
  if (namesMarkers())
    for (const std::string& place : missing_markers(model(), m_motion.points))
      names << QString::fromStdString(place);
  else
    for (const int joint : bind_joints(m_map, m_motion.points).missing)
      names << QString::fromUtf8(joint_names[at(joint)].data());
  return names;
}

/// Imports a few frames in the same way as the whole file later, and shows the result.
void MappingDialog::showFacts() {
  const QStringList missing = this->missing();
  const QString counted =
      namesMarkers() ? QString::fromStdString(m_markers->naming().counted()) + ". " : QString();
  m_use->setEnabled(missing.isEmpty());
  m_facts->clear();
  if (!missing.isEmpty() && namesMarkers()) {
    const MarkerModel named = model();
    return tell(counted + QString::fromStdString(why_not_enough(fit_of(named, m_motion.points))));
  }
  if (!missing.isEmpty())
    return tell(counted + QString("No points yet for %1").arg(missing.mid(0, 5).join(", ")) +
                (missing.size() > 5 ? QString(" and %1 more").arg(missing.size() - 5) : QString()));
  NamedMotion few = without_frames(m_motion);
  constexpr std::size_t most_frames = 40;
  const std::size_t step = std::max<std::size_t>(1, m_motion.frames.size() / most_frames);
  for (std::size_t f = 0; f < m_motion.frames.size(); f += step)
    if (m_motion.frames[f].allFinite() || few.frames.empty()) few.frames.push_back(m_motion.frames[f]);
  const MotionReading reading = said();
  ImportOptions options;
  options.metres_per_unit = reading.metres_per_unit, options.fps = reading.fps;
  options.up_axis = find_up_axis(reading.up);
  if (namesMarkers())
    options.marker_model = model();
  else
    options.joint_map = m_map;
  const auto clip = import_clip(few, options);
  if (!clip) return tell(counted + words(clip.error()));
  const ImportReport& report = clip->report;
  const auto mark = [](bool guessed) { return guessed ? " ?" : ""; };
  m_facts->setText(QString("%1 up%2 · %3 m per unit%4 · %5 fps%6 · head at %7 m")
                       .arg(QString::fromStdString(axis_label(report.up_axis)), mark(report.up_axis_guessed))
                       .arg(report.metres_per_unit, 0, 'g', 5)
                       .arg(mark(report.unit_guessed))
                       .arg(report.fps, 0, 'g', 5)
                       .arg(mark(report.fps_guessed))
                       .arg(report.height_m, 0, 'f', 2));
  tell(counted + (namesMarkers() ? "Enough for a body" : "Every joint has its points"));
}

void MappingDialog::tell(const QString& text) {
  constexpr int longest = 300;  // more would not fit into two lines
  m_said = text;
  m_isRefusal = false;
  m_state->setText(text.size() <= longest ? text : text.left(longest) + " …");
  m_state->setToolTip(widgets::plain_tip(text));
}

void MappingDialog::refuse(const QString& why) {
  tell(why);
  m_isRefusal = true;
}

/// Elsewhere, what was not taken is of no interest any more.
void MappingDialog::leaveRefusal() {
  if (m_isRefusal) showFacts();
}

/// Joints and places that the user gave and that are in no file.
int MappingDialog::assigned() const {
  const auto& rows = m_markers->naming().rows();
  const auto said = std::ranges::count(rows, MarkerNaming::By::Person, &MarkerNaming::Row::by);
  const bool is_saved = m_saved && m_saved->names == model().names;
  return static_cast<int>(m_given.size()) + (is_saved ? 0 : static_cast<int>(said));
}

void MappingDialog::reject() {
  const int lost = assigned();
  const QString what =
      lost == 1 ? "the assignment that you made" : QString("the %1 assignments that you made").arg(lost);
  if (lost > 0 &&
      QMessageBox::question(this, windowTitle(), "Leave without " + what + "?",
                            QMessageBox::Yes | QMessageBox::No, QMessageBox::No) != QMessageBox::Yes)
    return;
  QDialog::reject();
}

void MappingDialog::save() {
  const QString file =
      widgets::choose_new_file(this, namesMarkers() ? "Save marker model" : "Save joint map",
                               QString::fromStdString(m_motion.name) + ".json", ".json",
                               namesMarkers() ? "Marker models (*.json)" : "Joint maps (*.json)");
  if (!file.isEmpty()) saveTo(file);
}

void MappingDialog::saveTo(const QString& file) {
  const Status written = write_whole_file(
      file.toStdString(), namesMarkers() ? marker_model_json(model()) : joint_map_json(m_map));
  const QString what = namesMarkers() ? "Marker model" : "Joint map";
  if (written && namesMarkers()) m_saved = model();
  if (written && !namesMarkers()) m_given.clear();
  tell(written ? what + " written to " + file : words(written.error()));
}

void MappingDialog::load() {
  const QString file = widgets::choose_file(this, "Joint map or marker model", {},
                                            "Joint maps and marker models (*.json);;All files (*)");
  if (!file.isEmpty()) loadFrom(file);
}

void MappingDialog::loadFrom(const QString& file) {
  ImportOptions read;
  const Status chosen = choose_joints(file.toStdString(), read);
  if (!chosen) return tell(words(chosen.error()));
  if (read.marker_model) {
    if (const auto found = m_markers->read(*read.marker_model); !found) return tell(words(found.error()));
    m_saved = model();
    return m_pages->setCurrentWidget(m_markers);
  }
  m_map = *read.joint_map;
  m_given.clear();
  m_by.fill(JointGuess::By::Nothing);
  m_pages->setCurrentWidget(m_table);
  changed();
}

}  // namespace abrazo::app

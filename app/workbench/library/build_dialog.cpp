#include "app/workbench/library/build_dialog.hpp"

#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/choose_button.hpp"
#include "app/workbench/base/dialog_size.hpp"
#include "app/workbench/base/error_words.hpp"
#include "app/workbench/library/build_form.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/library/pair_preview.hpp"

namespace abrazo::app {
namespace {

using widgets::quiet_label;

}  // namespace

BuildDialog::BuildDialog(QWidget* parent)
    : QDialog(parent),
      m_table(new QTableView(this)),
      m_form(new BuildForm(m_model, this)),
      m_preview(new widgets::PairPreview(this)),
      m_remarks(new QListWidget(this)),
      m_progress(new QProgressBar(this)),
      m_palette(widgets::palette_of(widgets::Theme::Dark)) {
  setWindowTitle("Build a library of motion files");
  setAcceptDrops(true);
  resize_within_screen(*this, {1180, 760});
  auto* column = widgets::column_in(this, {16, 14, 16, 14}, 10);
  column->addWidget(makeUserRow());
  column->addWidget(makeOverview(), 1);
  column->addWidget(m_form);
  column->addWidget(makeOutputs());
  m_remarks->setAccessibleName("Problems to check before building");
  m_remarks->setWordWrap(true);
  m_remarks->setIconSize({14, 14});
  m_remarks->setMinimumHeight(50);
  m_remarks->setMaximumHeight(116);
  column->addWidget(m_remarks);
  column->addWidget(makeFoot());
  connectParts();
  showPlan();
}

QWidget* BuildDialog::makeUserRow() {
  m_userRow = new QWidget(this);
  auto* row = widgets::row_in(m_userRow);
  m_userQuestion = new QLabel(m_userRow);
  row->addWidget(m_userQuestion);
  for (auto& button : m_userButtons) {
    button = new QToolButton(m_userRow);
    button->setObjectName("chip");
    row->addWidget(button);
  }
  row->addStretch(1);
  for (int i : {0, 1})
    connect(m_userButtons[i], &QToolButton::clicked, this, [this, i] {
      if (i >= m_model.rowCount()) return;
      const Manifest::Performer& source = m_model.performer(i).source;
      emit userChosen(QString::fromStdString(source.motion.string()),
                      QString::fromStdString(source.skeleton.string()));
    });
  return m_userRow;
}

QWidget* BuildDialog::makeOverview() {
  auto* split = new QSplitter(Qt::Horizontal, this);
  m_table->setModel(&m_model);
  m_table->setAccessibleName("Performers and their takes");
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_table->setShowGrid(false);
  m_table->setAlternatingRowColors(false);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(25);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setHighlightSections(false);
  m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->setIconSize({14, 14});
  m_table->setTabKeyNavigation(false);
  auto* side = new QWidget(split);
  auto* column = widgets::column_in(side, {8, 0, 0, 0}, 8);  // off the border that is dragged
  m_previewHead = quiet_label("Choose a performer to see its take");
  column->addWidget(m_previewHead);
  column->addWidget(m_preview, 1);
  auto* left = new QWidget(split);
  auto* left_column = widgets::column_in(left, {}, 8);
  left_column->addWidget(m_table, 1);
  left_column->addWidget(
      quiet_label("? = guessed. Settings below apply to every selected row; Ctrl+A selects all."));
  split->addWidget(left);
  split->addWidget(side);
  split->setStretchFactor(0, 3);
  split->setStretchFactor(1, 2);
  split->setSizes({720, 420});
  return split;
}

QLineEdit* BuildDialog::addPath(QGridLayout* grid, int row, const QString& name, const QString& tip,
                                const QString& filter, const QString& ending) {
  auto* label = quiet_label(name);
  auto* field = new QLineEdit(this);
  widgets::describe(*field, name, tip);
  field->setPlaceholderText(ending.isEmpty() ? "none" : "not saved");
  field->setClearButtonEnabled(true);
  label->setBuddy(field);
  auto* choose = choose_button(name, this);
  connect(choose, &QToolButton::clicked, this, [this, field, name, filter, ending] {
    const QString file = ending.isEmpty()
                             ? widgets::choose_file(this, name, field->text(), filter)
                             : widgets::choose_new_file(this, name, field->text(), ending, filter);
    if (file.isEmpty()) return;
    field->setText(file);
    if (field == m_labels) offerLabels();
  });
  const int column = ending.isEmpty() ? 0 : 3;
  grid->addWidget(label, row, column);
  grid->addWidget(field, row, column + 1);
  grid->addWidget(choose, row, column + 2);
  return field;
}

QWidget* BuildDialog::makeOutputs() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  auto* label = quiet_label("Library name");
  m_name = new QLineEdit(QString::fromStdString(m_model.plan().name), box);
  m_name->setAccessibleName("Library name");
  label->setBuddy(m_name);
  grid->addWidget(label, 0, 0);
  grid->addWidget(m_name, 0, 1, 1, 2);
  m_labels = addPath(grid, 1, "Labels", "CSV: take,start_frame,end_frame,label[,detail,confidence]",
                     "Labels (*.csv *.eaf *.json *.TextGrid *.txt);;All files (*)");
  m_library = addPath(grid, 0, "Save library", "Library file (.h5) that opens without building",
                      "Libraries (*.h5)", ".h5");
  m_manifest =
      addPath(grid, 1, "Save manifest",
              "A .json with all choices made here: “abrazo library build” makes the same library from it",
              "Manifests (*.json)", ".json");
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(4, 1);
  return box;
}

QWidget* BuildDialog::makeFoot() {
  auto* foot = new QWidget(this);
  auto* row = widgets::row_in(foot);
  auto* add = m_add = new QPushButton("Add files…", foot);
  m_startOver = new QPushButton("Start over", foot);
  widgets::describe(*m_startOver, "Start over", "Remove all rows. Closing the dialog keeps them");
  m_state = new QLabel(foot);
  m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_state->setWordWrap(true);
  m_progress->setRange(0, 1000);
  m_progress->setFixedWidth(220);
  m_progress->setTextVisible(false);
  m_progress->setAccessibleName("Progress");
  m_progress->hide();
  m_cancel = new QPushButton("Close", foot);
  m_build = new QPushButton("Build", foot);
  m_build->setDefault(true);
  row->addWidget(add);
  row->addWidget(m_startOver);
  row->addWidget(m_state, 1);
  row->addWidget(m_progress);
  row->addWidget(m_cancel);
  row->addWidget(m_build);
  connect(add, &QPushButton::clicked, this, &BuildDialog::chooseFiles);
  return foot;
}

void BuildDialog::offerLabels() {
  if (m_labels->text().toStdString() != m_model.plan().labels.string())
    emit labelsRequested(m_labels->text());
}

void BuildDialog::connectParts() {
  connect(&m_model, &BuildPlanModel::planChanged, this, &BuildDialog::showPlan);
  connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &BuildDialog::showChosen);
  connect(m_form, &BuildForm::surveyRequested, this, &BuildDialog::surveyRequested);
  connect(m_remarks, &QListWidget::currentRowChanged, this, [this](int row) {
    const int performer = row < 0 ? -1 : m_remarks->item(row)->data(Qt::UserRole).toInt();
    if (performer >= 0) m_table->selectRow(performer);
  });
  connect(m_name, &QLineEdit::textEdited, &m_model, &BuildPlanModel::setName);
  connect(m_labels, &QLineEdit::editingFinished, this, &BuildDialog::offerLabels);
  connect(m_cancel, &QPushButton::clicked, this, &BuildDialog::reject);
  connect(m_startOver, &QPushButton::clicked, this, &BuildDialog::startOverRequested);
  connect(m_build, &QPushButton::clicked, this, &BuildDialog::buildRequested);
}

void BuildDialog::setColours(const widgets::Palette& palette) {
  m_palette = palette;
  m_model.setColours(palette);
  m_preview->setColours(palette);
  showPlan();
}

std::vector<int> BuildDialog::chosenRows() const {
  std::vector<int> rows;
  for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) rows.push_back(index.row());
  std::sort(rows.begin(), rows.end());
  return rows;
}

QStringList BuildDialog::remarks() const {
  QStringList texts;
  for (int i = 0; i < m_remarks->count(); ++i) texts << m_remarks->item(i)->text();
  return texts;
}

BuildOutputs BuildDialog::outputs() const {
  return {m_library->text().trimmed(), m_manifest->text().trimmed()};
}

void BuildDialog::setOutputs(const BuildOutputs& outputs) {
  m_library->setText(outputs.library);
  m_manifest->setText(outputs.manifest);
}

void BuildDialog::setSkeletons(const QStringList& files) {
  m_form->setSkeletons(files);
}

void BuildDialog::showPlan() {
  m_remarks->clear();
  for (const PlanRemark& remark : brought_together(m_model.remarks())) {
    const bool warning = remark.kind == PlanRemark::Kind::Warning;
    const QString head = remark.kind == PlanRemark::Kind::Obstacle   ? "To do: "
                         : remark.kind == PlanRemark::Kind::Question ? "Check: "
                                                                     : "";
    auto* item = new QListWidgetItem(
        widgets::icon(warning ? widgets::Icon::Information : widgets::Icon::Warning,
                      warning ? m_palette.secondary : m_palette.warning),
        head + QString::fromStdString(Warning{remark.whole(), remark.hint}.text(window_words)), m_remarks);
    item->setToolTip(widgets::plain_tip(item->text()));
    item->setData(Qt::UserRole, remark.performer);
  }
  m_remarks->setVisible(m_remarks->count() > 0);
  m_labels->setText(QString::fromStdString(m_model.plan().labels.string()));
  m_build->setEnabled(!m_busy && m_model.canBuild());
  m_startOver->setVisible(m_model.rowCount() > 0);
  (m_model.rowCount() == 0 ? m_add : m_build)->setDefault(true);  // what Return does
  if (m_model.rowCount() > 0 && chosenRows().empty()) m_table->selectRow(0);
  showUserRow();
  showChosen();
}

void BuildDialog::showUserRow() {
  const bool two = m_model.rowCount() == 2 && m_model.performer(0).in_the_file == 1;
  m_userRow->setVisible(two);
  if (!two) return;
  m_userQuestion->setText("Two motions. “Build” makes one take of both. Or one of them plays the user:");
  for (int i : {0, 1}) {
    const PlannedPerformer& performer = m_model.performer(i);
    m_userButtons[i]->setText(QString::fromStdString(performer.source.motion.filename().string()) +
                              " plays the user");
    m_userButtons[i]->setEnabled(performer.clip != nullptr);
  }
}

void BuildDialog::showChosen() {
  const std::vector<int> rows = chosenRows();
  m_form->show(rows);
  if (rows.empty()) {
    m_preview->show({}, {});
    return;
  }
  const int first = rows.front(), partner = partner_of(m_model.plan(), first);
  const auto clip_of = [this](int row) {
    return row < 0 ? widgets::PreviewedClip{}
                   : widgets::PreviewedClip{m_model.performer(row).clip, m_model.performer(row).source.start};
  };
  // As in the manifest, A is the first one.
  const int a = partner >= 0 ? std::min(first, partner) : first;
  const int b = partner >= 0 ? std::max(first, partner) : -1;
  m_preview->show(clip_of(a), clip_of(b));
  const QString take = QString::fromStdString(m_model.performer(first).take);
  m_previewHead->setText(take.isEmpty()
                             ? QString::fromStdString(m_model.performer(first).name) + ", in no take"
                             : "Take " + take);
}

void BuildDialog::showProgress(const QString& doing, double fraction) {
  m_busy = true;
  m_progress->show();
  m_progress->setValue(static_cast<int>(1000 * fraction));
  m_state->setText(doing);
  m_cancel->setText("Cancel");
  m_build->setEnabled(false);
  m_startOver->setEnabled(false);
}

void BuildDialog::endProgress() {
  m_busy = false;
  m_progress->hide();
  m_state->clear();
  m_cancel->setText("Close");
  m_build->setEnabled(m_model.canBuild());
  m_startOver->setEnabled(true);
}

void BuildDialog::showError(const QString& text) {
  endProgress();
  m_state->setText(text);
}

void BuildDialog::reject() {
  if (m_busy) return emit cancelRequested();
  QDialog::reject();
}

void BuildDialog::chooseFiles() {
  const QStringList files =
      widgets::choose_files(this, "Add files", {},
                            QString("Motions, skeletons, labels (%1 *.eaf *.json *.TextGrid *.txt);;All files (*)")
                                .arg(QString::fromStdString(motion_file_patterns(true))));
  if (files.isEmpty()) return;
  m_table->setFocus();  // what Return presses is Build again
  emit filesOffered(files);
}

void BuildDialog::keyPressEvent(QKeyEvent* event) {
  const bool is_return = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (is_return && !qobject_cast<QPushButton*>(focusWidget())) return;
  QDialog::keyPressEvent(event);
}

void BuildDialog::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void BuildDialog::dropEvent(QDropEvent* event) {
  QStringList files;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  if (!files.isEmpty()) emit filesOffered(files);
}

}  // namespace abrazo::app

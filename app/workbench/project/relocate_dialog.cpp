#include "app/workbench/project/relocate_dialog.hpp"

#include "widgets/common/file_dialog.hpp"
#include "widgets/common/plain_text.hpp"

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <future>

namespace abrazo::app {
namespace {

enum FileColumn { File, For, Place };

QString name_of(const DataReference& reference) {
  return QFileInfo(QString::fromStdString(reference.absolute_path)).fileName();
}

QString use_of(const DataReference& reference) {
  const std::string_view text = text_of(reference.use);
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

QString looked_at(const FoundData& found) {
  QStringList places;
  for (const std::string& place : found.looked) places << QString::fromStdString(place);
  return places.join("\n");
}

/// Those with its ending: it may have another name now.
QString files_like(const QString& name) {
  const QString ending = QFileInfo(name).suffix();
  return ending.isEmpty() ? name + " (" + name + ")" : QString("%1 files (*.%1)").arg(ending);
}

constexpr std::chrono::milliseconds look_for_cancel(100);

/// Everything but `answer` belongs to the window's thread.
struct Question {
  std::promise<std::optional<Places>> answer;
  QPointer<RelocateDialog> dialog;
};

void open_dialog(QWidget* window, const std::shared_ptr<const OpenedProject>& project,
                 const std::shared_ptr<Question>& question) {
  if (window == nullptr) return question->answer.set_value({});
  auto* dialog = new RelocateDialog(project, window);
  question->dialog = dialog;
  QObject::connect(dialog, &QDialog::finished, dialog, [dialog, question](int result) {
    question->answer.set_value(result == QDialog::Accepted ? std::optional(dialog->places()) : std::nullopt);
  });
  dialog->open();
}

}  // namespace

LocateMissing asking_for_places(QWidget& window) {
  // The application outlives workers; the window may not.
  return [window = QPointer(&window)](const std::shared_ptr<const OpenedProject>& project,
                                      const Progress& progress) -> std::optional<Places> {
    const auto question = std::make_shared<Question>();
    auto answer = question->answer.get_future();
    QMetaObject::invokeMethod(qApp, [=] { open_dialog(window, project, question); });
    while (answer.wait_for(look_for_cancel) != std::future_status::ready)
      if (!report(progress, 0, "Waiting for the missing files")) {
        QMetaObject::invokeMethod(qApp, [question] { delete question->dialog.data(); });
        return std::nullopt;
      }
    return answer.get();
  };
}

RelocateDialog::RelocateDialog(std::shared_ptr<const OpenedProject> project, QWidget* parent)
    : QDialog(parent), m_project(std::move(project)) {
  setObjectName("relocate");
  setWindowTitle("Files that are not where they were");
  setAttribute(Qt::WA_DeleteOnClose);
  for (const std::size_t index : m_project->missing()) m_choices[index] = {};
  auto* column = new QVBoxLayout(this);
  const QString session = QFileInfo(QString::fromStdString(m_project->file)).fileName();
  auto* head =
      new QLabel(QString("%1 needs files that are missing. Locate one of them; others that moved along with "
                         "it are then found, too.")
                     .arg(session.isEmpty() ? "This session" : session),
                 this);
  head->setWordWrap(true);
  column->addWidget(head);
  m_list = new QTreeWidget(this);
  m_list->setAccessibleName("Missing files");
  m_list->setHeaderLabels({"File", "For", "Where it is now"});
  m_list->setRootIsDecorated(false);
  m_list->setUniformRowHeights(true);
  m_list->header()->setStretchLastSection(true);
  column->addWidget(m_list, 1);
  m_consequences = new QLabel(this);
  m_consequences->setWordWrap(true);
  m_consequences->setAccessibleName("What will not work");
  column->addWidget(m_consequences);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  m_locate = buttons->addButton("Locate…", QDialogButtonBox::ActionRole);
  m_open = buttons->addButton("Open", QDialogButtonBox::AcceptRole);
  column->addWidget(buttons);
  connect(m_locate, &QPushButton::clicked, this, &RelocateDialog::locate);
  connect(m_list, &QTreeWidget::itemDoubleClicked, this, &RelocateDialog::locate);
  connect(m_list, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    m_choices[item->data(File, Qt::UserRole).toULongLong()].taken = item->checkState(File) == Qt::Checked;
    showConsequences();
  });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(760, 340);
  fill();
  if (m_list->topLevelItemCount() > 0) m_list->setCurrentItem(m_list->topLevelItem(0));
  m_locate->setFocus();
}

void RelocateDialog::fill() {
  const QSignalBlocker quiet(m_list);
  const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
  m_list->clear();
  for (const auto& [index, choice] : m_choices) {
    const DataReference& reference = m_project->project().data[index];
    const FoundData& found = m_project->found[index];
    auto* item = new QTreeWidgetItem(m_list);
    item->setText(File, name_of(reference));
    item->setText(For, use_of(reference));
    item->setText(Place,
                  choice.file.isEmpty()
                      ? QString("not found; looked for as %1")
                            .arg(QString::fromStdString(found.looked.empty() ? "" : found.looked.front()))
                      : (choice.proposed ? "moved along: " : "") + choice.file);
    item->setToolTip(Place, widgets::plain_tip(choice.file.isEmpty() ? "Looked for as\n" + looked_at(found)
                                                                     : choice.file));
    item->setData(File, Qt::UserRole, QVariant::fromValue<qulonglong>(index));
    if (choice.proposed) item->setCheckState(File, choice.taken ? Qt::Checked : Qt::Unchecked);
  }
  if (row >= 0) m_list->setCurrentItem(m_list->topLevelItem(row));
  m_list->resizeColumnToContents(File);
  m_list->resizeColumnToContents(For);
  showConsequences();
}

std::size_t RelocateDialog::current() const {
  const QTreeWidgetItem* item = m_list->currentItem();
  return item ? item->data(File, Qt::UserRole).toULongLong() : m_project->project().data.size();
}

void RelocateDialog::locate() {
  const std::size_t index = current();
  if (index >= m_project->project().data.size()) return;
  const QString name = name_of(m_project->project().data[index]);
  const QString folder = QFileInfo(QString::fromStdString(m_project->file)).absolutePath();
  const QString file =
      widgets::choose_file(this, "Where is " + name + " now?", folder, files_like(name) + ";;All files (*)");
  if (!file.isEmpty()) pointOut(index, file);
}

void RelocateDialog::pointOut(std::size_t index, const QString& file) {
  m_choices[index] = {file, false, true};
  for (const auto& [other, place] : relocated(m_project->project().data, index, file.toStdString()))
    if (const auto choice = m_choices.find(other); choice != m_choices.end() && choice->second.file.isEmpty())
      choice->second = {QString::fromStdString(place), true, true};
  fill();
}

Places RelocateDialog::places() const {
  Places places;
  for (const auto& [index, choice] : m_choices)
    places[index] = choice.taken ? choice.file.toStdString() : std::string();
  return places;
}

std::size_t RelocateDialog::leftMissing() const {
  const Places chosen = places();
  return static_cast<std::size_t>(
      std::ranges::count_if(chosen, [](const auto& place) { return place.second.empty(); }));
}

void RelocateDialog::showConsequences() {
  std::map<std::string, QStringList> names;  // by what does not work without them
  for (const auto& [index, place] : places()) {
    const DataReference& reference = m_project->project().data[index];
    if (place.empty()) names[without(reference.use)] << name_of(reference);
  }
  QStringList lines;
  for (const auto& [consequence, files] : names)
    lines << QString("Without %1: %2.").arg(files.join(", "), QString::fromStdString(consequence));
  m_consequences->setText(lines.join("\n"));
  const std::size_t left = leftMissing();
  m_open->setText(left == 0                  ? "Open"
                  : left == m_choices.size() ? "Open without them"
                                             : "Open without the rest");
  if (left == 0) m_open->setFocus();  // nothing else is left to do: Return opens
}

}  // namespace abrazo::app

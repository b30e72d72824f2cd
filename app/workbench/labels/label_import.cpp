#include "app/workbench/labels/label_import.hpp"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::app {
namespace {

using widgets::text;

}  // namespace

LabelImport::LabelImport(MainWindow& window, AnnotationDesk& desk)
    : QObject(&desk), m_window(window), m_document(window.document()), m_desk(desk) {
  connect(&window, &MainWindow::labelsOffered, this, &LabelImport::read);
}

void LabelImport::choose() {
  const QStringList files = ask_files(&m_window, m_window.remembered(), "Import labels",
                                      "Labels (*.eaf *.csv *.json *.TextGrid *.txt);;All files (*)");
  if (!files.isEmpty()) read(files);
}

void LabelImport::read(const QStringList& files) {
  if (!m_window.session())
    return m_window.fail(
        "Labels belong to a take or a session; open a library or a session first, then the labels");
  for (const QString& file : files) {
    const auto document = read_labels_for(file.toStdString(), m_desk.fps(), m_document.subject());
    if (!document) return m_window.messages().showError(words(document.error()));
    take(file, *document);
  }
}

void LabelImport::take(const QString& file, const TierDocument& document) {
  const TierPlan plan = plan_tiers(document.tiers, m_document.annotations());
  plan.is_clear ? finish(file, document, plan.targets) : ask(file, document, plan);
}

void LabelImport::ask(const QString& file, const TierDocument& document, const TierPlan& plan) {
  auto* dialog = new QDialog(&m_window);
  dialog->setObjectName("labelImport");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle("Import labels");
  auto* column = new QVBoxLayout(dialog);
  auto* head =
      new QLabel(QString("Choose the tiers for the labels of %1. Present labels of these tiers are replaced.")
                     .arg(QFileInfo(file).fileName()),
                 dialog);
  head->setWordWrap(true);
  column->addWidget(head);
  auto* form = new QFormLayout;
  std::vector<QComboBox*> boxes;
  for (std::size_t i = 0; i < document.tiers.size(); ++i) {
    const Tier& tier = document.tiers[i];
    auto* box = new QComboBox(dialog);
    box->addItem("leave out", -1);
    box->addItem("a new tier", 0);
    for (const AnnotationTier& each : m_document.annotations().tiers())
      box->addItem(text(each.name), each.id);
    const TierTarget& target = plan.targets[i];
    box->setCurrentIndex(box->findData(target.way == TierTarget::Way::Into  ? target.tier
                                       : target.way == TierTarget::Way::New ? 0
                                                                            : -1));
    const QString name = QString("%1 (%2)").arg(text(tier.name)).arg(tier.intervals.size());
    box->setAccessibleName(name);
    form->addRow(name, box);
    boxes.push_back(box);
  }
  column->addLayout(form);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, dialog);
  buttons->button(QDialogButtonBox::Ok)->setText("Import");
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this, dialog, boxes, file, document] {
    std::vector<TierTarget> targets;
    for (const QComboBox* box : boxes) {
      const int id = box->currentData().toInt();
      targets.push_back({id < 0    ? TierTarget::Way::LeaveOut
                         : id == 0 ? TierTarget::Way::New
                                   : TierTarget::Way::Into,
                         id});
    }
    dialog->accept();
    finish(file, document, targets);
  });
  // The ids are those of this subject's tiers.
  connect(&m_document, &Document::annotationsReplaced, dialog, &QDialog::reject);
  dialog->open();
}

void LabelImport::finish(const QString& file, const TierDocument& document,
                         const std::vector<TierTarget>& targets) {
  const auto next = with_imported(document.tiers, targets, m_document.annotations(), m_desk.range());
  if (!next) return m_window.messages().showError(file + ": " + words(next.error()));
  std::size_t labels = 0;
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (targets[i].way != TierTarget::Way::LeaveOut) labels += document.tiers[i].intervals.size();
  m_document.changeAnnotations(*next, "import of " + QFileInfo(file).fileName());
  m_window.makeRoomForLanes();  // of new tiers
  QStringList told;
  for (const std::string& warning : document.warnings) told << text(warning);
  if (!told.isEmpty()) return m_window.messages().showWarnings(told);
  m_window.messages().showInformation(
      QString("%1 labels from %2").arg(labels).arg(QFileInfo(file).fileName()));
}

}  // namespace abrazo::app

#include "app/workbench/labels/label_import.hpp"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::app {
namespace {

using widgets::text;

std::string fresh_name(const Annotations& annotations, const std::string& wanted) {
  std::string name = wanted;
  for (int n = 2; annotations.tier_named(name); ++n) name = wanted + " " + std::to_string(n);
  return name;
}

/// Values that the vocabulary does not have yet; without the key where another has it.
std::vector<VocabularyEntry> joined(std::vector<VocabularyEntry> vocabulary, const Tier& read) {
  const auto has = [&vocabulary](const auto& is) {
    return std::any_of(vocabulary.begin(), vocabulary.end(), is);
  };
  std::vector<VocabularyEntry> more = read.vocabulary;
  for (const VocabularyEntry& each : vocabulary_of(read.intervals)) more.push_back(each);
  for (VocabularyEntry& entry : more) {
    if (entry.value.empty() ||
        has([&entry](const VocabularyEntry& known) { return known.value == entry.value; }))
      continue;
    if (has([&entry](const VocabularyEntry& known) { return known.key == entry.key; })) entry.key = 0;
    vocabulary.push_back(std::move(entry));
  }
  return vocabulary;
}

Status fill(Annotations& next, int tier, const Tier& read, const Annotations::Range& range) {
  const auto before = next.tier(tier)->annotations;
  for (const Annotation& each : before)
    if (const Status gone = next.remove(each.id); !gone) return gone;
  for (const TierInterval& each : read.intervals) {
    const auto drawn = next.draw(tier, each.start_s, each.end_s, each.value, Conflict::Refuse, range);
    if (!drawn) return drawn.error();
    const Status said = next.say(*drawn, each.value, each.detail, each.confidence);
    if (!said) return said;
  }
  return Done{};
}

}  // namespace

TierPlan plan_tiers(const std::vector<Tier>& read, const Annotations& into) {
  TierPlan plan;
  for (const Tier& tier : read) {
    const AnnotationTier* same = into.tier_named(tier.name);
    if (same && same->kind == tier.kind) {
      plan.targets.push_back({TierTarget::Way::Into, same->id});
      continue;
    }
    const auto of_kind = [&tier](const auto& each) { return each.kind == tier.kind; };
    const bool only = std::count_if(read.begin(), read.end(), of_kind) == 1 &&
                      std::count_if(into.tiers().begin(), into.tiers().end(), of_kind) == 1;
    if (only && tier.kind != TierKind::Note)
      plan.targets.push_back({TierTarget::Way::Into, into.first_of(tier.kind)->id});
    else
      plan.targets.push_back({TierTarget::Way::New});
    plan.is_clear = plan.is_clear && only && tier.kind != TierKind::Note;
  }
  return plan;
}

Result<Annotations> imported(const std::vector<Tier>& read, const std::vector<TierTarget>& targets,
                             const Annotations& into, const Annotations::Range& range) {
  Annotations next = into;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const Tier& tier = read[i];
    int id = targets[i].tier;
    if (targets[i].way == TierTarget::Way::LeaveOut) continue;
    if (targets[i].way == TierTarget::Way::New) {
      const auto added = next.add_tier(fresh_name(next, tier.name), tier.kind, tier.vocabulary);
      if (!added) return added.error();
      id = *added;
    }
    const AnnotationTier* known = next.tier(id);
    if (!known) return Error{"the tier no longer exists", tier.name};
    const bool has_values = !known->vocabulary.empty() || !tier.vocabulary.empty();
    if (has_values && known->kind != TierKind::Role)
      if (const Status set = next.set_vocabulary(id, joined(known->vocabulary, tier)); !set)
        return set.error();
    if (const Status filled = fill(next, id, tier, range); !filled)
      return Error{filled.error().message, tier.name};
  }
  return next;
}

LabelImport::LabelImport(MainWindow& window, AnnotationDesk& desk)
    : QObject(&desk), m_window(window), m_desk(desk) {
  connect(&window, &MainWindow::labelsOffered, this, &LabelImport::read);
}

void LabelImport::choose() {
  const QStringList files =
      QFileDialog::getOpenFileNames(&m_window, "Import labels", m_window.remembered().lastFolder(),
                                    "Labels (*.eaf *.csv *.json *.vtt *.srt);;All files (*)");
  if (files.isEmpty()) return;
  m_window.remembered().setLastFolder(QFileInfo(files.front()).absolutePath());
  read(files);
}

void LabelImport::read(const QStringList& files) {
  if (!m_window.session())
    return m_window.fail(
        "Labels belong to a take or a session; open a library or a session first, then the labels");
  for (const QString& file : files) {
    TierReading reading;
    reading.fps = m_desk.fps();
    reading.take = m_desk.subject();
    auto document = read_tiers(file.toStdString(), reading);
    if (!document) {
      // A label file of one take may be meant for another.
      reading.take.clear();
      if (auto any = read_tiers(file.toStdString(), reading)) document = std::move(any);
    }
    if (!document) return m_window.messages().showError(text(document.error().text()));
    take(file, *document);
  }
}

void LabelImport::take(const QString& file, const TierDocument& document) {
  const TierPlan plan = plan_tiers(document.tiers, m_desk.annotations());
  plan.is_clear ? finish(file, document, plan.targets) : ask(file, document, plan);
}

void LabelImport::ask(const QString& file, const TierDocument& document, const TierPlan& plan) {
  auto* dialog = new QDialog(&m_window);
  dialog->setObjectName("labelImport");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle("Import labels");
  auto* column = new QVBoxLayout(dialog);
  auto* head = new QLabel(QString("Where do the tiers of %1 go? Their present labels are replaced.")
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
    for (const AnnotationTier& each : m_desk.annotations().tiers()) box->addItem(text(each.name), each.id);
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
  connect(&m_desk, &AnnotationDesk::subjectChanged, dialog, &QDialog::reject);
  dialog->open();
}

void LabelImport::finish(const QString& file, const TierDocument& document,
                         const std::vector<TierTarget>& targets) {
  const auto next = imported(document.tiers, targets, m_desk.annotations(), m_desk.range());
  if (!next) return m_window.messages().showError(file + ": " + text(next.error().text()));
  std::size_t labels = 0;
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (targets[i].way != TierTarget::Way::LeaveOut) labels += document.tiers[i].intervals.size();
  m_desk.change(*next, "import of " + QFileInfo(file).fileName());
  QStringList told;
  for (const std::string& warning : document.warnings) told << text(warning);
  if (!told.isEmpty()) return m_window.messages().showWarnings(told);
  m_window.messages().showInformation(
      QString("%1 labels from %2").arg(labels).arg(QFileInfo(file).fileName()));
}

}  // namespace abrazo::app

#include "widgets/annotation/tier_list.hpp"

#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "widgets/common/chip.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr int tier_role = Qt::UserRole, name_role = Qt::UserRole + 1;
constexpr int tier_row_px = 22, most_tier_rows = 6;

QString kind_words(TierKind kind) {
  return kind == TierKind::Role ? "who leads" : kind == TierKind::Move ? "moves" : "notes";
}

/// "contact", "contact 2", ...
QString fresh_name(const Annotations& annotations, const QString& wanted) {
  QString name = wanted;
  for (int n = 2; annotations.tier_named(name.toStdString()); ++n) name = QString("%1 %2").arg(wanted).arg(n);
  return name;
}

}  // namespace

TierList::TierList(QWidget* parent) : QWidget(parent), m_list(new QListWidget(this)) {
  auto* column = column_in(this, {}, 4);
  m_list->setAccessibleName("Tiers");
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->setToolTip(
      "Click: labels go into this tier. The box shows or hides its lane; a double click renames it");
  column->addWidget(m_list);
  auto* row = nested_row({}, 4);
  auto* more = chip("+ Tier", "Add a tier", this);
  more->setPopupMode(QToolButton::InstantPopup);
  auto* kinds = new QMenu(more);
  kinds->addAction("Of moves", this, [this] { add(TierKind::Move, "moves"); });
  kinds->addAction("Of notes (free text)", this, [this] { add(TierKind::Note, "notes"); });
  kinds->addAction("Of who leads", this, [this] { add(TierKind::Role, "role"); });
  more->setMenu(kinds);
  m_remove = chip("Remove", "Remove the active tier with its labels", this);
  m_up = chip("↑", "Move the active tier up", this);
  m_down = chip("↓", "Move the active tier down", this);
  for (QToolButton* each : {more, m_remove, m_up, m_down}) row->addWidget(each);
  row->addStretch(1);
  column->addLayout(row);
  connect(m_remove, &QToolButton::clicked, this, &TierList::removeActive);
  connect(m_up, &QToolButton::clicked, this, [this] { moveActive(-1); });
  connect(m_down, &QToolButton::clicked, this, [this] { moveActive(1); });
  connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (!m_filling && item) emit tierChosen(item->data(tier_role).toInt());
  });
  connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (m_filling) return;
    const QString known = item->data(name_role).toString();
    item->text() != known ? rename(m_list->row(item), item->text())
                          : emit visibilityRequested(known, item->checkState() == Qt::Checked);
  });
}

void TierList::setColours(const Palette&) {
  update();
}

void TierList::show(const Annotations& annotations, int active, const std::set<std::string>& hidden) {
  m_filling = true;
  m_annotations = annotations;
  m_active = active;
  // Items that stay are kept: this comes in the middle of a click on one of them, too.
  while (m_list->count() > static_cast<int>(annotations.tiers().size()))
    delete m_list->takeItem(m_list->count() - 1);
  while (m_list->count() < static_cast<int>(annotations.tiers().size())) m_list->addItem(QString());
  for (int i = 0; i < m_list->count(); ++i) {
    const AnnotationTier& tier = annotations.tiers()[static_cast<std::size_t>(i)];
    QListWidgetItem* item = m_list->item(i);
    item->setText(text(tier.name));
    item->setData(tier_role, tier.id);
    item->setData(name_role, text(tier.name));
    item->setFlags(item->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
    item->setCheckState(hidden.contains(tier.name) ? Qt::Unchecked : Qt::Checked);
    item->setToolTip(QString("%1, %2 labels").arg(kind_words(tier.kind)).arg(tier.annotations.size()));
    item->setSizeHint({100, tier_row_px});
    if (tier.id == active) m_list->setCurrentItem(item);
  }
  const int rows = std::clamp(m_list->count(), 1, most_tier_rows);
  m_list->setFixedHeight(rows * tier_row_px + 4);
  const int at = m_list->currentRow();
  m_remove->setEnabled(at >= 0);
  m_up->setEnabled(at > 0);
  m_down->setEnabled(at >= 0 && at + 1 < m_list->count());
  m_filling = false;
}

void TierList::settle(const Status& done, const Annotations& next, const QString& what) {
  done ? emit changeRequested(next, what) : emit refused(text(done.error().text()));
}

void TierList::add(TierKind kind, const QString& name) {
  Annotations next = m_annotations;
  std::vector<VocabularyEntry> vocabulary;
  const AnnotationTier* model = next.first_of(kind);
  if (model && kind != TierKind::Note) vocabulary = model->vocabulary;
  const auto added = next.add_tier(fresh_name(next, name).toStdString(), kind, std::move(vocabulary));
  settle(added ? Status(Done{}) : Status(added.error()), next, "add tier");
  if (added) emit tierChosen(*added);
}

void TierList::rename(int row, const QString& name) {
  Annotations next = m_annotations;
  const Status done = next.rename_tier(m_list->item(row)->data(tier_role).toInt(), name.toStdString());
  if (!done) {
    m_filling = true;
    m_list->item(row)->setText(m_list->item(row)->data(name_role).toString());
    m_filling = false;
  }
  settle(done, next, "rename tier");
}

void TierList::removeActive() {
  Annotations next = m_annotations;
  const AnnotationTier* tier = next.tier(m_active);
  if (!tier) return;
  const QString name = text(tier->name);
  settle(next.remove_tier(m_active), next, "remove tier " + name);
}

void TierList::moveActive(int by) {
  Annotations next = m_annotations;
  settle(next.move_tier(m_active, m_list->currentRow() + by), next, "move tier");
}

}  // namespace abrazo::widgets

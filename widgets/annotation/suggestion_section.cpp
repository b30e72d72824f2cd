#include "widgets/annotation/suggestion_section.hpp"

#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QSlider>
#include <QToolButton>
#include <algorithm>

#include "widgets/common/chip.hpp"
#include "widgets/common/flow_row.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/section_header.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr int suggestion_id_role = Qt::UserRole;
constexpr int usual_threshold = 80;  ///< per cent

}  // namespace

SuggestionSection::SuggestionSection(QWidget* parent)
    : QWidget(parent),
      m_head(new SectionHeader("Suggestions", this)),
      m_list(new QListWidget(this)),
      m_reason(new QLabel(this)),
      m_progress(new QProgressBar(this)) {
  auto* column = column_in(this, {}, 4);
  column->addWidget(m_head);
  column->addWidget(makeButtons());
  m_progress->setRange(0, 100);
  m_progress->setAccessibleName("Suggesting");
  m_progress->hide();
  column->addWidget(m_progress);
  m_list->setAccessibleName("Suggestions, the most confident first");
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->setToolTip("A accepts, E accepts with another value, X rejects; then the next one");
  m_list->setMinimumHeight(110);
  m_list->installEventFilter(this);
  column->addWidget(m_list, 1);
  m_reason->setWordWrap(true);
  m_reason->setObjectName("hint");
  m_reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(m_reason);
  column->addWidget(makeThreshold());
  connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
    if (m_filling) return;
    describe();
    if (row >= 0) emit chosen(current(), m_rows[static_cast<std::size_t>(row)].start_s);
  });
  describe();
  count();
}

QWidget* SuggestionSection::makeButtons() {
  auto* bar = new QWidget(this);
  auto* row = new FlowRow(bar, 4);
  m_moves = chip("Labels", "Suggest labels for this take from the other takes", bar);
  m_roles = chip("Roles", "Suggest who is active in this take from the other takes", bar);
  m_cancel = chip("Cancel", "Stop suggesting", bar);
  m_cancel->hide();
  m_accept = chip("Accept", "Accept the chosen suggestion (A in the list)", bar);
  m_edit = chip("Edit", "Accept it with another value (E in the list)", bar);
  m_reject = chip("Reject", "Reject the chosen suggestion (X in the list)", bar);
  for (QToolButton* button : {m_moves, m_roles, m_cancel, m_accept, m_edit, m_reject}) row->addWidget(button);
  connect(m_moves, &QToolButton::clicked, this, [this] { emit suggestRequested(true, false); });
  connect(m_roles, &QToolButton::clicked, this, [this] { emit suggestRequested(false, true); });
  connect(m_cancel, &QToolButton::clicked, this, &SuggestionSection::cancelRequested);
  connect(m_accept, &QToolButton::clicked, this, [this] { press(Qt::Key_A); });
  connect(m_edit, &QToolButton::clicked, this, [this] { press(Qt::Key_E); });
  connect(m_reject, &QToolButton::clicked, this, [this] { press(Qt::Key_X); });
  return bar;
}

QWidget* SuggestionSection::makeThreshold() {
  auto* bar = new QWidget(this);
  auto* column = column_in(bar, {}, 4);
  auto* row = nested_row({}, 6);
  m_slider = new QSlider(Qt::Horizontal, bar);
  m_slider->setRange(0, 100);
  m_slider->setValue(usual_threshold);
  m_slider->setAccessibleName("Minimum confidence for accepting all, per cent");
  m_threshold = new QLabel(bar);
  m_acceptAll = chip({}, "Accept all with at least the slider's confidence; one undo step", bar);
  auto* clear = chip("Clear", "Remove all suggestions", bar);
  row->addWidget(m_slider, 1);
  row->addWidget(m_threshold);
  auto* buttons = new QWidget(bar);
  auto* flow = new FlowRow(buttons, 4);
  flow->addWidget(m_acceptAll);
  flow->addWidget(clear);
  column->addLayout(row);
  column->addWidget(buttons);
  connect(m_slider, &QSlider::valueChanged, this, &SuggestionSection::count);
  connect(m_acceptAll, &QToolButton::clicked, this,
          [this] { emit acceptAllRequested(at_least(m_rows, threshold())); });
  connect(clear, &QToolButton::clicked, this, &SuggestionSection::clearRequested);
  return bar;
}

void SuggestionSection::setColours(const Palette& palette) {
  m_head->setColours(palette);
}

void SuggestionSection::showSuggestions(const Annotations& annotations) {
  const int before = m_list->currentRow(), id = current();
  m_rows = suggestion_rows(annotations);
  m_filling = true;
  m_list->clear();
  for (const SuggestionRow& row : m_rows) {
    auto* item = new QListWidgetItem(text(words_of(row)), m_list);
    item->setData(suggestion_id_role, row.id);
    item->setToolTip(plain_tip(text(row.tier_name + ": " + row.reason)));
  }
  const int again = row_of(m_rows, id), last = m_list->count() - 1;
  // What was decided is gone: the one that took its place is next.
  if (last >= 0) m_list->setCurrentRow(again >= 0 ? again : std::clamp(before, 0, last));
  m_filling = false;
  // Only a decision moves on; any other edit leaves the cursor in place.
  if (id != 0 && again < 0 && last >= 0)
    emit chosen(current(), m_rows[static_cast<std::size_t>(m_list->currentRow())].start_s);
  m_head->setTitle(m_rows.empty() ? "Suggestions" : QString("Suggestions (%1)").arg(m_rows.size()));
  describe();
  count();
}

void SuggestionSection::choose(int suggestion) {
  if (const int row = row_of(m_rows, suggestion); row >= 0) m_list->setCurrentRow(row);
}

void SuggestionSection::showProgress(double fraction, const QString& doing) {
  const bool busy = fraction >= 0;
  m_progress->setVisible(busy);
  m_progress->setValue(static_cast<int>(100 * std::max(0.0, fraction)));
  m_progress->setFormat(doing + " %p %");
  m_cancel->setVisible(busy);
  m_moves->setVisible(!busy);
  m_roles->setVisible(!busy);
}

int SuggestionSection::current() const {
  const QListWidgetItem* item = m_list->currentItem();
  return item ? item->data(suggestion_id_role).toInt() : 0;
}

double SuggestionSection::threshold() const {
  return m_slider->value() / 100.0;
}

void SuggestionSection::describe() {
  const int row = m_list->currentRow();
  const bool is_chosen = row >= 0 && row < static_cast<int>(m_rows.size());
  for (QToolButton* button : {m_accept, m_edit, m_reject}) {
    button->setEnabled(is_chosen);
    button->setVisible(m_list->count() > 0);
  }
  m_reason->setText(is_chosen ? text(m_rows[static_cast<std::size_t>(row)].reason)
                              : QString("There are no suggestions. They are made from labels and "
                                        "roles of the other takes."));
}

void SuggestionSection::count() {
  const auto sure = at_least(m_rows, threshold()).size();
  m_threshold->setText(QString("≥ %1 %").arg(m_slider->value()));
  m_acceptAll->setText(QString("Accept %1").arg(sure));
  m_acceptAll->setEnabled(sure > 0);
}

bool SuggestionSection::press(int key) {
  if (key != Qt::Key_A && key != Qt::Key_E && key != Qt::Key_X) return false;
  if (const int id = current(); id != 0)
    key == Qt::Key_A   ? emit acceptRequested(id)
    : key == Qt::Key_E ? emit editRequested(id)
                       : emit rejectRequested(id);
  return true;
}

/// Letters go to the list before the window's actions, and do not search in it.
bool SuggestionSection::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_list && (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)) {
    auto* key = static_cast<QKeyEvent*>(event);
    const bool own = key->modifiers() == Qt::NoModifier &&
                     (key->key() == Qt::Key_A || key->key() == Qt::Key_E || key->key() == Qt::Key_X);
    if (own && event->type() == QEvent::ShortcutOverride) event->accept();
    if (own && event->type() == QEvent::KeyPress) press(key->key());
    if (own) return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace abrazo::widgets

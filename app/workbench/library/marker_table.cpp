#include "app/workbench/library/marker_table.hpp"

#include <QCompleter>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStyledItemDelegate>

#include "app/workbench/base/error_words.hpp"
#include "widgets/common/parts.hpp"

namespace abrazo::app {
namespace {

/// Edits a place with all names at hand.
class PlaceDelegate : public QStyledItemDelegate {
 public:
  explicit PlaceDelegate(QObject* parent) : QStyledItemDelegate(parent) {
    for (std::size_t place = 0; place < marker_place_count; ++place)
      for (std::size_t side = 0; side < (place < first_sided_place ? 1U : 2U); ++side)
        m_places << QString::fromStdString(name_of_place(static_cast<MarkerPlace>(place), side));
  }
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override {
    QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
    if (auto* line = qobject_cast<QLineEdit*>(editor)) {
      auto* completer = new QCompleter(m_places, line);
      completer->setCaseSensitivity(Qt::CaseInsensitive);
      completer->setFilterMode(Qt::MatchContains);
      line->setCompleter(completer);
    }
    return editor;
  }

 private:
  QStringList m_places;
};

bool is_proposal(const MarkerNaming& naming, int point) {
  return naming.rows()[static_cast<std::size_t>(point)].by == MarkerNaming::By::Proposal;
}

}  // namespace

MarkerTable::MarkerTable(const NamedMotion& motion, QWidget* parent)
    : QTableWidget(static_cast<int>(motion.points.size()), 3, parent),
      m_naming(motion.points),
      m_points(motion.points),
      m_palette(widgets::palette_of(widgets::Theme::Dark)) {
  setAccessibleName("Markers and their places");
  setHorizontalHeaderLabels({"Marker", "Place on the body", "Guess"});
  widgets::make_rows(*this, 24);
  setTabKeyNavigation(false);
  horizontalHeader()->setSectionResizeMode(Place, QHeaderView::Stretch);
  horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  setColumnWidth(Belief, 150);
  setItemDelegateForColumn(Place, new PlaceDelegate(this));
  connect(this, &QTableWidget::cellChanged, this, [this](int point, int column) {
    if (!m_filling && column == Place) say(point, item(point, Place)->text());
  });
  connect(this, &QTableWidget::cellClicked, this, [this](int point, int column) {
    if (column == Belief && is_proposal(m_naming, point)) accept(point);
  });
  showRows();
}

void MarkerTable::setColours(const widgets::Palette& palette) {
  m_palette = palette;
  showRows();
}

void MarkerTable::propose(const MarkerGuess& guess) {
  m_naming.propose(guess);
  showRows();
  emit changed();
}

Result<std::size_t> MarkerTable::read(const MarkerModel& model) {
  auto found = m_naming.read(model);
  showRows();
  emit changed();
  return found;
}

void MarkerTable::accept(int point) {
  if (!m_naming.accept(point)) return;
  showRows();
  emit changed();
}

void MarkerTable::say(int point, const QString& place) {
  const Status said = m_naming.say(point, place.trimmed().toLower().toStdString());
  showRows();
  emit changed();
  if (!said) emit refused(words(said.error()));
}

void MarkerTable::keyPressEvent(QKeyEvent* event) {
  const bool is_enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (is_enter && state() != EditingState && currentRow() >= 0 && is_proposal(m_naming, currentRow())) {
    const int point = currentRow();
    accept(point);
    if (point + 1 < rowCount()) setCurrentCell(point + 1, Place);
    return;
  }
  QTableWidget::keyPressEvent(event);
}

void MarkerTable::showRows() {
  m_filling = true;
  for (int point = 0; point < rowCount(); ++point) {
    const bool proposed = is_proposal(m_naming, point);
    const QString place = QString::fromStdString(m_naming.place_of(point));
    const QString belief = QString::fromStdString(m_naming.belief_in(point));
    const QString cells[] = {QString::fromStdString(m_points[static_cast<std::size_t>(point)]), place,
                             proposed ? belief + " · accept" : belief};
    for (const int column : {Point, Place, Belief}) {
      auto* cell = item(point, column);
      if (!cell) setItem(point, column, cell = new QTableWidgetItem);
      cell->setText(cells[column]);
      cell->setFlags(column == Place ? cell->flags() | Qt::ItemIsEditable
                                     : cell->flags() & ~Qt::ItemIsEditable);
      cell->setForeground(proposed && column == Belief   ? m_palette.accent
                          : proposed || column == Belief ? m_palette.secondary
                                                         : m_palette.text);
      cell->setToolTip(column == Belief && proposed ? "Click, or Enter in the row, accepts the place"
                       : column == Place            ? "A place such as left knee; an empty text removes it"
                                                    : QString());
    }
  }
  m_filling = false;
}

}  // namespace abrazo::app

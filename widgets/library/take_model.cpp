#include "widgets/library/take_model.hpp"

#include <QPainter>

#include "widgets/common/plain_text.hpp"
#include "widgets/library/take_picture.hpp"

namespace abrazo::widgets {
namespace {

constexpr int picture_side = 34;
constexpr std::size_t many_takes = 32;  ///< more than a list shows: announcing all at once costs less

}  // namespace

TakeModel::TakeModel(QObject* parent) : QAbstractListModel(parent), m_palette(palette_of(Theme::Dark)) {}

void TakeModel::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  beginResetModel();
  m_library = std::move(library);
  m_rows = m_library ? take_rows(*m_library) : std::vector<TakeRow>();
  m_pairs = m_library ? PairsOfTakes(*m_library) : PairsOfTakes();
  m_coverage.begin(m_library);
  m_belief = {};
  m_belief.begin({}, m_library ? m_library->takes() : std::vector<LibraryTake>());
  m_model.reset();
  m_pictures.clear();
  m_users.clear();
  m_source_take = m_cursor_take = -1;
  endResetModel();
}

void TakeModel::setColours(const Palette& palette) {
  m_palette = palette;
  m_pictures.clear();
  coverageChanged();
}

void TakeModel::beginCoverage() {
  m_coverage.begin(m_library);
  coverageChanged();
}

void TakeModel::changed(int take) {
  if (take >= 0 && take < rowCount()) emit dataChanged(index(take), index(take));
}

void TakeModel::coverageChanged() {
  if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1));
}

void TakeModel::setVetoed(const std::set<std::string>& takes) {
  if (takes == m_vetoed) return;
  m_vetoed = takes;
  coverageChanged();
}

void TakeModel::setUsersTake(const std::string& take) {
  m_users = take;
  coverageChanged();
}

void TakeModel::setSource(int take, int frame) {
  if (take == m_source_take && frame == m_source_frame) return;
  const int before = m_source_take;
  m_source_take = take, m_source_frame = frame;
  if (before != take) changed(before);
  changed(take);
}

void TakeModel::setCursor(int take, int frame) {
  const int before = m_cursor_take;
  m_cursor_take = take, m_cursor_frame = frame;
  if (before != take) changed(before);
  changed(take);
}

void TakeModel::setBelief(const FrameIntent& intent) {
  if (!m_library) return;
  if (intent.model != m_model) {
    m_model = intent.model;
    m_belief.begin(m_model ? std::span(m_model->blocks()) : std::span<const BeliefBlock>(),
                   m_library->takes());
  }
  const std::vector<int>& takes = m_belief.show(intent.belief);
  if (takes.size() > many_takes) return coverageChanged();
  for (const int take : takes) changed(take);
}

QString TakeModel::beliefText(int take, std::optional<int> frame) const {
  if (!m_belief.is_any()) return {};
  const auto percent = [](double belief) { return QString("%1 %").arg(qRound(100 * belief)); };
  const TakeBelief::Peak peak = m_belief.peak(take);
  QString words =
      "Light below the moves: belief, where the user's last two seconds say that the partner comes from "
      "next. ";
  if (frame) words += QString("At frame %1: %2. ").arg(*frame).arg(percent(m_belief.at(take, *frame)));
  if (peak.belief == 0) return words + "None in this take";
  return words +
         QString("Brightest in this take: %1, at frame %2; 100 % is the most likely pair of the library")
             .arg(percent(peak.belief))
             .arg(peak.frame);
}

/// Both bodies of the take's middle pair.
QPixmap TakeModel::picture(int take, double pixel_ratio) const {
  const auto known = m_pictures.find(take);
  if (known != m_pictures.end() && known->second.devicePixelRatioF() == pixel_ratio) return known->second;
  QPixmap pixmap(QSize(picture_side, picture_side) * pixel_ratio);
  pixmap.setDevicePixelRatio(pixel_ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(m_palette.raised);
  const QRectF square(0, 0, picture_side, picture_side);
  painter.drawRoundedRect(square, 4, 4);
  if (const int pair = m_pairs.pair_at(take, row(take).frames / 2); pair >= 0)
    draw_pair(painter, square, m_library->pose(pair), m_palette.active, m_palette.passive);
  return m_pictures[take] = pixmap;
}

int TakeModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

/// The whole row as text, for screen readers.
QString TakeModel::spoken(const TakeRow& row) const {
  QString words = QString("%1, %2 frames, %3 seconds, %4 moves, %5, selected %6 times")
                      .arg(QString::fromStdString(row.name))
                      .arg(row.frames)
                      .arg(row.seconds, 0, 'f', 1)
                      .arg(row.moves.size())
                      .arg(QString::fromStdString(row.leader))
                      .arg(m_coverage.times_selected(row.take));
  if (isUsers(row.take)) words += ", plays the user";
  if (isVetoed(row.take)) words += ", vetoed";
  if (row.take == m_source_take) words += ", shown now";
  if (m_belief.is_any())
    words += QString(", belief %1 percent").arg(qRound(100 * m_belief.peak(row.take).belief));
  return words;
}

QVariant TakeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const TakeRow& about = row(index.row());
  if (role == Qt::DisplayRole) return QString::fromStdString(about.name);
  if (role == Qt::AccessibleTextRole) return spoken(about);
  if (role != Qt::ToolTipRole) return {};
  const double share = m_coverage.share_selected(about.take);
  QStringList labels;
  for (const std::string& label : about.labels) labels << QString::fromStdString(label).replace('_', ' ');
  const QString belief = beliefText(about.take);
  return plain_tip(
      QString("%1: %2 frames at %3 fps, %4\nMoves: %5\nThis session selected %6 of its frames (%7 %), %8 "
              "times in all")
          .arg(QString::fromStdString(about.name))
          .arg(about.frames)
          .arg(about.fps, 0, 'g', 4)
          .arg(QString::fromStdString(about.leader), labels.isEmpty() ? "no labels" : labels.join(", "))
          .arg(qRound(share * about.frames))
          .arg(100 * share, 0, 'f', 1)
          .arg(m_coverage.times_selected(about.take)) +
      (m_coverage.is_estimated() ? QString("\nEstimated: of this long recording, 1 in %1 frames was read")
                                       .arg(m_coverage.frames_each())
                                 : QString()) +
      (belief.isEmpty() ? QString() : "\n" + belief));
}

TakeFilter::TakeFilter(TakeModel* model, QObject* parent) : QSortFilterProxyModel(parent), m_model(model) {
  setSourceModel(model);
  setDynamicSortFilter(false);  // a list that re-sorts while counts grow would run away from the pointer
}

void TakeFilter::setWanted(const QString& text) {
  m_wanted = text.toStdString();
  invalidateFilter();
}

void TakeFilter::setOrder(TakeOrder order) {
  m_order = order;
  if (order == TakeOrder::AsRecorded) return sort(-1);
  invalidate();
  sort(0);
}

int TakeFilter::takeAt(const QModelIndex& index) const {
  return index.isValid() ? mapToSource(index).row() : -1;
}

QModelIndex TakeFilter::indexOf(int take) const {
  return take < 0 ? QModelIndex() : mapFromSource(m_model->index(take));
}

bool TakeFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  return matches(m_model->row(row), m_wanted);
}

bool TakeFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const TakeRow &a = m_model->row(left.row()), &b = m_model->row(right.row());
  const TakeCoverage& coverage = m_model->coverage();
  switch (m_order) {
    case TakeOrder::AsRecorded:
      return a.take < b.take;
    case TakeOrder::Name:
      return QString::compare(QString::fromStdString(a.name), QString::fromStdString(b.name),
                              Qt::CaseInsensitive) < 0;
    case TakeOrder::Longest:
      return a.seconds > b.seconds;
    case TakeOrder::MostMoves:
      return a.moves.size() > b.moves.size();
    case TakeOrder::MostSelected:
      return coverage.times_selected(a.take) > coverage.times_selected(b.take);
  }
  return a.take < b.take;
}

}  // namespace abrazo::widgets

#include "widgets/library/take_list.hpp"

#include <QPaintEvent>
#include <QPainter>
#include <algorithm>

#include "core/motion/joint_set.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int row_height = 42;
constexpr int picture = 34;

}  // namespace

TakeList::TakeList(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {}

QSize TakeList::sizeHint() const {
  return {260, row_height * (m_library ? static_cast<int>(m_library->takes().size()) : 1)};
}

void TakeList::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  m_library = std::move(library);
  m_current = m_selected = -1;
  makeThumbnails();
  setMinimumHeight(sizeHint().height());
  updateGeometry();
}

void TakeList::setColours(const Palette& palette) {
  m_palette = palette;
  makeThumbnails();
}

void TakeList::setCurrentTake(int take) {
  if (take == m_current) return;
  m_current = take;
  update();
}

void TakeList::setSelectedTake(int take) {
  if (take == m_selected) return;
  m_selected = take;
  update();
}

void TakeList::makeThumbnails() {
  m_thumbnails.clear();
  const std::size_t takes = m_library ? m_library->takes().size() : 0;
  for (std::size_t t = 0; t < takes; ++t) m_thumbnails.push_back(thumbnail(static_cast<int>(t)));
  update();
}

/// Both bodies of the take's middle pair, seen from the side of the active one.
QPixmap TakeList::thumbnail(int take) const {
  const double ratio = devicePixelRatioF();
  QPixmap pixmap(QSize(picture, picture) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(m_palette.raised);
  painter.drawRoundedRect(QRectF(0, 0, picture, picture), 4, 4);
  const int pair =
      m_library->find_pair(m_library->takes()[static_cast<std::size_t>(take)].name,
                           m_library->takes()[static_cast<std::size_t>(take)].frames / 2 /
                               std::max(1, m_library->takes()[static_cast<std::size_t>(take)].frame_stride) *
                               m_library->takes()[static_cast<std::size_t>(take)].frame_stride,
                           false);
  if (pair < 0) return pixmap;
  const PairPose& pose = m_library->pose(pair);
  const Eigen::RowVector3d low = pose.colwise().minCoeff(), high = pose.colwise().maxCoeff();
  const double scale = (picture - 6) / std::max({high.y() - low.y(), high.z() - low.z(), 0.1});
  const double middle = (low.z() + high.z()) / 2;
  const auto at = [&](int vertex) {
    return QPointF(picture / 2.0 + scale * (pose(vertex, 2) - middle),
                   picture - 3 - scale * (pose(vertex, 1) - low.y()));
  };
  for (const int body : {1, 0}) {
    painter.setPen(QPen(body == 0 ? m_palette.active : m_palette.passive, 1.6, Qt::SolidLine, Qt::RoundCap));
    for (int b = 0; b < bone_count; ++b)
      painter.drawLine(at(body * joint_count + bone(b).first), at(body * joint_count + bone(b).second));
  }
  return pixmap;
}

void TakeList::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!m_library) {
    painter.setPen(m_palette.secondary);
    painter.drawText(rect().adjusted(12, 10, -12, 0), Qt::AlignTop | Qt::TextWordWrap,
                     "No library. Open one (Ctrl+O) or drop a file here.");
    return;
  }
  const int takes = static_cast<int>(m_library->takes().size());
  const int last = std::min(takes - 1, event->rect().bottom() / row_height);
  for (int t = event->rect().top() / row_height; t <= last; ++t) {
    const LibraryTake& take = m_library->takes()[static_cast<std::size_t>(t)];
    const QRectF row(0, t * row_height, width(), row_height);
    if (t == m_current) {
      painter.fillRect(row, m_palette.raised);
      painter.fillRect(QRectF(row.topLeft(), QSizeF(2, row_height)), m_palette.warning);
    }
    if (t == m_selected) {
      painter.setPen(QPen(m_palette.accent, 1.5));
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(row.adjusted(5, 1.5, -3, -1.5), 4, 4);
    }
    painter.drawPixmap(QPointF(12, row.top() + 4), m_thumbnails[static_cast<std::size_t>(t)]);
    painter.setFont(interface_font(13, QFont::DemiBold));
    painter.setPen(m_palette.text);
    const QRectF words = row.adjusted(56, 3, -10, -3);
    painter.drawText(words.adjusted(0, 0, 0, -words.height() / 2), Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(QString::fromStdString(take.name), Qt::ElideRight,
                                                      static_cast<int>(words.width())));
    painter.setFont(interface_font(12));
    painter.setPen(m_palette.secondary);
    draw_tabular(painter, words.adjusted(0, words.height() / 2, 0, 0), Qt::AlignLeft,
                 QString("%1 frames · %2 moves").arg(take.frames).arg(take.labels.size()));
  }
}

}  // namespace abrazo::widgets

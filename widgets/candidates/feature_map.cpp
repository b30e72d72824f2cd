#include "widgets/candidates/feature_map.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/base/thread_urgency.hpp"
#include "widgets/candidates/pin_mark.hpp"
#include "widgets/common/qt_versions.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr double map_margin = 14;
constexpr double caught_px = 11;
constexpr double most_zoom = 16;
constexpr double longest_bar_px = 70;

}  // namespace

FeatureMap::FeatureMap(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setMouseTracking(true);
  setMinimumHeight(110);
  setAccessibleName("Feature-space neighbourhood");
  setAccessibleDescription("The library, the user's path, the candidates and the winner in a plane");
  setToolTip(
      "Dots: pairs of the library, in the colours of their moves.<br>Line and diamond: the user, the last 3 "
      "s "
      "and now.<br>Circles: the candidates; the ring marks the winner.<br>The plane is the one in which the "
      "15 "
      "feature coordinates spread most. Wheel: nearer to the user.");
}

FeatureMap::~FeatureMap() = default;

void FeatureMap::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  if (library == m_library) return;
  m_library = std::move(library);
  m_hasQuery = false;
  m_rows.clear();
  m_path.clear();
  m_cloud.reset();
  m_spots.clear();
  m_zoom = 1;
  wantCloud(UserRole::Active);
}

/// The old cloud is removed immediately: the drawing belongs to one library and role.
void FeatureMap::wantCloud(UserRole role) {
  m_role = role;
  m_cloud.reset();
  m_spots.clear();
  m_path.clear();
  m_picture = {};
  update();
  if (!m_library || m_library->pair_count() == 0) return;
  m_worker = std::jthread([this, library = m_library, role] {
    let_others_go_first();
    auto cloud = std::make_shared<const FeatureCloud>(*library, role);
    QMetaObject::invokeMethod(
        this,
        [this, cloud = std::move(cloud), library, role] {
          if (library != m_library || role != m_role) return;
          m_cloud = cloud;
          place(m_rows);
          update();
        },
        Qt::QueuedConnection);
  });
}

void FeatureMap::setColours(const Palette& palette) {
  m_palette = palette;
  m_picture = {};
  update();
}

void FeatureMap::setFrame(const FrameSnapshot& frame, const std::vector<CandidateRow>& rows) {
  if (frame.settings.user_role != m_role) wantCloud(frame.settings.user_role);
  m_query = frame.result.features;
  m_hasQuery = !rows.empty();
  m_rows = rows;
  place(rows);
  update();
}

void FeatureMap::place(const std::vector<CandidateRow>& rows) {
  m_spots.clear();
  if (!m_cloud || !m_library) return;
  for (const CandidateRow& row : rows)
    m_spots.push_back({row.candidate, row.pair,
                       m_cloud->projection(user_features(*m_library, row.pair, m_role)), row.label,
                       row.selected, row.pinned, row.vetoed});
}

void FeatureMap::setPath(const FrameHistory& history, double until_s) {
  m_path.clear();
  if (!m_cloud) return;
  for (const FrameSnapshotPtr& frame : history.range(until_s - path_s, until_s))
    if (!frame->result.candidates.empty() && frame->settings.user_role == m_role)
      m_path.push_back(m_cloud->projection(frame->result.features));
  update();
}

void FeatureMap::setLinked(int candidate) {
  if (candidate == m_linked) return;
  m_linked = candidate;
  update();
}

PlaneView FeatureMap::view() const {
  const PlaneView all = PlaneView::fitting(m_cloud->low, m_cloud->high, width(), height(), map_margin);
  return m_zoom > 1 && m_hasQuery ? all.nearer(m_zoom, m_cloud->projection(m_query)) : all;
}

QPointF FeatureMap::pixel(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d at = view().pixel(point);
  return {at.x(), at.y()};
}

std::optional<QPointF> FeatureMap::placeOf(int candidate) const {
  for (const Spot& spot : m_spots)
    if (spot.candidate == candidate) return pixel(spot.at);
  return std::nullopt;
}

void FeatureMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRect(0, 0, width(), 1), m_palette.border);
  if (!m_cloud) {
    painter.setFont(interface_font(12));
    painter.setPen(m_palette.secondary);
    painter.drawText(rect().adjusted(12, 0, -12, 0), Qt::AlignCenter,
                     m_library ? "Finding the plane of largest spread…" : "No library");
    return;
  }
  m_zoom > 1 ? paintCloud(painter) : painter.drawPixmap(0, 0, cloudPicture());
  if (m_hasQuery) {
    paintPath(painter);
    paintCandidates(painter);
  }
  paintWords(painter);
}

const QPixmap& FeatureMap::cloudPicture() {
  const double ratio = devicePixelRatioF();
  const QSize wanted = size() * ratio;
  if (m_picture.size() == wanted) return m_picture;
  m_picture = QPixmap(wanted);
  m_picture.setDevicePixelRatio(ratio);
  m_picture.fill(Qt::transparent);
  QPainter painter(&m_picture);
  painter.setRenderHint(QPainter::Antialiasing);
  paintCloud(painter);
  return m_picture;
}

void FeatureMap::paintCloud(QPainter& painter) const {
  const PlaneView to = view();
  for (const CloudPoint& point : m_cloud->points) {
    const Eigen::Vector2d at = to.pixel(point.at);
    if (at.x() < -2 || at.y() < -2 || at.x() > width() + 2 || at.y() > height() + 2) continue;
    const QColor colour = mixed(label_colour(m_palette, m_library->label(point.pair)), m_palette.panel, 0.42);
    painter.fillRect(QRectF(at.x() - 0.75, at.y() - 0.75, 1.5, 1.5), colour);
  }
}

void FeatureMap::paintPath(QPainter& painter) const {
  const PlaneView to = view();
  const auto at = [&to](const Eigen::Vector2d& point) {
    const Eigen::Vector2d pixel = to.pixel(point);
    return QPointF(pixel.x(), pixel.y());
  };
  const QPointF now = at(m_cloud->projection(m_query));
  painter.setBrush(Qt::NoBrush);
  for (std::size_t i = 0; i < m_path.size(); ++i) {
    QColor colour = m_palette.user;
    colour.setAlphaF(
        colour_part(0.15 + 0.75 * static_cast<double>(i + 1) / static_cast<double>(m_path.size())));
    painter.setPen(QPen(colour, 1.5, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(at(m_path[i]), i + 1 < m_path.size() ? at(m_path[i + 1]) : now);
  }
}

void FeatureMap::paintCandidates(QPainter& painter) const {
  const QPointF now = pixel(m_cloud->projection(m_query));
  for (const Spot& spot : m_spots) {
    const QPointF at = pixel(spot.at);
    const bool pointed = spot.candidate == m_linked || spot.candidate == m_told;
    painter.setOpacity(spot.vetoed ? 0.4 : 1);
    painter.setPen(QPen(pointed ? m_palette.text : m_palette.panel, pointed ? 1.6 : 1));
    painter.setBrush(label_colour(m_palette, spot.label));
    painter.drawEllipse(at, pointed ? 5 : 4, pointed ? 5 : 4);
    painter.setOpacity(1);
    if (spot.pair == m_currentPair) {
      painter.setPen(QPen(m_palette.text, 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(QRectF(at - QPointF(6.5, 6.5), QSizeF(13, 13)));
    }
    if (spot.pinned) draw_pin(painter, at + QPointF(0, -11), m_palette.warning, true);
    if (spot.vetoed) draw_veto(painter, at, m_palette.secondary);
    if (!spot.selected) continue;
    painter.setPen(QPen(m_palette.warning, 1.8));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, 7.5, 7.5);
  }
  painter.setPen(QPen(m_palette.panel, 1));
  painter.setBrush(m_palette.text);
  painter.drawPolygon(
      QPolygonF({now + QPointF(0, -5), now + QPointF(5, 0), now + QPointF(0, 5), now + QPointF(-5, 0)}));
}

/// How much of the truth the plane shows, and a length to measure by.
void FeatureMap::paintWords(QPainter& painter) const {
  painter.setFont(interface_font(11));
  painter.setPen(m_palette.secondary);
  painter.drawText(
      QRectF(12, 4, width() - 24, 16), Qt::AlignLeft,
      QString("Feature space · %1 % of the spread").arg(100 * m_cloud->projection.explained(), 0, 'f', 0));
  const double scale = view().pixels_per_metre;
  double length = std::pow(10, std::floor(std::log10(longest_bar_px / scale)));
  for (const double factor : {5.0, 2.0})
    if (factor * length * scale <= longest_bar_px) {
      length *= factor;
      break;
    }
  const double right = width() - 12, y = height() - 8, px = length * scale;
  painter.setPen(QPen(m_palette.secondary, 1));
  painter.drawLine(QPointF(right - px, y), QPointF(right, y));
  painter.drawText(QRectF(right - 80, y - 18, 80, 16), Qt::AlignRight | Qt::AlignBottom,
                   length >= 0.01 ? QString("%1 m").arg(length) : QString("%1 mm").arg(1000 * length));
}

void FeatureMap::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  m_picture = {};
}

int FeatureMap::candidateAt(const QPointF& position) const {
  int nearest = -1;
  double least = caught_px;
  for (const Spot& spot : m_spots) {
    const double distance = QLineF(pixel(spot.at), position).length();
    if (distance >= least) continue;
    least = distance;
    nearest = spot.candidate;
  }
  return nearest;
}

void FeatureMap::setCurrentPair(int pair) {
  if (pair == m_currentPair) return;
  m_currentPair = pair;
  update();
}

void FeatureMap::point(int candidate) {
  if (candidate == m_told) return;
  m_told = candidate;
  update();
  emit candidateHovered(candidate);
}

void FeatureMap::mouseMoveEvent(QMouseEvent* event) {
  if (m_cloud) point(candidateAt(event->localPos()));
}

void FeatureMap::mousePressEvent(QMouseEvent* event) {
  const int candidate = m_cloud && event->button() == Qt::LeftButton ? candidateAt(event->localPos()) : -1;
  if (candidate >= 0) emit candidateClicked(candidate);
}

void FeatureMap::mouseDoubleClickEvent(QMouseEvent* event) {
  const int candidate = m_cloud ? candidateAt(event->localPos()) : -1;
  if (candidate >= 0) emit candidateChosen(candidate);
}

void FeatureMap::wheelEvent(QWheelEvent* event) {
  m_zoom = std::clamp(m_zoom * std::pow(1.2, event->angleDelta().y() / 120.0), 1.0, most_zoom);
  update();
  event->accept();
}

void FeatureMap::leaveEvent(QEvent*) {
  point(-1);
}

}  // namespace abrazo::widgets

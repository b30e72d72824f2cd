#pragma once

#include <QPixmap>
#include <QWidget>
#include <memory>
#include <thread>
#include <vector>

#include "core/session/frames/frame_history.hpp"
#include "widgets/candidates/candidate_rows.hpp"
#include "widgets/candidates/feature_projection.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// The user among the recorded pairs: the library as a cloud in its principal plane, the path of the last
/// seconds, the candidates and the winner.
class FeatureMap : public QWidget {
  Q_OBJECT
 public:
  static constexpr double path_s = 3;

  explicit FeatureMap(QWidget* parent = nullptr);
  ~FeatureMap() override;
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  void setColours(const Palette& palette);
  void setFrame(const FrameSnapshot& frame, const std::vector<CandidateRow>& rows);
  /// Sets the path of the user's features in the seconds up to a time.
  void setPath(const FrameHistory& history, double until_s);
  /// Marks a candidate hovered in another view; -1 = none.
  void setLinked(int candidate);
  /// Marks the selected pair; -1 = none.
  void setCurrentPair(int pair);
  /// Whether the cloud is ready; it is computed on a separate thread.
  bool isReady() const { return m_cloud != nullptr; }
  /// Position of a candidate [px]; none without a cloud or such a candidate.
  std::optional<QPointF> placeOf(int candidate) const;
  QSize sizeHint() const override { return {300, 150}; }

 signals:
  void candidateHovered(int candidate);
  void candidateClicked(int candidate);
  void candidateChosen(int candidate);  ///< by a double click

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  struct Spot {
    int candidate, pair;
    Eigen::Vector2d at;
    std::string label;
    bool selected, pinned, vetoed;
  };
  void wantCloud(UserRole role);
  void place(const std::vector<CandidateRow>& rows);
  PlaneView view() const;
  QPointF pixel(const Eigen::Vector2d& point) const;
  int candidateAt(const QPointF& position) const;
  void point(int candidate);
  void paintCloud(QPainter& painter) const;
  const QPixmap& cloudPicture();
  void paintPath(QPainter& painter) const;
  void paintCandidates(QPainter& painter) const;
  void paintWords(QPainter& painter) const;

  Palette m_palette;
  std::shared_ptr<const MotionLibrary> m_library;
  UserRole m_role = UserRole::Active;
  std::shared_ptr<const FeatureCloud> m_cloud;
  Features m_query = Features::Zero();
  bool m_hasQuery = false;
  std::vector<CandidateRow> m_rows;
  std::vector<Spot> m_spots;
  std::vector<Eigen::Vector2d> m_path;
  QPixmap m_picture;  ///< of the whole cloud; null = redraw
  double m_zoom = 1;
  int m_linked = -1;
  int m_currentPair = -1;
  int m_told = -1;
  std::jthread m_worker;  ///< declared last: ends before the objects it reports to
};

}  // namespace abrazo::widgets

#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/session/frames/frame_history.hpp"
#include "core/session/run/live_loop.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/common/user_input.hpp"
#include "widgets/plots/plot_series.hpp"

namespace abrazo::app {

/// The line of the status bar: performance, and quality of the partner's motion.
class StatusFigures : public QWidget {
  Q_OBJECT
 public:
  /// State of the input.
  struct Input {
    QString name;
    widgets::UserInput from = widgets::UserInput::None;  ///< where poses come from at present
    double rate_hz = 0;                                  ///< of the poses
    std::optional<std::uint64_t> lost = {};              ///< lost frames; none = loss is impossible

    bool operator==(const Input&) const = default;
  };

  explicit StatusFigures(QWidget* parent = nullptr);
  void setColours(const widgets::Palette& palette);
  void setInput(const Input& input, int library_pairs);
  void setLibrary(int pairs) { m_pairs = pairs; }
  void showInput(const Input& input);
  /// Whether the input is held: by the user, or while a take is annotated.
  void showHeld(bool on) { m_isHeld = on; }
  /// @param clip  how far it is solved; none: the frames are live
  void refresh(const FrameHistory& history, std::uint64_t rendered_frames,
               const std::optional<LiveLoop::ClipProgress>& clip);

  /// The shown texts from left to right, such as "in 60 Hz".
  QStringList words() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Figure {
    QString name, value;
  };
  widgets::Palette m_palette;
  Input m_input;
  int m_pairs = 0;
  bool m_ok = true, m_isHeld = false;
  std::vector<Figure> m_left, m_right;
  std::uint64_t m_nextIndex = 0;
  std::uint64_t m_run = 0;  ///< of the clip's solution that was read
  std::uint64_t m_rendered = 0;
  double m_renderRate = 0;
  QElapsedTimer m_sinceRefresh;
  std::vector<double> m_solve_us;   ///< of recent frames
  std::vector<double> m_speed_m_s;  ///< of the partner, the same
  widgets::SeriesReader m_series;
};

}  // namespace abrazo::app

#pragma once

#include <QString>
#include <map>
#include <memory>
#include <string>

#include "core/session/frames/playback.hpp"
#include "core/session/frames/take_frames.hpp"

namespace abrazo::app {

class MainWindow;

/// Selects the frames of the window: those of the session, which continues meanwhile, or of a take of its
/// library. Each subject keeps its cursor, in and out while another is shown; changes of in and out are undo
/// steps.
class SubjectStage {
 public:
  explicit SubjectStage(MainWindow& window);

  /// @param subject a take by name; "" = the session
  Status show(const std::string& subject);
  /// Updates the shown take after the session's library was replaced.
  void renew();
  /// Resets after the end of the session.
  void forget();

  /// Frames of the shown take; null while the session is shown.
  const TakeFrames* take() const { return m_take.get(); }

 private:
  friend class EndsStep;
  void restoreEnds(const std::string& subject, const Playback::Ends& ends, const QString& what);
  void look(const std::shared_ptr<const TakeFrames>& take);
  void restore(const std::string& subject);
  void write(const std::string& subject);

  MainWindow& m_window;
  std::shared_ptr<const TakeFrames> m_take;
  std::map<std::string, Playback> m_places;
  bool m_heldInput = false;  ///< the clip was paused for the take
};

}  // namespace abrazo::app

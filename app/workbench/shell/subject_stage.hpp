#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/session/frames/playback.hpp"
#include "core/session/frames/take_frames.hpp"

namespace abrazo::app {

class MainWindow;

/// Which frames the window shows: those of the session, which goes on meanwhile, or of a take of its library.
/// Each keeps its cursor and its in and out while another is shown.
class SubjectStage {
 public:
  explicit SubjectStage(MainWindow& window) : m_window(window) {}

  /// @param subject  a take by name; "" = the session. @return what prevents it
  Status show(const std::string& subject);
  /// The shown take as it is in the session's library now: it was replaced.
  void renew();
  /// The session ended, and what was shown of it.
  void forget();

  /// Of the shown take; null while the session is shown.
  const TakeFrames* take() const { return m_take.get(); }

 private:
  void look(const std::shared_ptr<const TakeFrames>& take);
  void restore(const std::string& subject);
  void write(const std::string& subject);

  MainWindow& m_window;
  std::shared_ptr<const TakeFrames> m_take;
  std::map<std::string, Playback> m_places;
  bool m_heldInput = false;  ///< the clip was stopped for the take
};

}  // namespace abrazo::app

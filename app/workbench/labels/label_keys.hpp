#pragma once

#include <QObject>
#include <map>
#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/session/frames/playback.hpp"

class QKeyEvent;

namespace abrazo::app {

class AnnotationDesk;
class MainWindow;

/// Labelling by the keys of the vocabularies while the timeline has the focus.
///
/// While time goes on (playing, looping, live) a held key says its value from the press to the release; in
/// tapping mode each tap ends the last value of its tier and begins the next. While the cursor stands, a key
/// gives the selected label its value; without one it says the value of all between in and out, else from the
/// cursor to where the next label of its tier begins, and what is there is cut.
class LabelKeys : public QObject {
  Q_OBJECT
 public:
  LabelKeys(MainWindow& window, AnnotationDesk& desk);

  bool taps() const { return m_taps; }
  void setTaps(bool on);
  /// A tier has a value of this key: the active one, or else, of a digit, the only one.
  bool means(const QKeyEvent& event) const;
  /// Ends what is being said.
  void finish();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Running {
    int tier = 0;
    std::string value;
    double from_s = 0;
  };
  const AnnotationTier* tierOf(char key) const;
  void press(char key);
  void release(char key);
  void begin(char key, const AnnotationTier& tier, const std::string& value);
  void end(char key, double at_s);
  void sayParked(const AnnotationTier& tier, const std::string& value);
  void follow(const Playback& playback);
  void show();

  MainWindow& m_window;
  AnnotationDesk& m_desk;
  bool m_taps = false;
  std::map<char, Running> m_running;
  double m_last = 0;  ///< cursor of the tick before
};

}  // namespace abrazo::app

#pragma once

#include <QObject>
#include <QTimer>

#include "core/annotation/label_keys.hpp"

class QKeyEvent;

namespace abrazo::widgets {
class TimelineView;
}

namespace abrazo::app {

class AnnotationDesk;
class Document;
class FrameTicker;

/// Labelling by the keys of the vocabularies: keys and time go to `LabelKeys`, or to `say_at_cursor` while
/// the cursor is parked; the result becomes an edit of the document.
class LabelKeyFilter : public QObject {
  Q_OBJECT
 public:
  LabelKeyFilter(Document& document, widgets::TimelineView& timeline, const FrameTicker& ticker,
                 AnnotationDesk& desk);

  void setTaps(bool on);
  /// Whether keys are those of annotation: in the timeline, and wherever nothing is typed while a take is
  /// annotated.
  bool works() const;
  /// Whether a key that no view keeps sets a label. Its press is then taken before the focused view
  /// gets it.
  bool claims(const QKeyEvent& event);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const AnnotationTier* tierOf(char key) const;
  LabelKeys::Moment now() const;
  bool isPressed(const QKeyEvent& event);
  bool isReleased(const QKeyEvent& event);
  void press(char key);
  void draw(const std::vector<LabelKeys::Said>& said);
  void show();

  Document& m_document;
  widgets::TimelineView& m_timeline;
  const FrameTicker& m_ticker;
  const AnnotationDesk& m_desk;
  LabelKeys m_keys;
  QTimer m_settle;     ///< until a release counts
  char m_claimed = 0;  ///< the key whose press follows; 0 = none
};

}  // namespace abrazo::app

#pragma once

#include <QObject>

#include "core/annotation/label_keys.hpp"

class QKeyEvent;

namespace abrazo::widgets {
class TimelineView;
}

namespace abrazo::app {

class AnnotationDesk;
class Document;
class FrameTicker;

/// Labelling by the keys of the vocabularies while the timeline has the focus: keys and time go to
/// `LabelKeys`, or to `say_at_cursor` while the cursor is parked; the result becomes an edit of the document.
class LabelKeyFilter : public QObject {
  Q_OBJECT
 public:
  LabelKeyFilter(Document& document, widgets::TimelineView& timeline, const FrameTicker& ticker,
                 AnnotationDesk& desk);

  void setTaps(bool on);
  /// Whether a tier has a value with this key.
  bool means(const QKeyEvent& event) const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const AnnotationTier* tierOf(char key) const;
  LabelKeys::Moment now() const;
  void press(char key);
  void draw(const std::vector<LabelKeys::Said>& said);
  void show();

  Document& m_document;
  widgets::TimelineView& m_timeline;
  const FrameTicker& m_ticker;
  const AnnotationDesk& m_desk;
  LabelKeys m_keys;
};

}  // namespace abrazo::app

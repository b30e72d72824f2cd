#pragma once

#include "widgets/common/entry_frame.hpp"

namespace abrazo::widgets {

/// A field for one value above another widget: a time, a range, a name.
class QuickEntry : public EntryFrame {
  Q_OBJECT
 public:
  /// Opens a field; replaces an open one. @param above lower left corner in the widget
  static QuickEntry* open(QWidget& widget, const QPoint& above, const QString& prompt, const QString& start,
                          Take take);

 protected:
  void settle() override;

 private:
  QuickEntry(QWidget& window, const QString& prompt, const QString& start, Take take);
};

}  // namespace abrazo::widgets

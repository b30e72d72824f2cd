#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>
#include <vector>

#include "widgets/common/palette.hpp"

class QLabel;
class QPushButton;

namespace abrazo::widgets {

/// A session that was not closed properly.
struct LeftoverSession {
  QString file;
  QString words;  ///< "Session of 14:03 was not closed; 12 min, 3 takes"
  /// The file with which this one opens, so that it is not offered separately; empty = none.
  QString belongsTo = {};
};

/// Offers sessions that were not closed properly, one by one: open, keep for later, discard.
class LeftoverBar : public QWidget {
  Q_OBJECT
 public:
  explicit LeftoverBar(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void offer(std::vector<LeftoverSession> sessions);
  QString text() const;
  /// Whether this one is discarded; asked before it leaves the bar. Without one it is.
  std::function<bool(const LeftoverSession& session)> confirmDiscard;

 signals:
  void openRequested(const QString& file);
  void keepRequested(const QString& file);
  void discardRequested(const QString& file);

 private:
  void next();
  void showFirst();

  std::vector<LeftoverSession> m_sessions;
  QLabel* m_text;
  QPushButton *m_open, *m_keep, *m_discard;
};

}  // namespace abrazo::widgets

#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// Header of a panel: 11 px capitals, with an optional colour legend at the right if there is room.
class SectionHeader : public QWidget {
  Q_OBJECT
 public:
  struct Key {
    QString name;
    QColor colour;
    QString brief = {};  ///< for narrow panels; empty: the name
  };

  explicit SectionHeader(const QString& title, QWidget* parent = nullptr);
  void setTitle(const QString& title);
  const QString& title() const { return m_title; }
  void setKeys(std::vector<Key> keys);
  void setColours(const Palette& palette);
  QSize sizeHint() const override { return {160, 32}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString nameOf(const Key& key, bool brief) const;
  int widthOf(const QFontMetrics& metrics, bool brief) const;

  QString m_title;
  std::vector<Key> m_keys;
  QColor m_colour;
};

}  // namespace abrazo::widgets

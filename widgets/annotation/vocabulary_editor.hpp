#pragma once

#include <QWidget>

#include "widgets/common/annotation_types.hpp"
#include "widgets/common/palette.hpp"

class QLabel;
class QTableWidget;
class QTableWidgetItem;
class QToolButton;

namespace abrazo::widgets {

/// The vocabulary of a tier: values with key, colour and description. Renaming a value also renames it in the
/// tier's labels. Emits requests; shows what it is given.
class VocabularyEditor : public QWidget {
  Q_OBJECT
 public:
  explicit VocabularyEditor(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(const Annotations& annotations, int tier);

 signals:
  void changeRequested(const abrazo::Annotations& next, const QString& what);
  void refused(const QString& why);

 private:
  enum Column { Key, Colour, Value, Description };
  void fill();
  void edited(QTableWidgetItem* item);
  void chooseColour(int row);
  void add();
  void addUsed();
  /// Of labels, and not in the vocabulary; each once, in order of time.
  std::vector<std::string> usedOnly() const;
  void remove();
  void move(int by);
  void refuse(const QString& why);
  void settle(std::vector<VocabularyEntry> vocabulary, const QString& what);
  void rename(std::size_t row, const std::string& value);
  std::vector<VocabularyEntry> vocabulary() const;

  Palette m_palette;
  Annotations m_annotations;
  int m_tier = 0;
  bool m_filling = false;
  QTableWidget* m_table;
  QLabel* m_hint;
  QToolButton *m_used, *m_remove, *m_up, *m_down;
};

}  // namespace abrazo::widgets

#pragma once

#include <QStringList>
#include <QWidget>
#include <set>
#include <string>

#include "widgets/common/annotation_types.hpp"
#include "widgets/common/palette.hpp"

class QButtonGroup;
class QComboBox;
class QLabel;
class QScrollArea;
class QStackedWidget;
class QTableWidget;
class QTableWidgetItem;
class QToolButton;
class QVBoxLayout;

namespace abrazo::widgets {

class ProblemList;
class TierList;
class VocabularyEditor;

/// The annotations of a subject as lists: its tiers, the labels of the active one, their vocabulary,
/// problems. Changes nothing itself: it emits requests and shows what it is given.
class AnnotationPanel : public QWidget {
  Q_OBJECT
 public:
  explicit AnnotationPanel(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  QSize sizeHint() const override { return {360, 560}; }

  /// Adds a section of another part below the lists, e.g. suggestions. It has its own header and keeps its
  /// height.
  void addSection(QWidget* section);

  /// @param subjects names of the takes; the session comes first
  /// @param absent annotated takes that do not exist: listed and marked
  /// @param shown     "" = the session
  void showSubjects(const QStringList& subjects, const QStringList& absent, const QString& shown);
  /// In display order, the session first.
  QStringList subjects() const;
  struct Shown {
    Annotations annotations;
    Annotations::Range range;
    double fps = 0;
    int tier = 0, annotation = 0;
    Conflict conflict = Conflict::Replace;
    std::set<std::string> hidden;  ///< names of tiers with hidden lanes
  };
  void show(const Shown& shown);
  ProblemList& problems() const { return *m_problems; }
  VocabularyEditor& vocabulary() const { return *m_vocabulary; }
  QTableWidget& table() const { return *m_table; }

 signals:
  void subjectRequested(const QString& subject);
  void changeRequested(const abrazo::Annotations& next, const QString& what);
  /// The user wants the labels of what is shown as a file, or labels from one.
  void exportRequested();
  void importRequested();
  void refused(const QString& why);
  void tierChosen(int tier);
  void annotationChosen(int annotation);
  void seekRequested(double time_s);
  void conflictRequested(abrazo::Conflict conflict);
  void visibilityRequested(const QString& tier, bool on);

 private:
  enum Column { Start, End, Value, Detail, Confidence };
  QWidget* makeSubject();
  QWidget* makeConflict();
  QWidget* makeLists();
  void connectParts();
  void showList(int list);
  void fillTable();
  void fillRow(int row, const AnnotationTier& tier, const Annotation& annotation);
  QStringList values() const;
  std::string valueOf(const std::string& typed) const;
  void edited(QTableWidgetItem* item);
  void chooseRow();

  Palette m_palette;
  Shown m_shown;
  bool m_filling = false;
  QComboBox* m_subject = nullptr;
  QToolButton* m_back = nullptr;
  TierList* m_tiers = nullptr;
  QComboBox* m_conflict = nullptr;
  QButtonGroup* m_lists = nullptr;
  QScrollArea* m_scroll = nullptr;
  QStackedWidget* m_stack = nullptr;
  QTableWidget* m_table = nullptr;
  QLabel* m_coverage = nullptr;
  ProblemList* m_problems = nullptr;
  VocabularyEditor* m_vocabulary = nullptr;
  QVBoxLayout* m_column = nullptr;
};

}  // namespace abrazo::widgets

#pragma once

#include <QObject>
#include <QStringList>
#include <map>
#include <string>
#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo::app {

class AnnotationDesk;
class MainWindow;

/// Where a tier of a file goes.
struct TierTarget {
  enum class Way { LeaveOut, New, Into };
  Way way = Way::New;
  int tier = 0;  ///< of Way::Into
};

/// Where the tiers of a file go as far as their names and kinds say: into the tier of the same name, else
/// into the only one of the same kind that is one of roles or moves, else into a new one.
/// @return false with what is a guess
struct TierPlan {
  std::vector<TierTarget> targets;  ///< one for each
  bool is_clear = true;
};
TierPlan plan_tiers(const std::vector<Tier>& read, const Annotations& into);

/// What they say in place of what those tiers said; values come into vocabularies that have any.
Result<Annotations> imported(const std::vector<Tier>& read, const std::vector<TierTarget>& targets,
                             const Annotations& into, const Annotations::Range& range);

/// Label files into the tiers of the shown subject, as one step of undo.
class LabelImport : public QObject {
  Q_OBJECT
 public:
  LabelImport(MainWindow& window, AnnotationDesk& desk);
  /// Asks which files.
  void choose();
  /// Asks which tier goes where when that is not clear. Errors and omitted labels are reported.
  void read(const QStringList& files);

 private:
  void take(const QString& file, const TierDocument& document);
  void ask(const QString& file, const TierDocument& document, const TierPlan& plan);
  void finish(const QString& file, const TierDocument& document, const std::vector<TierTarget>& targets);

  MainWindow& m_window;
  AnnotationDesk& m_desk;
};

}  // namespace abrazo::app

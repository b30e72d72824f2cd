#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/annotation/suggestion_edits.hpp"

namespace abrazo::widgets {
class SuggestionSection;
}

namespace abrazo::app {

class AnnotationDesk;
class Document;
class Job;
class MainWindow;

/// Suggested labels and roles for the shown take. They are computed on a separate thread and become
/// annotations only if a person accepts them; each decision is an undo step.
class SuggestionDesk : public QObject {
  Q_OBJECT
 public:
  SuggestionDesk(MainWindow& window, AnnotationDesk& annotations);
  ~SuggestionDesk() override;

  void suggest(bool moves, bool roles);
  void cancel();
  /// Accepts the suggestion chosen in the list.
  void acceptCurrent();
  void editCurrent();
  void rejectCurrent();
  /// Focuses the list of suggestions.
  void focusList();

  widgets::SuggestionSection& section() const { return *m_section; }

 private:
  void take(const SuggestionRequest& request, const SuggestedTiers& suggested);
  void accept(int suggestion);
  void acceptAll(const std::vector<int>& suggestions);
  void edit(int suggestion);
  void reject(int suggestion);

  MainWindow& m_window;
  Document& m_document;
  AnnotationDesk& m_annotations;
  widgets::SuggestionSection* m_section;
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app

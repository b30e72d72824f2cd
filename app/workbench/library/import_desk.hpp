#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>

#include "app/workbench/library/import_panel.hpp"

namespace abrazo::app {

class Job;
class MainWindow;
class MappingDialog;

/// Asks how a motion is read of which the file leaves that open, or of which the user wants to say so;
/// remembers it for files alike, and opens the file with it, or builds the library again where the file is of
/// a take. What is open stays until then.
class ImportDesk : public QObject {
  Q_OBJECT
 public:
  explicit ImportDesk(MainWindow& window);
  ~ImportDesk() override;
  /// Shows the panel for the motion among these files.
  /// @param said  how it was read before; none = as was said of files alike
  void offer(const QStringList& files, const std::optional<MotionReading>& said = std::nullopt);
  /// For the motion that plays the user. @return whether it is of a file
  bool offerOpenOne();
  /// For a performer of a take in the library. Accepted, the library is built again with it, if the take is
  /// read in another way than before. Says so where nobody knows what the library was built from.
  /// @param second  performer B
  void offerTake(int take, bool second);
  /// Null if no panel is open.
  ImportPanel* panel() const { return m_panel; }
  /// Shows what is remembered, to be removed.
  void showRules();

 private:
  /// @param accepted  what is done with what was said
  void show(const MotionReading& reading, bool by_rule, std::function<void(const ImportView&)> accepted);
  void open(const QStringList& files, const MotionReading& reading);
  void look(const MotionReading& reading, bool by_rule);
  void lookNext();
  void assignJoints(const UnmappedMotion& motion);
  void accept();
  bool remember(const MotionReading& reading);

  MainWindow& m_window;
  QPointer<ImportPanel> m_panel;
  QPointer<MappingDialog> m_mapping;
  std::function<void(const ImportView&)> m_accepted;
  std::shared_ptr<ImportPreview> m_preview;  ///< used by one job at a time
  struct Look {
    MotionReading reading;
    bool by_rule = false;  ///< as was said of files alike
  };
  std::optional<Look> m_next;
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app

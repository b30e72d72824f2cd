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

/// Asks how to read a motion file that is ambiguous, or for which the user requests it. Remembers the answer
/// for similar files, and opens the file with it, or builds the library again if the file belongs to a take.
/// The open session stays until then.
class ImportDesk : public QObject {
  Q_OBJECT
 public:
  explicit ImportDesk(MainWindow& window);
  ~ImportDesk() override;
  /// Shows the panel for the motion among these files.
  /// @param said  how it was read before; none = by the rule for similar files
  void offer(const QStringList& files, const std::optional<MotionReading>& said = std::nullopt);
  /// For the motion that plays the user. @return whether it was read from a file
  bool offerOpenOne();
  /// For a performer of a take in the library. If the user accepts other values than before, the library is
  /// built again. Shows a message if the files of the library are unknown.
  /// @param second  performer B
  void offerTake(int take, bool second);
  /// Null if no panel is open.
  ImportPanel* panel() const { return m_panel; }
  /// Lists the remembered rules, which can be removed there.
  void showRules();

 private:
  /// @param accepted  called with the accepted values
  void show(const MotionReading& reading, bool by_rule, std::function<void(const ImportView&)> accepted);
  void open(const QStringList& files, const MotionReading& reading);
  struct Look {
    MotionReading reading;
    bool by_rule = false;   ///< from the rule for similar files
    bool is_first = false;  ///< of the panel
  };
  void look(const Look& next);
  void lookNext();
  void assignJoints(const UnmappedMotion& motion);
  void accept();
  bool remember(const MotionReading& reading);

  MainWindow& m_window;
  QPointer<ImportPanel> m_panel;
  QPointer<MappingDialog> m_mapping;
  std::function<void(const ImportView&)> m_accepted;
  std::shared_ptr<ImportPreview> m_preview;  ///< used by one job at a time
  std::optional<Look> m_next;
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app

#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <memory>
#include <optional>

#include "core/session/frames/comparison_plan.hpp"
#include "core/session/run/comparison_runner.hpp"
#include "widgets/compare/compare_panel.hpp"

namespace abrazo::widgets {
class SceneView;
}

namespace abrazo::app {

class Document;
class FrameTicker;

/// Keeps A, determines what is compared, and passes results from the runners to panel and scene.
class ComparisonDesk : public QObject {
  Q_OBJECT
 public:
  /// All outlive the desk, which belongs to the panel.
  ComparisonDesk(Document& document, FrameTicker& ticker, widgets::SceneView& scene,
                 widgets::ComparePanel& panel);
  ~ComparisonDesk() override;

  const std::optional<Settings>& frozen() const { return m_frozen; }
  bool isAside() const { return m_isAside; }
  /// Number of the session that A is of: A ends with it.
  int session() const { return m_session; }
  /// The shown comparison; null = none.
  const Comparison* shown() const { return m_shown.get(); }
  /// Whether a what-if was requested, done or not.
  bool hasAsked() const { return m_whatIf.asked.has_value(); }

 public slots:
  /// Freezes the present settings as A.
  void freeze();
  /// Sets A; none releases it.
  void setFrozen(const std::optional<Settings>& settings);
  /// Keeps A in the live solver while other settings are tried.
  void setAside(bool on);
  void cancel();

 signals:
  void frozenChanged(bool isFrozen);
  void asideChanged(bool isAside);

 private:
  /// A runner with its last task.
  struct Work {
    std::unique_ptr<ComparisonRunner> runner;
    std::optional<ComparisonTask> asked;
    std::shared_ptr<const Comparison> result;
    std::uint64_t seen = 0;
    bool isOf(const std::optional<ComparisonTask>& task) const;
  };

  void startSession();
  void endSession();
  void tryWhereParked();
  void refresh();
  void plan(const CompareSituation& now);
  void ask(Work& work, const std::optional<ComparisonTask>& task);
  void poll(Work& work);
  void choose(const CompareSituation& now);
  void showPanel(const CompareSituation& now);
  void showGhosts();
  CompareSituation situation() const;

  Document& m_document;
  FrameTicker& m_ticker;
  widgets::SceneView& m_scene;
  widgets::ComparePanel& m_panel;
  std::optional<Settings> m_frozen;
  double m_frozenAt_s = 0;
  bool m_isAside = false;
  int m_session = 0;
  std::optional<Settings> m_tried;  ///< last seen settings, and when they and the cursor last changed
  double m_cursor_s = 0;
  QElapsedTimer m_still;
  Work m_whatIf, m_shadow;
  std::optional<ComparisonTask> m_cancelled;
  std::shared_ptr<const Comparison> m_shown, m_listed;  ///< chosen; as the panel has it
};

}  // namespace abrazo::app

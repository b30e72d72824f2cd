#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/library/build_dialog.hpp"
#include "app/workbench/library/mapping_dialog.hpp"
#include "core/opening/material.hpp"

namespace abrazo::app {

class Job;

/// Builds a library from motion files: the dialog, and reading and building on a worker. The GUI thread reads
/// no file.
class LibraryBuild : public QObject {
  Q_OBJECT
 public:
  LibraryBuild(QWidget* window, const widgets::Palette& palette);
  ~LibraryBuild() override;
  /// Adds files to the plan and shows the dialog.
  void offer(const QStringList& files);
  void setColours(const widgets::Palette& palette);
  /// Sets the folder of the user's joint maps.
  void setJointMaps(const QString& folder) { m_maps = folder; }
  MappingDialog* mapping() const { return m_mapping; }
  BuildDialog& dialog() { return *m_dialog; }
  /// Reading or building is running.
  bool isBusy() const;

 signals:
  /// Its warnings include what was written.
  /// @param is_taken  to be set to false if the present session stays: the dialog stays, too
  void built(const abrazo::Material& material, bool& is_taken);
  void userChosen(const QStringList& files);
  /// The dialog was closed without a result and has no plan that could be continued.
  void givenUp();
  /// The plan is to be discarded, and an empty one begun.
  void startOver();

 private:
  struct Survey {
    Manifest::Performer source;
    std::optional<double> fps;
  };
  struct Read;
  void survey(const Manifest::Performer& source, std::optional<double> fps);
  void readLabels(const QString& file);
  void readNext();
  void show(const Read& read);
  void askForJoints(const Read& read);
  std::vector<std::string> labelledTakes(const Read& read) const;
  void build();
  void stop();
  void begin(std::function<std::function<void()>(const Progress&)> work, const QString& doing);

  QWidget* m_window;
  widgets::Palette m_palette;
  QPointer<BuildDialog> m_dialog;
  QStringList m_skeletons;
  std::string m_jointMap;
  std::vector<Survey> m_surveys;
  QString m_labels, m_maps;
  QPointer<MappingDialog> m_mapping;
  std::unique_ptr<Job> m_job;
  bool m_finished = false;  ///< the dialog closes with a result
};

}  // namespace abrazo::app

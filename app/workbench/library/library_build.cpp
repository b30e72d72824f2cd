#include "app/workbench/library/library_build.hpp"

#include <QFileInfo>
#include <algorithm>
#include <filesystem>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/library/mapping_dialog.hpp"
#include "core/base/atomic_file.hpp"
#include "core/library/build/saved_build.hpp"
#include "core/opening/file_kinds.hpp"
#include "core/opening/joint_maps.hpp"
#include "core/opening/open_files.hpp"

namespace abrazo::app {

/// What a worker read, for the GUI thread to show.
struct LibraryBuild::Read {
  std::vector<std::vector<PlannedPerformer>> files;
  std::optional<QString> labels;  ///< of which `labelled` are the takes
  std::vector<std::string> labelled;
  QString trouble;
  UnmappedMotion unmapped;             ///< the first whose points are unknown
  std::vector<Survey> without_joints;  ///< it and those that may be like it
};

LibraryBuild::LibraryBuild(QWidget* window, const widgets::Palette& palette)
    : QObject(window), m_window(window), m_palette(palette), m_dialog(new BuildDialog(window)) {
  m_dialog->setColours(palette);
  connect(m_dialog, &BuildDialog::filesOffered, this, &LibraryBuild::offer);
  connect(m_dialog, &BuildDialog::surveyRequested, this, &LibraryBuild::survey);
  connect(m_dialog, &BuildDialog::labelsRequested, this, &LibraryBuild::readLabels);
  connect(m_dialog, &BuildDialog::buildRequested, this, &LibraryBuild::build);
  connect(m_dialog, &BuildDialog::cancelRequested, this, &LibraryBuild::stop);
  connect(m_dialog, &BuildDialog::userChosen, this, [this](const QString& motion, const QString& skeleton) {
    stop();
    m_finished = true;
    m_dialog->close();
    QStringList files{motion};
    if (!skeleton.isEmpty()) files << skeleton;
    emit userChosen(files);
  });
  connect(m_dialog, &QDialog::finished, this, [this] {
    if (!m_finished && m_dialog->model().rowCount() == 0) emit givenUp();
  });
  connect(m_dialog, &BuildDialog::startOverRequested, this, &LibraryBuild::startOver);
}

LibraryBuild::~LibraryBuild() {
  if (!m_dialog) return;
  m_dialog->hide();
  m_dialog->deleteLater();
}

void LibraryBuild::setColours(const widgets::Palette& palette) {
  m_palette = palette;
  m_dialog->setColours(palette);
}

bool LibraryBuild::isBusy() const {
  return m_job != nullptr;
}

void LibraryBuild::offer(const QStringList& files) {
  QStringList not_of_use;
  std::vector<std::string> motions;
  for (const QString& file : files) {
    const FileKind kind = kind_of_file(file.toStdString());
    const bool is_table = file.endsWith(".csv", Qt::CaseInsensitive);
    if (kind == FileKind::Motion)
      motions.push_back(file.toStdString());
    else if (kind == FileKind::Skeleton)
      m_skeletons << file;
    else if (kind == FileKind::JointMap)
      m_jointMap = file.toStdString();
    else if (kind == FileKind::Labels || is_table)
      m_labels = file;
    else
      not_of_use << QFileInfo(file).fileName();
  }
  m_dialog->setSkeletons(m_skeletons);
  std::vector<std::string> skeletons;
  for (const QString& skeleton : m_skeletons) skeletons.push_back(skeleton.toStdString());
  for (const std::string& motion : motions) {
    Survey survey;
    survey.source.motion = motion;
    if (QString::fromStdString(motion).endsWith(".amc", Qt::CaseInsensitive))
      survey.source.skeleton = guess_skeleton(motion, skeletons);
    survey.source.joint_map = m_jointMap;
    m_surveys.push_back(survey);
  }
  m_dialog->show();
  m_dialog->raise();
  readNext();
  if (!not_of_use.isEmpty())
    m_dialog->showError(not_of_use.join(", ") + ": no motion, skeleton or labels; open a library by itself");
}

void LibraryBuild::stop() {
  Job::retire(std::move(m_job), this);
  m_surveys.clear();
  m_labels.clear();
  m_dialog->endProgress();
}

void LibraryBuild::survey(const Manifest::Performer& source, std::optional<double> fps) {
  m_surveys.push_back({source, fps});
  readNext();
}

void LibraryBuild::readLabels(const QString& file) {
  if (file.isEmpty()) return m_dialog->model().setLabels({}, {});
  m_labels = file;
  readNext();
}

void LibraryBuild::begin(std::function<std::function<void()>(const Progress&)> work, const QString& doing) {
  m_dialog->showProgress(doing, 0);
  m_job = std::make_unique<Job>(std::move(work));
  connect(m_job.get(), &Job::progressed, m_dialog,
          [this](double fraction, const QString& what) { m_dialog->showProgress(what, fraction); });
  connect(m_job.get(), &Job::finished, this, [this] {
    Job::retire(std::move(m_job), this);
    readNext();
  });
}

/// Reads all pending files in one job; later requests follow it.
void LibraryBuild::readNext() {
  if (m_job || (m_surveys.empty() && m_labels.isEmpty())) return;
  auto work = [this, surveys = std::exchange(m_surveys, {}), labels = std::exchange(m_labels, {}),
               maps = m_maps.toStdString()](const Progress& progress) -> Job::Finish {
    auto read = std::make_shared<Read>();
    for (std::size_t i = 0; i < surveys.size(); ++i) {
      const std::string name = surveys[i].source.motion.filename().string();
      const double fraction = static_cast<double>(i) / static_cast<double>(surveys.size());
      if (!report(progress, fraction, "Reading " + name)) return {};
      const Progress going_on = part(progress, fraction, fraction);
      auto found = survey_motion(surveys[i].source, surveys[i].fps, going_on);
      if (const auto unmapped = !found.front().trouble || !surveys[i].source.joint_map.empty()
                                    ? nullptr
                                    : motion_without_joints({surveys[i].source.motion.string()}, going_on)) {
        Survey again = surveys[i];
        again.source.joint_map = remembered_map(*unmapped, maps);
        if (!again.source.joint_map.empty()) {
          found = survey_motion(again.source, again.fps, going_on);
        } else {
          read->without_joints.push_back(again);
          if (!read->unmapped) read->unmapped = unmapped;
        }
      }
      read->files.push_back(std::move(found));
    }
    if (!labels.isEmpty()) {
      const auto csv = read_whole_file(labels.toStdString());
      const bool table = labels.endsWith(".csv", Qt::CaseInsensitive);
      if (csv)
        read->labels = labels, read->labelled = table ? takes_in_labels(*csv) : std::vector<std::string>();
      else
        read->trouble = words(csv.error());
    }
    return [this, read] { show(*read); };
  };
  begin(std::move(work), "Reading");
}

void LibraryBuild::show(const Read& read) {
  const auto readable = [this] {
    const auto& performers = m_dialog->model().plan().performers;
    return std::count_if(performers.begin(), performers.end(),
                         [](const auto& one) { return one.clip != nullptr; });
  };
  const int before = m_dialog->model().rowCount();
  const auto readable_before = readable();
  if (!read.files.empty()) m_dialog->model().setSurveyed(read.files);
  if (m_dialog->model().rowCount() != before || readable() != readable_before) m_dialog->model().pairUp();
  if (read.labels) m_dialog->model().setLabels(*read.labels, labelledTakes(read));
  m_dialog->endProgress();
  if (!read.trouble.isEmpty()) m_dialog->showError(read.trouble);
  if (read.unmapped) askForJoints(read);
}

/// A file without take names has the labels of the only take.
std::vector<std::string> LibraryBuild::labelledTakes(const Read& read) const {
  if (!read.labelled.empty()) return read.labelled;
  std::vector<std::string> takes;
  for (const PlannedPerformer& performer : m_dialog->model().plan().performers)
    if (!performer.take.empty() && std::count(takes.begin(), takes.end(), performer.take) == 0)
      takes.push_back(performer.take);
  if (takes.size() > 1) takes.clear();
  return takes;
}

/// The answer for the first is stored and found again for others with the same point names.
void LibraryBuild::askForJoints(const Read& read) {
  delete m_mapping;
  m_mapping = new MappingDialog(*read.unmapped, m_dialog);
  m_mapping->setAttribute(Qt::WA_DeleteOnClose);
  m_mapping->setColours(m_palette);
  connect(m_mapping, &QDialog::accepted, this, [this, again = read.without_joints] {
    const auto map = m_mapping->keep(m_maps);
    if (!map) return m_dialog->showError(words(map.error()));
    const MotionReading said = m_mapping->said();
    for (Survey survey : again) {
      if (!said.up.empty()) survey.source.up_axis = find_up_axis(said.up);
      if (said.metres_per_unit) survey.source.metres_per_unit = said.metres_per_unit;
      if (said.fps) survey.fps = said.fps;
      m_surveys.push_back(survey);
    }
    readNext();
  });
  m_mapping->open();
}

void LibraryBuild::build() {
  if (m_job || !m_dialog->model().canBuild()) return;
  const BuildOutputs outputs = m_dialog->outputs();
  auto work = [this, manifest = manifest_of(m_dialog->model().plan()),
               outputs](const Progress& progress) -> Job::Finish {
    std::vector<std::string> warnings;
    auto library = build_and_save(manifest, {outputs.library.toStdString(), outputs.manifest.toStdString()},
                                  progress, warnings);
    if (!library) return [this, why = words(library.error())] { m_dialog->showError(why); };
    for (const QString& file : {outputs.library, outputs.manifest})
      if (!file.isEmpty()) warnings.push_back("written to " + file.toStdString());
    const QString& file = outputs.library.isEmpty() ? outputs.manifest : outputs.library;
    const Material material = built_material(std::make_shared<const MotionLibrary>(std::move(*library)),
                                             manifest, file.toStdString(), std::move(warnings));
    return [this, material] {
      m_dialog->endProgress();
      bool is_taken = true;
      emit built(material, is_taken);
      if (!is_taken)
        return m_dialog->showError("The library was not opened, because the present session stays");
      m_finished = true;
      m_dialog->close();
    };
  };
  begin(std::move(work), "Building");
}

}  // namespace abrazo::app

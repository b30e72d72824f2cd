#include "app/workbench/export/export_desk.hpp"

#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/base/output_file.hpp"
#include "core/session/export/exporting.hpp"
#include "core/session/frames/take_frames.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/offer_bar.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

QString session_name(const RecordedSession& session) {
  return QFileInfo(QString::fromStdString(session.file)).completeBaseName();
}

using widgets::PlotExport;

constexpr const char* export_job = "export";  // of the messages

}  // namespace

ExportDesk::ExportDesk(MainWindow& window, std::function<RecordedTakes()> takes)
    : QObject(&window), m_window(window), m_takes(std::move(takes)) {
  m_bar = new widgets::OfferBar;
  m_bar->setObjectName("exported");
  window.colour(m_bar);
  window.addBelowMessages(m_bar);
  connect(&window.messages(), &widgets::MessageBar::cancelRequested, this, [this] {
    if (m_job) m_job->cancel();
  });
}

ExportDesk::~ExportDesk() = default;

ExportOffer ExportDesk::offer() const {
  ExportOffer offer;
  auto* session = m_window.session();
  if (!session) return offer;
  // Also the annotated take: it is among those of the library.
  const FrameHistory& history = session->engine().history();
  const auto span = history.span();
  const Material& material = session->material();
  const Playback& playback = m_window.ticker().playback();
  if (span.frames + span.stored > 0) {
    offer.session = {
        material.recorded ? "Session " + session_name(*material.recorded) : QString("This session"),
        {span.first_s, span.last_s}};
    offer.times_s = history.times(span.first_s, span.last_s);
  }
  if (!session->looksElsewhere()) {
    offer.range = playback.range();
    offer.cursor_s = m_window.ticker().shown() ? m_window.ticker().shown()->time_s : playback.cursor_s;
  }
  const FrameSnapshotPtr newest = session->engine().latest().newest();
  const Settings& settings = newest ? newest->settings : m_window.document().settings();
  offer.partner = settings.user_role == UserRole::Passive ? SessionBody::Active : SessionBody::Passive;
  const auto& files = m_window.scene().options().character_files;
  for (std::size_t body = 0; body < files.size(); ++body)
    offer.worn[body] = QString::fromStdString(files[body]);
  const RecordedTakes takes = m_takes();
  for (const RecordedTake& take : takes.all())
    offer.takes.push_back({QString::fromStdString(take.name), {take.from_s, take.to_s}});
  for (const LibraryTake& take : material.library->takes())
    offer.library_takes.push_back(
        {QString::fromStdString(take.name), {0, std::max(0, take.frames - 1) / take.fps}});
  offer.times_of_take = [library = material.library](const QString& take) {
    const auto frames = TakeFrames::create(library, take.toStdString());
    if (!frames) return std::vector<double>();
    const FrameStore::Span whole = (*frames)->span();
    return (*frames)->times(whole.first_s, whole.last_s);
  };
  return offer;
}

/// Only the requested frames: the rest of a long session is not examined.
RunningExport ExportDesk::running(const ExportWish& wish) const {
  auto& session = *m_window.session();
  const FrameHistory& history = session.engine().history();
  const auto span = history.span();
  const Material& material = session.material();
  RunningExport running;
  running.name = material.recorded ? session_name(*material.recorded).toStdString() : "session";
  const double at_s = wish.at_s.value_or(0);
  running.frames = wish.at_s ? history.stretch(at_s - 1, at_s)
                             : history.stretch(wish.part.from_s.value_or(span.first_s),
                                               wish.part.to_s.value_or(span.last_s));
  running.library = material.library;
  running.library_name = material.library_file.empty() ? material.library->name() : material.library_file;
  running.input = material.input.name;
  const RecordedTakes takes = m_takes();
  for (const RecordedTake& take : takes.all())
    running.takes.push_back({static_cast<int>(take.id), take.name, take.from_s, take.to_s, 0, 0, {}, false});
  for (const Marker& marker : m_window.document().project().markers.all())
    running.markers.push_back({marker.id, marker.time_s, marker.name});
  running.noted = tiers_of(m_window.document().live().annotations().of(""));
  return running;
}

ExportDesk::MakeSource ExportDesk::source_of(const ExportRequest& request) const {
  if (request.library_take.isEmpty())
    return [running = running(request.wish)](const Progress& progress) {
      return export_of_history(running, progress);
    };
  const std::string take = request.library_take.toStdString();
  return [library = m_window.session()->material().library, take,
          noted = tiers_of(m_window.document().live().annotations().of(take))](
             const Progress&) -> Result<std::unique_ptr<ExportSource>> {
    if (library->find_take(take) < 0) return Error{"is no longer in the library", take};
    return export_of_take(library, take, noted);
  };
}

void ExportDesk::write(const ExportRequest& request, const QString& file) {
  auto& messages = m_window.messages();
  if (m_job) return messages.showInformation("An export is running; wait for it, or cancel it");
  if (request.plots) {
    const PlotExport type = file.endsWith(".png")   ? PlotExport::Png
                            : file.endsWith(".svg") ? PlotExport::Svg
                                                    : PlotExport::Csv;
    const QString trouble = save_plots(m_window, type, file);
    if (!trouble.isEmpty()) return messages.showErrorOf(export_job, trouble);
    ExportReport done;
    done.files = {file.toStdString()};
    done.text = "plots";
    return tell(done);
  }
  if (!m_window.session()) return messages.showInformation("Nothing is open yet");
  ExportWish wish = request.wish;
  wish.output = file.toStdString();
  for (const std::string& output : wish.files())
    if (const Status usable =
            check_output(output, {m_window.session()->material().library_file, wish.character});
        !usable)
      return messages.showErrorOf(export_job, words(usable.error()));
  run(source_of(request), wish);
}

void ExportDesk::run(const MakeSource& make, const ExportWish& wish) {
  m_job = std::make_unique<Job>([this, make, wish](const Progress& progress) -> Job::Finish {
    const auto failed = [this](const Error& error) {
      return [this, text = words(error)] {
        if (m_job->wasCancelled())
          m_window.messages().showInformation("The export was cancelled; nothing was written");
        else
          m_window.messages().showErrorOf(export_job, text);
      };
    };
    const auto source = make(part(progress, 0, 0.3));
    if (!source) return failed(source.error());
    auto done = export_session(**source, wish, part(progress, 0.3, 1));
    if (!done) return failed(done.error());
    return [this, report = std::make_shared<ExportReport>(std::move(*done))] { tell(*report); };
  });
  auto& messages = m_window.messages();
  const QString name = QFileInfo(QString::fromStdString(wish.output)).fileName();
  messages.showProgress("Exporting " + name, 0);
  connect(m_job.get(), &Job::progressed, &messages, [&messages, name](double done, const QString& doing) {
    messages.showProgress(QString("Exporting %1: %2").arg(name, doing), done);
  });
  connect(m_job.get(), &Job::finished, this, &ExportDesk::finish);
}

void ExportDesk::finish() {
  m_window.messages().endProgress();
  Job::retire(std::move(m_job), this);
  emit ended();
}

void ExportDesk::tell(const ExportReport& done) {
  const QString file = QString::fromStdString(done.files.back());
  constexpr std::size_t most_named = 3;  // the bodies; a series has thousands of files
  QStringList names;
  for (const std::string& each : done.files)
    if (done.files.size() <= most_named || &each == &done.files.back())
      names << QFileInfo(QString::fromStdString(each)).fileName();
  QStringList warnings;
  for (const Warning& warning : done.warnings) warnings << QString::fromStdString(warning.text(window_words));
  QString text = QString("%1: %2").arg(names.join(", "), QString::fromStdString(done.text));
  if (done.files.size() > most_named) text += QString(", %1 files").arg(done.files.size());
  if (!warnings.isEmpty()) text += QString(" · %1").arg(warnings.join(" · "));
  m_window.messages().endProgress();
  m_window.messages().succeed(export_job, "Exported " + text, true);
  m_bar->offer(
      text, "Show in folder",
      [file] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(file).absolutePath())); },
      warnings.join("\n"));
}

}  // namespace abrazo::app

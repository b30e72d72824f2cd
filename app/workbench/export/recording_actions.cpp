#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QStandardPaths>
#include <QStatusBar>

#include "app/workbench/base/range_words.hpp"
#include "app/workbench/base/render_dialog.hpp"
#include "app/workbench/export/view_recording.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

QString ask_file(MainWindow& window, QWidget* over, const QString& title) {
  QString folder = QStandardPaths::writableLocation(QStandardPaths::MoviesLocation);
  if (folder.isEmpty() || !QFileInfo(folder).isDir()) folder = window.remembered().lastFolder();
  const QString name = "abrazo-" + QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss") + ".mp4";
  return widgets::choose_new_file(over, title, QDir(folder).filePath(name), ".mp4", "Video (*.mp4)");
}

void tell_end(MainWindow& window, const QString& trouble, const QString& words) {
  trouble.isEmpty() ? window.messages().succeed("film", words)
                    : window.messages().showErrorOf("film", trouble);
}

/// One action that starts and stops. The other way of recording waits meanwhile.
struct Film {
  ViewRecording* recording;
  QAction* action;
  QString start_text;
};

void show_state(MainWindow& window, const Film& film, QLabel& mark, QAction& other) {
  const bool runs = film.recording->isRunning();
  film.action->setText(runs ? "Stop recording" : film.start_text);
  other.setEnabled(!runs);
  mark.setVisible(runs);
  if (!runs) return;
  const int seconds = static_cast<int>(film.recording->elapsed_s());
  mark.setText(QString("<span style='color:%1'>●</span> REC %2:%3")
                   .arg(window.colours().live.name())
                   .arg(seconds / 60)
                   .arg(seconds % 60, 2, 10, QChar('0')));
}

Film make_film(MainWindow& window, const QString& text, ViewRecording::TakePicture take) {
  auto* recording = new ViewRecording(std::move(take), &window);
  QAction* action = add_action(window, menu_of(window, "File"), text, {}, [&window, recording] {
    if (recording->isRunning()) return recording->stop();
    if (recording->isBusy())
      return window.messages().showInformation("A recording is being started or written; wait a moment");
    const QString file = ask_file(window, &window, "Record as video");
    if (!file.isEmpty() && !recording->isBusy()) recording->start(file);
  });
  QObject::connect(
      recording, &ViewRecording::ended, &window,
      [&window](const QString& trouble, const QString& words) { tell_end(window, trouble, words); });
  return {recording, action, text};
}

void show_progress(MainWindow& window, RangeRendering& rendering, const QString& file) {
  auto& messages = window.messages();
  QElapsedTimer clock;
  clock.start();
  QObject::connect(&rendering, &RangeRendering::progressed, &messages, [&messages, clock](int done, int all) {
    const double left_s = 0.001 * static_cast<double>(clock.elapsed()) * (all - done) / done;
    messages.showProgress(
        QString("Rendering picture %1 of %2, %3 left").arg(done).arg(all).arg(about(left_s)),
        static_cast<double>(done) / all);
  });
  QObject::connect(&messages, &widgets::MessageBar::cancelRequested, &rendering, [&] {
    rendering.cancel();
    rendering.deleteLater();
    messages.endProgress();
    messages.showInformation("Rendering was cancelled; nothing was written");
  });
  QObject::connect(&rendering, &RangeRendering::ended, &messages, [&, file](const QString& trouble) {
    messages.endProgress();
    tell_end(window, trouble, "Video written to " + file);
    rendering.deleteLater();
  });
}

void open_dialog(MainWindow& window, RenderDialog& dialog) {
  if (const auto* past = window.ticker().history(); !past || past->span().frames + past->span().stored < 2)
    return window.messages().showInformation("There is nothing recorded yet");
  if (window.findChild<RangeRendering*>())
    return window.messages().showInformation("A range is being rendered; wait for it, or cancel it");
  const QSize view = (QSizeF(window.scene().size()) * window.devicePixelRatioF()).toSize();
  dialog.offer(window.ticker().playback(), window.ticker().playback().range(), view);
  dialog.show();
  dialog.activateWindow();
}

}  // namespace

void render_range(MainWindow& window, const RangeRequest& request) {
  const FrameHistory* history = window.ticker().history();
  if (!history) return window.messages().showInformation("Nothing is open yet");
  auto* rendering = new RangeRendering(history->stretch(request.plan.from_s, request.plan.to_s), &window);
  const QString trouble = rendering->start(request, window.scene());
  if (trouble.isEmpty()) return show_progress(window, *rendering, request.file);
  window.messages().showError(trouble);
  delete rendering;
}

void add_recording_actions(MainWindow& window, RenderDialog& dialog) {
  auto* mark = new QLabel(&window);
  mark->setTextFormat(Qt::RichText);
  mark->hide();
  mark->setAccessibleName("Recording");
  mark->setContentsMargins(8, 0, 12, 0);
  window.statusBar()->addPermanentWidget(mark);
  const Film view = make_film(window, "Record view…", [&window] { return window.scene().grab().toImage(); });
  const Film whole = make_film(window, "Record window…", [&window] { return window.grab().toImage(); });
  view.recording->setObjectName("viewRecording");
  for (const auto& [film, other] : {std::pair(view, whole.action), std::pair(whole, view.action)}) {
    const auto show = [&window, mark, film = film, other = other] {
      show_state(window, film, *mark, *other);
    };
    QObject::connect(film.recording, &ViewRecording::progressed, mark, show);
    QObject::connect(film.recording, &ViewRecording::stopped, mark, show);
  }
  add_action(window, menu_of(window, "File"), "Render range…", {},
             [&window, &dialog] { open_dialog(window, dialog); });
  QObject::connect(&dialog, &RenderDialog::renderRequested, &window, [&window, &dialog] {
    RangeRequest request = dialog.request();
    request.file = ask_file(window, &dialog, "Render as video");
    if (request.file.isEmpty()) return;
    dialog.hide();
    render_range(window, request);
  });
}

}  // namespace abrazo::app

#include "app/workbench/library/retarget_desk.hpp"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <algorithm>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/library/retarget_outcome.hpp"
#include "app/workbench/library/retarget_preview.hpp"
#include "app/workbench/library/retarget_preview_desk.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/library/takes/manifest.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"

namespace abrazo::app {
namespace {

constexpr const char* retarget_job = "retarget";  // of the messages

RetargetOffer offer_of(const MotionLibrary& library) {
  RetargetOffer offer{QString::fromStdString(library.name()) + " (open)", {}, {}};
  for (const LibraryTake& take : library.takes()) {
    const int stride = std::max(1, take.frame_stride);
    offer.takes.push_back(
        {QString::fromStdString(take.name), (take.frames + stride - 1) / stride, take.fps / stride});
  }
  return offer;
}

RetargetOffer offer_of(const Manifest& manifest, const QString& file) {
  RetargetOffer offer{QFileInfo(file).fileName(), file, {}};
  for (const Manifest::Take& take : manifest.takes)
    offer.takes.push_back({QString::fromStdString(take.name), 0, 0});
  return offer;
}

QString sentence_of(const RetargetedTake& take) {
  return QString("%1: %L2 frames, ").arg(QString::fromStdString(take.name)).arg(take.frames) +
         outcome_of(take);
}

}  // namespace

RetargetDesk::RetargetDesk(MainWindow& window)
    : QObject(&window),
      m_window(window),
      m_dialog(new RetargetDialog(&window)),
      m_preview(new RetargetPreviewDesk(m_dialog->preview(), this)) {
  m_dialog->setColours(window.colours());
  m_dialog->installEventFilter(this);
  connect(&window, &MainWindow::coloursChanged, m_dialog, &RetargetDialog::setColours);
  connect(m_dialog, &RetargetDialog::choiceChanged, this, &RetargetDesk::showPreview);
  connect(m_dialog, &RetargetDialog::manifestChosen, this, &RetargetDesk::offerManifest);
  connect(m_dialog, &RetargetDialog::retargetRequested, this, &RetargetDesk::start);
  connect(m_dialog, &RetargetDialog::cancelRequested, this, [this] {
    if (m_job) m_job->cancel();
  });
}

RetargetDesk::~RetargetDesk() = default;

/// Nothing is computed and played for a dialog that nobody sees.
bool RetargetDesk::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show) showPreview();
  if (event->type() == QEvent::Hide) m_preview->showNothing({});
  return QObject::eventFilter(watched, event);
}

TakeSource RetargetDesk::source() const {
  const std::string manifest = m_dialog->manifest().toStdString();
  if (!manifest.empty() || !m_window.session()) return {nullptr, manifest};
  const Material& material = m_window.session()->material();
  return {material.library, material.library_file.empty() ? material.library->name() : material.library_file};
}

void RetargetDesk::showPreview() {
  if (!m_dialog->isVisible()) return;
  auto wish = m_dialog->previewed();
  const TakeSource from = source();
  if (wish && !from.library && from.name.empty()) wish = Error{"nothing is open yet", ""};
  if (wish) return m_preview->show({from, *wish});
  const QString why = words(wish.error());
  m_preview->showNothing(why.left(1).toUpper() + why.mid(1));
}

void RetargetDesk::open() {
  if (const auto* session = m_window.session(); session && !m_job) {
    const MotionLibrary& library = *session->material().library;
    m_dialog->offer(offer_of(library));
    const int selected = library.takes().size() == 1 ? 0 : m_window.takes().selectedTake();
    if (selected >= 0)
      m_dialog->chooseTakes(
          {QString::fromStdString(library.takes()[static_cast<std::size_t>(selected)].name)});
  }
  if (m_dialog->folder().isEmpty()) {
    const QString last = m_window.remembered().lastFolder();
    m_dialog->setFolder(last.isEmpty() ? QDir::homePath() : last);
  }
  m_dialog->show();
  m_dialog->raise();
  m_dialog->activateWindow();
}

void RetargetDesk::run(std::function<std::function<void()>(const Progress&)> work, const QString& doing) {
  m_dialog->showProgress(doing, 0);
  m_job = std::make_unique<Job>(std::move(work));
  connect(m_job.get(), &Job::progressed, m_dialog,
          [this](double fraction, const QString& now) { m_dialog->showProgress(now, fraction); });
  connect(m_job.get(), &Job::finished, this, [this] {
    m_job.release()->deleteLater();  // it is what speaks
  });
}

void RetargetDesk::offerManifest(const QString& file) {
  if (m_job) return;
  run(
      [this, file](const Progress&) -> Job::Finish {
        const auto manifest = read_manifest(file.toStdString());
        if (!manifest) return [this, error = manifest.error()] { m_dialog->endProgress(words(error)); };
        return [this, offer = offer_of(*manifest, file)] {
          m_dialog->endProgress({});
          m_dialog->offer(offer);
        };
      },
      "Reading " + QFileInfo(file).fileName());
}

void RetargetDesk::start() {
  if (m_job) return;
  const auto wish = m_dialog->wish();
  if (!wish) return fail(wish.error());
  const TakeSource source = this->source();
  if (!source.library && source.name.empty()) return;
  m_window.remembered().setLastFolder(m_dialog->folder());
  run(
      [this, wish = *wish, source](const Progress& progress) -> Job::Finish {
        std::vector<std::string> warnings;
        const auto takes = read_takes(source, wish.takes, warnings, part(progress, 0, 0.1));
        if (!takes) return [this, error = takes.error()] { fail(error); };
        auto done = retarget_takes(*takes, wish, source.name, part(progress, 0.1, 1));
        if (!done) return [this, error = done.error()] { fail(error); };
        return [this, made = std::move(*done), warnings] { tell(made, warnings); };
      },
      "Reading the takes");
}

void RetargetDesk::fail(const Error& error) {
  if (m_job && m_job->wasCancelled()) return m_dialog->endProgress("Cancelled; nothing was written");
  m_dialog->endProgress(words(error));
  m_window.messages().showErrorOf(retarget_job, words(error));
}

void RetargetDesk::tell(const std::vector<RetargetedTake>& done, const std::vector<std::string>& warnings) {
  QStringList sentences;
  for (const RetargetedTake& take : done) sentences << sentence_of(take);
  m_dialog->endProgress(sentences.size() == 1
                            ? "Done. " + sentences.front()
                            : QString("Done: %1 takes; the messages have their figures").arg(done.size()));
  m_window.messages().succeed(retarget_job, "Retargeted " + sentences.join(" · "));
  QStringList told;
  for (const std::string& warning : warnings) told << QString::fromStdString(warning);
  if (!told.isEmpty()) m_window.messages().showWarnings(told);
}

}  // namespace abrazo::app

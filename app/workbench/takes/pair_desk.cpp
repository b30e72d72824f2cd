#include "app/workbench/takes/pair_desk.hpp"

#include <algorithm>
#include <set>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job_progress.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/takes/pair_dialog.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/annotation/session_labels.hpp"
#include "core/library/build/library_extension.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/session/edit/take_name.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::app {
namespace {

using widgets::text;

std::vector<std::string> names_of(const MotionLibrary& library) {
  std::vector<std::string> names;
  for (const LibraryTake& take : library.takes()) names.push_back(take.name);
  return names;
}

QStringList labels_of(const MotionLibrary& library) {
  std::set<std::string> labels;
  for (const LibraryTake& take : library.takes())
    for (const LabelInterval& label : take.labels) labels.insert(label.label);
  QStringList words;
  for (const std::string& label : labels) words << text(label);
  return words;
}

}  // namespace

PairDesk::PairDesk(MainWindow& window, TakeDesk& takes,
                   std::function<std::pair<QString, QString>()> performers)
    : QObject(&window), m_window(window), m_takes(takes), m_performers(std::move(performers)) {
  connect(&takes, &TakeDesk::begun, this, &PairDesk::listen);
  connect(&takes, &TakeDesk::taken, this, [this] {
    if (m_capture && !m_dialog) ask();
  });
  connect(&takes, &TakeDesk::cameToNothing, this, [this] {
    if (m_dialog) return;
    stopListening();
    m_capture.reset();
  });
  connect(&window.document(), &Document::ending, this, [this] {
    stopListening();
    if (m_dialog) m_dialog->close();  // the library that it would be added to goes
    m_capture.reset();
    Job::retire(std::move(m_job), this);
  });
}

PairDesk::~PairDesk() {
  stopListening();
}

void PairDesk::toggle() {
  if (m_dialog) return m_dialog->raise();  // one pair after the other
  if (m_capture || m_takes.isRecording()) return m_takes.toggle();
  begin();
}

void PairDesk::begin() {
  const auto receiver = m_window.session() ? m_window.session()->engine().receiver() : nullptr;
  const auto performers = receiver ? receiver->performers() : std::vector<std::string>();
  if (performers.size() < 2)
    return m_window.messages().showInformation(
        "A pair needs two performers in the stream; connect to one that has them (Live > Connect to a "
        "stream…)");
  const auto [user, second] = m_performers();
  const std::string a = user.isEmpty() ? performers.front() : user.toStdString();
  std::string b = second.toStdString();
  if (b.empty() || b == a)
    b = *std::find_if(performers.begin(), performers.end(), [&](const auto& other) { return other != a; });
  m_capture = std::make_shared<PairCapture>(a, b);
  m_receiver = receiver;
  m_takes.toggle();
}

/// From the beginning of the take on; what comes in during the countdown is not of it.
void PairDesk::listen() {
  const auto receiver = m_receiver.lock();
  if (!receiver || !m_capture || m_dialog || m_listener) return;
  m_listener = receiver->listen([to = m_capture](const ReceivedPose& pose) { to->add(pose); });
  m_window.messages().showInformation("Recording " + text(m_capture->a()) + " and " + text(m_capture->b()) +
                                      " as a pair; Ctrl+R ends it");
}

void PairDesk::stopListening() {
  if (const auto receiver = m_receiver.lock(); receiver && m_listener) receiver->unlisten(*m_listener);
  m_listener.reset();
  m_receiver.reset();
}

void PairDesk::ask() {
  stopListening();
  const MotionLibrary& library = *m_window.session()->material().library;
  const std::string recorded = m_takes.takes().empty() ? "pair" : m_takes.takes().all().back().name;
  const std::string name = next_take_name(recorded, names_of(library));
  m_dialog = new PairDialog(*m_capture, text(name), labels_of(library), &m_window);
  m_dialog->setAttribute(Qt::WA_DeleteOnClose);
  // The first is the user.
  const bool follows = m_window.document().settings().user_role == UserRole::Passive;
  m_dialog->setLeader(follows ? ActivePerformer::B : ActivePerformer::A);
  connect(m_dialog, &PairDialog::addRequested, this, [this] { add(*m_dialog); });
  connect(m_dialog, &QDialog::finished, this, [this] { m_capture.reset(); });
  m_dialog->show();
}

void PairDesk::add(PairDialog& dialog) {
  const PairCapture::Wishes wishes = dialog.wishes();
  if (wishes.name.empty()) return dialog.showTrouble("A take needs a name");
  if (m_window.session()->material().library->find_take(wishes.name) >= 0)
    return dialog.showTrouble("The library has a take " + text(wishes.name) + " already; give another name");
  const auto take = m_capture->take(wishes);
  if (!take) return dialog.showTrouble(words(take.error()));
  dialog.accept();
  if (m_takes.takes().empty()) return extend(*take);
  const double began_s = m_takes.takes().all().back().from_s + wishes.in_s;
  extend(with_session_labels(*take, m_window.document().live().annotations().of(""), began_s));
}

void PairDesk::extend(const PairedTake& take) {
  if (!m_window.session()) return;
  Material material = m_window.session()->material();
  const Settings settings = m_window.document().settings();
  auto& messages = m_window.messages();
  Job::retire(std::move(m_job), this);
  messages.showProgress("Adding " + text(take.name), 0);
  m_job = std::make_unique<Job>([this, take, material, settings](const Progress& progress) -> Job::Finish {
    auto longer = extend_library(*material.library, take, {}, progress);
    if (!longer) return [this, why = longer.error().text()] { m_window.messages().showError(text(why)); };
    Material next = material;
    next.library = std::make_shared<const MotionLibrary>(std::move(longer).value());
    if (next.unannotated) {  // which goes on when the annotations are discarded
      auto without = extend_library(*next.unannotated, take, {}, progress);
      if (!without) return [this, why = without.error().text()] { m_window.messages().showError(text(why)); };
      next.unannotated = std::make_shared<const MotionLibrary>(std::move(without).value());
    }
    next.library_file.clear();  // what lies there has not this take
    next.manifest.reset();
    next.is_generated = next.stands_in = false;
    auto prepared = prepare_solver(std::move(next), settings);
    if (!prepared) return [this, why = prepared.error().text()] { m_window.messages().showError(text(why)); };
    auto ready = std::make_shared<PreparedSolver>(std::move(prepared).value());
    return [this, ready, take, base = material.library] {
      // The result lacks annotations made of other takes meanwhile.
      if (m_window.session()->material().library != base) return extend(take);
      m_window.document().replaceSolver(std::move(*ready));
      const LibraryTake& added = m_window.session()->material().library->takes().back();
      m_window.messages().showInformation(
          QString("%1 was added to the library: %2 frames. Library > Save library… writes it to a file")
              .arg(text(added.name))
              .arg(added.frames));
      emit extended(text(take.name));
    };
  });
  show_progress(*m_job, messages);
}

void PairDesk::save(const QString& file) {
  if (!m_window.session()) return;
  const auto library = m_window.session()->material().library;
  const Status written = write_library(*library, file.toStdString());
  if (!written) return m_window.messages().showError(words(written.error()));
  m_window.session()->setLibraryFile(library, file.toStdString());
  m_window.messages().showInformation("Library written to " + file);
}

}  // namespace abrazo::app

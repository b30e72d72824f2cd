#include "app/workbench/shell/document_views.hpp"

#include <cstdint>
#include <memory>
#include <utility>

#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/shell/status_figures.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::CandidateTable;
using widgets::SettingsPanel;
using widgets::TimelineView;

void show_part(MainWindow& window, ProjectPart part) {
  const Document& document = window.document();
  window.transport().showPins(document.decisions().pinned.has_value(), document.triesOther());
  if (part == ProjectPart::Settings)
    window.settings().showSettings(document.settings(), document.live().preset());
  if (part == ProjectPart::Decisions) {
    window.candidates().showDecisions(document.shownDecisions());
    window.takes().setVetoedTakes(document.decisions().vetoes.takes);
  }
  if (part == ProjectPart::Markers) window.timeline().showMarkers(document.markers());
}

/// Pairs and takes that were there may have other numbers, roles and labels.
void show_library(MainWindow& window, const std::shared_ptr<const MotionLibrary>& library) {
  window.ticker().setLibrary(library);
  window.scene().extendLibrary(library);
  window.candidates().setLibrary(library);
  window.timeline().extendLibrary(library);
  const int take = window.takes().selectedTake();
  window.takes().setLibrary(library);
  if (take >= 0) window.takes().setSelectedTake(take);
  window.status().setLibrary(library->pair_count());
}

void show_session(MainWindow& window) {
  const Material& material = window.session()->material();
  const QString library = QString::fromStdString(material.library->name());
  const QString input = QString::fromStdString(material.input.name);
  // Nobody would look for bodies that were hidden in the session before; the file may hide its own.
  window.scene().setMemory(without_session(window.scene().memory()));
  window.scene().showHidden();
  window.scene().setLibrary(material.library);
  window.candidates().setLibrary(material.library);
  window.timeline().setLibrary(material.library);
  window.takes().setLibrary(material.library);
  const bool is_named = library.compare("library", Qt::CaseInsensitive) != 0;
  window.panels().setHead("library", is_named ? "Library · " + library : "Library");
  const auto from = material.input_plays() ? widgets::UserInput::Clip : widgets::UserInput::None;
  window.transport().setInput(title_of_input(material));
  window.transport().showUserInput(from);
  window.status().setInput({name_of_input(material), from, material.input.fps},
                           material.library->pair_count());
  window.setWindowTitle(input + " with " + library + " — Abrazo");
  window.ticker().setLibrary(material.library);
  show_frames_of_session(window);
  QStringList warnings;
  for (const std::string& warning : material.warnings) warnings << QString::fromStdString(warning);
  window.messages().succeed("open", "Opened " + input + " with " + library, true);  // the title shows it
  window.messages().showWarnings(warnings);
}

/// A recorded session is looked at from its beginning, or at the live end if a clip continues it.
void show_contents(MainWindow& window) {
  const Material& material = window.session()->material();
  if (!material.recorded) return;
  window.ticker().tick();
  if (!material.input_plays()) window.ticker().goToStart();
}

void show_playback(MainWindow& window, const Playback& playback) {
  LiveSession* session = window.session();
  const FrameSnapshotPtr& shown = window.ticker().shown();
  const bool is_of_clip = session && session->isClip();
  if (is_of_clip) session->engine().look_at(playback.cursor_s);
  const auto number = [&] { return is_of_clip ? shown->input_frame : static_cast<long long>(shown->index); };
  window.transport().showHeld(session && session->engine().is_held());
  window.transport().showPlayback(playback, shown ? number() : -1);
}

/// The frames of a clip that was solved again took the places of those that lanes and curves have read.
/// @param run  of the solution that they show
void show_solved_again(MainWindow& window, std::uint64_t& run) {
  if (!window.session() || window.session()->looksElsewhere()) return;
  const auto clip = window.session()->engine().clip_progress();
  if (!clip || !clip->is_whole() || clip->run == std::exchange(run, clip->run) || clip->run == 1) return;
  window.plots().clear();
  window.timeline().showOtherFrames();
  window.takes().showOtherFrames();
}

}  // namespace

void show_frames_of_session(MainWindow& window) {
  const LiveSession& session = *window.session();
  window.ticker().setSources(&session.history(), &session.latest());
  const auto clip = session.material().is_clip() ? window.session()->engine().clip_progress() : std::nullopt;
  if (clip) window.ticker().setEnd(clip->last_s);
  window.transport().setFrames(clip ? static_cast<long long>(session.material().input.poses.size()) : 0);
}

void show_document(MainWindow& window) {
  Document& document = window.document();
  const auto connect = [&document](auto& view, auto asked, auto answer) {
    QObject::connect(&view, asked, &document, answer);
  };
  connect(window.settings(), &SettingsPanel::entryRequested, &Document::changeSetting);
  connect(window.settings(), &SettingsPanel::presetRequested, &Document::choosePreset);
  connect(window.settings(), &SettingsPanel::settingsRequested, &Document::adopt);
  connect(window.candidates(), &CandidateTable::decisionsRequested,
          [&window](const Decisions& next, const QString& what) {
            const Playback& playback = window.ticker().playback();
            const bool is_parked = playback.is_live && playback.state == Playback::State::Parked;
            window.document().decide(next, what, is_parked && window.document().subject().empty());
          });
  QObject::connect(&document, &Document::triedChanged, &window,
                   [&window] { show_part(window, ProjectPart::Decisions); });
  const auto run = std::make_shared<std::uint64_t>(0);
  QObject::connect(&document, &Document::began, &window, [&window, run] {
    *run = 0;
    show_session(window);
  });
  QObject::connect(&window.ticker(), &FrameTicker::panelsDue, &window,
                   [&window, run] { show_solved_again(window, *run); });
  QObject::connect(&window.ticker(), &FrameTicker::playbackChanged, &window,
                   [&window](const Playback& playback) { show_playback(window, playback); });
  QObject::connect(&document, &Document::opened, &window, [&window] { show_contents(window); });
  connect(window.timeline(), &TimelineView::markersRequested, &Document::changeMarkers);
  QObject::connect(&document, &Document::changed, &window, [&window](ProjectPart part) {
    show_part(window, part);
    if (part == ProjectPart::Settings) window.messages().withdrawErrorsOf("setting");
  });
  QObject::connect(&document, &Document::refused, &window, [&window](const QString& why) {
    show_part(window, ProjectPart::Settings);  // restores the field
    window.messages().showErrorOf("setting", why);
  });
  QObject::connect(&document, &Document::libraryReplaced, &window,
                   [&window](const auto&, const auto& library) { show_library(window, library); });
}

}  // namespace abrazo::app

#include "app/workbench/document/document.hpp"

#include <QUndoCommand>
#include <array>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "core/bodies/chosen_body.hpp"
#include "core/opening/opened_session.hpp"
#include "core/session/frames/decision_edits.hpp"

namespace abrazo::app {
namespace {

QString title_of(const std::string& key) {
  const SettingInfo* info = find_setting(key);
  return info ? QString::fromUtf8(info->title.data(), static_cast<int>(info->title.size())) : QString();
}

std::array<BodyChoice*, 2> bodies_of(Settings& settings) {
  return {&settings.active_body, &settings.passive_body};
}

bool is_unmeasured(const BodyChoice& body) {
  return body.kind == BodyChoice::Kind::OfFile && !body.measured;
}

}  // namespace

/// The only undo command for parts of the document; the rules are ProjectEdit's.
class DocumentStep : public QUndoCommand {
 public:
  DocumentStep(Document& document, ProjectEdit edit)
      : QUndoCommand(QString::fromStdString(edit.what)), m_document(document), m_edit(std::move(edit)) {}

  void redo() override { setObsolete(!m_document.apply(m_edit, m_edit.after)); }
  void undo() override { setObsolete(!m_document.apply(m_edit, m_edit.before)); }
  int id() const override { return m_edit.gesture > 0 ? 1 : -1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const DocumentStep*>(other);
    if (next == nullptr || !m_edit.absorb(next->m_edit)) return false;
    setText(next->text());
    setObsolete(m_edit.is_nothing());
    return true;
  }

 private:
  Document& m_document;
  ProjectEdit m_edit;
};

Document::Document(QObject* parent) : QObject(parent) {}
Document::~Document() = default;

void Document::change(const ProjectValue& next, const QString& what, const QString& key, int gesture) {
  auto edit = m_live.edit(next, what.toStdString());
  if (!edit) {  // of another preset's name, perhaps: nothing that a step of undo would show
    if (std::holds_alternative<ChosenSettings>(next)) put(next);
    return;
  }
  edit->key = key.toStdString();
  edit->gesture = gesture;
  m_undo.push(new DocumentStep(*this, std::move(*edit)));
}

bool Document::apply(const ProjectEdit& edit, const ProjectValue& value) {
  if (!m_live.is_valid(edit)) return false;
  put(value);
  if (const auto* said = std::get_if<SubjectAnnotations>(&value))
    emit annotated(said->subject, QString::fromStdString(edit.what));
  return true;
}

void Document::take(const Result<ChosenSettings>& next, const QString& what, const QString& key,
                    int gesture) {
  next ? change(*next, what, key, gesture) : emit refused(words(next.error()));
}

void Document::changeSetting(const QString& key, const QString& text, int gesture) {
  if (const auto before = m_measuring.find(key); before != m_measuring.end())
    Job::retire(std::move(before->second), this);
  auto next = m_live.with_setting(key.toStdString(), text.toStdString());
  if (next)
    for (const BodyChoice* body : bodies_of(next->settings))
      if (is_unmeasured(*body)) return measure(*body, key, text, gesture);
  takeSetting(std::move(next), key, gesture);
}

void Document::measure(const BodyChoice& body, const QString& key, const QString& text, int gesture) {
  m_measuring[key] = std::make_unique<Job>(
      [this, body, key, text, gesture](const Progress& progress) -> Job::Finish {
        BodyChoice found = body;
        const Status measured = measure_file(found, progress);
        return [this, measured, found, key, text, gesture] {
          auto next = m_live.with_setting(key.toStdString(), text.toStdString());  // others may be new
          if (next)
            for (BodyChoice* one : bodies_of(next->settings))
              if (is_unmeasured(*one) && one->file == found.file) one->measured = found.measured;
          if (!measured) next = measured.error();
          takeSetting(std::move(next), key, gesture);
        };
      },
      this);
}

void Document::takeSetting(Result<ChosenSettings> next, const QString& key, int gesture) {
  const std::string name = key.toStdString();
  // The window has no option of the command line, where the setting is "--alpha".
  if (!next && next.error().where == "--" + name)
    next = Error{next.error().message, title_of(name).toStdString(), next.error().hint};
  const QString what =
      next ? title_of(name) + " to " + QString::fromStdString(setting_text(next->settings, name)) : QString();
  take(next, what, key, gesture);
}

void Document::choosePreset(const QString& name, bool own) {
  take(m_live.with_preset(name.toStdString(), own), "preset " + name, {}, 0);
}

void Document::adopt(const Settings& settings, const QString& what) {
  change(m_live.with_settings(settings), what);
  useTriedSettings();
}

void Document::changeMarkers(const Markers& next, const QString& what) {
  if (m_session) change(SubjectMarkers{m_subject, next}, what);
}

void Document::changeAnnotations(const Annotations& next, const QString& what) {
  if (m_session) change(SubjectAnnotations{m_subject, next}, what);
}

bool Document::edit(const Result<LabelEdit>& edit) {
  if (!edit) {
    emit labelRefused(words(edit.error()));
    return false;
  }
  changeAnnotations(edit->next, QString::fromStdString(edit->what));
  if (edit->tier) chooseTier(*edit->tier);
  if (edit->selected) selectLabel(*edit->selected);
  return true;
}

void Document::chooseTier(int tier) {
  if (m_labels.choose_tier(annotations(), tier)) emit labelChosen();
}

void Document::selectLabel(int annotation) {
  if (m_labels.select(annotations(), annotation)) emit labelChosen();
}

void Document::setConflict(Conflict conflict) {
  m_labels.set_conflict(conflict);
  emit labelChosen();
}

bool Document::controlRole(RoleControl by) {
  const Status possible = m_session ? m_session->engine().control_role(by) : Status(Done{});
  possible ? put(by) : emit refused(words(possible.error()));
  return possible.ok();
}

void Document::tryPin(std::optional<int> pair) {
  if (pair == m_triedPin) return;
  m_triedPin = pair;
  emit triedChanged();
}

bool Document::triesOther() const {
  return m_triedPin || (m_kept && *m_kept != settings());
}

void Document::holdSettings() {
  if (m_session) m_session->holdSettings(m_isAside || m_kept);
}

void Document::setAside(bool on) {
  m_isAside = on;
  holdSettings();
}

void Document::setTries(bool on) {
  if (on == m_kept.has_value()) return;
  const bool takes_back = !on && *m_kept != settings();
  if (takes_back) change(m_live.with_settings(*m_kept), "back to the settings of the live partner");
  m_kept = on ? std::optional(settings()) : std::nullopt;
  holdSettings();
  if (takes_back) emit triedTakenBack();
  emit triedChanged();
}

void Document::useTriedSettings() {
  if (!m_kept || *m_kept == settings()) return;
  m_kept.reset();
  holdSettings();  // lets them go
  m_kept = settings();
  holdSettings();
  emit triedChanged();
}

void Document::useTriedPin() {
  if (!m_triedPin) return;
  const Decisions next = shownDecisions();
  tryPin({});
  change(next, "pin the live partner");
}

Decisions Document::shownDecisions() const {
  Decisions shown = decisions();
  if (m_triedPin) shown.pinned = m_triedPin;
  return shown;
}

void Document::decide(const Decisions& next, const QString& what, bool is_parked) {
  const bool is_other_pin = next.pinned && next.pinned != shownDecisions().pinned;
  if (is_parked && is_other_pin) return tryPin(next.pinned);
  Decisions live = next;
  if (m_triedPin && !is_neutral(next)) live.pinned = decisions().pinned;
  if (!next.pinned) tryPin({});
  change(live, what);
}

void Document::openSession(PreparedSolver prepared) {
  beginSession(std::move(prepared));
  emit began();
  emit annotationsReplaced();
  const Material& material = m_session->material();
  if (material.recorded) openRecording(*material.recorded);
  if (material.project) openProject(*material.project);
  emit opened();
}

void Document::endSession() {
  if (!m_session) return;
  m_session->engine().stop_receiving();  // the next session may want the same port
  // Shared only because std::function must be copyable.
  auto ending = std::make_shared<std::unique_ptr<LiveSession>>(std::move(m_session));
  Job::retire(std::make_unique<Job>([ending](const Progress&) -> Job::Finish {
                ending->reset();
                return {};
              }),
              this);
}

void Document::beginSession(PreparedSolver prepared) {
  const auto before = m_session ? m_session->material().library : nullptr;
  const bool same_library =
      m_session && m_session->material().library_of_files() == prepared.material.library_of_files();
  tryPin({});
  m_kept.reset();
  m_isAside = false;
  m_undo.clear();  // its steps are of the session that ends
  endSession();
  m_session = std::make_unique<LiveSession>(std::move(prepared));
  m_subject.clear();
  const Material& material = m_session->material();
  auto changed = m_live.begin_session(*material.library_of_files(), same_library);
  if (same_library && before != material.library)  // its pairs may have other numbers without annotations
    for (const ProjectPart part : m_live.replace_library(*before, *material.library)) changed.push_back(part);
  m_labels.begin(annotations());
  tellSolver(ProjectPart::Settings);  // they may have changed while it was prepared
  tellSolver(ProjectPart::Decisions);
  announce(changed);
}

void Document::openRecording(const RecordedSession& recorded) {
  put(SubjectMarkers{"", recorded.markers()});
  if (!recorded.contents.settings.empty()) putSettings(recorded.contents.settings.back().settings);
}

/// A file that was never saved as a project has annotations at most.
void Document::openProject(const OpenedProject& opened) {
  const Project& saved = opened.project();
  if (!opened.reading.is_saved) {
    if (!saved.annotations.empty()) openAnnotations(opened);
    return;
  }
  announce(m_live.open(saved));
  controlRole(saved.decisions.role_control);
  openAnnotations(opened);
  QStringList videos;
  for (const std::string& place : opened.video_places()) videos << QString::fromStdString(place);
  emit videosOpened(saved.videos, videos);
}

void Document::openAnnotations(const OpenedProject& opened) {
  const bool is_saved = opened.autosave.empty();
  announce(m_live.open_annotations(opened.project().annotations, *m_session->material().library_of_files(),
                                   is_saved));
  emit annotationsReplaced();
}

void Document::replaceSolver(PreparedSolver prepared) {
  tryPin({});  // pairs may have other numbers
  const auto before = m_session->material().library, after = prepared.material.library;
  m_session->replaceSolver(std::move(prepared));
  const auto parts = m_live.replace_library(*before, *after);
  emit libraryReplaced(before, after);
  // The solver carries its decisions over itself: told again, it would solve a held pose again.
  for (const ProjectPart part : parts) emit changed(part);
}

void Document::setSubject(const std::string& subject) {
  if (subject == m_subject) return;
  tryPin({});
  m_subject = subject;
  if (m_session) m_live.begin_annotations(subject, *m_session->material().library_of_files());
  m_labels.begin(annotations());
  emit subjectChanged();
  emit changed(ProjectPart::Markers);
  emit annotationsReplaced();
}

void Document::announce(const LiveProject::Parts& parts) {
  for (const ProjectPart part : parts) {
    if (part == ProjectPart::Annotations) m_labels.settle(annotations());
    tellSolver(part);
    emit changed(part);
  }
}

void Document::tellSolver(ProjectPart part) {
  if (!m_session) return;
  if (part == ProjectPart::Settings) m_session->push(SetSettings{settings()});
  if (part != ProjectPart::Decisions) return;
  m_session->push(PinPair{decisions().pinned});
  m_session->push(SetVetoes{decisions().vetoes});
  m_session->push(IntendMove{decisions().meant});
}

}  // namespace abrazo::app

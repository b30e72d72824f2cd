#include "app/workbench/library/import_desk.hpp"

#include <algorithm>
#include <utility>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/library/import_rules_dialog.hpp"
#include "app/workbench/library/mapping_dialog.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/opening/import_rules.hpp"
#include "core/opening/take_reading.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"

namespace abrazo::app {
namespace {

/// The motion and its skeleton among the files, with a joint map that is named there.
MotionReading motion_among(const QStringList& files, const MotionReading& said) {
  MotionReading reading = said;
  for (const QString& file : files) {
    const std::string name = file.toStdString();
    const FileKind kind = kind_of_file(name);
    if (kind == FileKind::Motion) reading.file = name;
    if (kind == FileKind::Skeleton) reading.skeleton = name;
    if (kind == FileKind::JointMap) reading.joint_map = name;
  }
  return reading;
}

/// The library of a manifest with one take that is read in another way.
Result<Material> built_with(Manifest manifest, const Manifest::Take& take, const Progress& progress) {
  for (Manifest::Take& each : manifest.takes)
    if (each.name == take.name) each = take;
  std::vector<std::string> warnings;
  auto library = build_library(manifest, {}, progress, warnings);
  if (!library) return library.error();
  return built_material(std::make_shared<const MotionLibrary>(std::move(*library)), std::move(manifest), "",
                        std::move(warnings));
}

}  // namespace

ImportDesk::ImportDesk(MainWindow& window) : QObject(&window), m_window(window) {
  connect(&window, &MainWindow::importOffered, this, [this](const QStringList& files) { offer(files); });
  connect(&window.takes(), &widgets::TakeList::readingRequested, this, &ImportDesk::offerTake);
  connect(&window, &MainWindow::coloursChanged, this, [this](const widgets::Palette& palette) {
    if (m_panel) m_panel->setColours(palette);
  });
}

ImportDesk::~ImportDesk() = default;

void ImportDesk::offer(const QStringList& files, const std::optional<MotionReading>& said) {
  const MotionReading reading = motion_among(files, said.value_or(MotionReading{}));
  if (reading.file.empty())
    return m_window.messages().showError("None of these files is a motion: " + files.join(", "));
  show(reading, !said, [this, files](const ImportView& view) { open(files, view.reading); });
}

void ImportDesk::offerTake(int take, bool second) {
  if (!m_window.session()) return;
  const Material& material = m_window.session()->material();
  const std::string name = material.library->takes()[static_cast<std::size_t>(take)].name;
  const Result<Manifest> manifest = manifest_behind(material);
  if (!manifest) return m_window.messages().showInformation(words(manifest.error()));
  const auto found = std::find_if(manifest->takes.begin(), manifest->takes.end(),
                                  [&name](const Manifest::Take& each) { return each.name == name; });
  if (found == manifest->takes.end())
    return m_window.messages().showInformation("The manifest of the library has no take " +
                                               QString::fromStdString(name));
  const Performer performer = second ? Performer::B : Performer::A;
  const MotionReading before = reading_of(*found, performer);
  show(before, false, [this, manifest = *manifest, before, performer, was = *found](const ImportView& view) {
    if (view.reading == before) return;
    auto changed = with_reading(was, performer, view.reading, static_cast<int>(view.performer));
    if (!changed) return m_window.messages().showError(words(changed.error()));
    m_window.openMaterial([manifest, changed = *changed](const Progress& progress) {
      return built_with(manifest, changed, progress);
    });
  });
}

void ImportDesk::show(const MotionReading& reading, bool by_rule,
                      std::function<void(const ImportView&)> accepted) {
  delete m_panel;
  m_accepted = std::move(accepted);
  m_preview = std::make_shared<ImportPreview>();
  m_panel = new ImportPanel(reading, &m_window);
  m_panel->setAttribute(Qt::WA_DeleteOnClose);
  m_panel->setColours(m_window.colours());
  m_panel->setRemembers(m_window.remembered().remembersImports());
  connect(m_panel, &ImportPanel::viewRequested, this,
          [this](const MotionReading& wanted) { look({wanted}); });
  connect(m_panel, &ImportPanel::jointsRequested, this, &ImportDesk::assignJoints);
  connect(m_panel, &ImportPanel::rulesRequested, this, &ImportDesk::showRules);
  connect(m_panel, &QDialog::accepted, this, &ImportDesk::accept);
  m_panel->open();
  look({reading, by_rule, true});
}

bool ImportDesk::offerOpenOne() {
  if (!m_window.session()) return false;
  const Material& material = m_window.session()->material();
  if (material.reading.file.empty()) return false;
  QStringList files;
  for (const std::string& file : material.input_files()) files << QString::fromStdString(file);
  offer(files, material.reading);
  return true;
}

void ImportDesk::look(const Look& next) {
  m_next = next;
  if (!m_job) lookNext();
}

/// One view at a time; of several that were requested meanwhile only the last is of use.
void ImportDesk::lookNext() {
  if (!m_next || !m_panel) return;
  const std::string folder = m_window.remembered().importRuleFolder().toStdString();
  auto work = [this, next = *std::exchange(m_next, std::nullopt), folder, preview = m_preview,
               panel = m_panel](const Progress& progress) -> Job::Finish {
    const MotionReading& reading = next.reading;
    auto view = std::make_shared<ImportView>(preview->look(reading, progress));
    bool has_rule = false;
    if (next.is_first) {
      const StoredRules stored = import_rules(folder);
      const ImportRule* rule = rule_for(stored.rules, reading.file, view->layout);
      has_rule = rule != nullptr;
      if (rule && next.by_rule) {
        MotionReading ruled = rule->how;
        ruled.file = reading.file, ruled.skeleton = reading.skeleton;
        *view = preview->look(ruled, progress);
      }
    }
    return [this, view, has_rule, panel] {
      if (!panel || panel != m_panel) return;
      if (has_rule) panel->setRemembers(true);  // it would be forgotten otherwise
      if (!m_next) panel->show(*view);
    };
  };
  m_job = std::make_unique<Job>(std::move(work));
  connect(m_job.get(), &Job::finished, this, [this] {
    Job::retire(std::move(m_job), this);
    lookNext();
  });
}

void ImportDesk::assignJoints(const UnmappedMotion& motion) {
  if (!motion) return;
  delete m_mapping;
  m_mapping = new MappingDialog(*motion, m_panel);
  m_mapping->setAttribute(Qt::WA_DeleteOnClose);
  m_mapping->setColours(m_window.colours());
  connect(m_mapping, &QDialog::accepted, this, [this] {
    const auto map = m_mapping->keep(m_window.remembered().jointMapFolder());
    if (!map) return m_window.messages().showError(words(map.error()));
    if (m_panel) m_panel->chooseJoints(QString::fromStdString(*map));
  });
  m_mapping->open();
}

/// A rule takes the place of one for the same files; without one they are asked about again.
bool ImportDesk::remember(const MotionReading& reading) {
  const std::string folder = m_window.remembered().importRuleFolder().toStdString();
  const ImportRule rule = rule_of(reading, m_panel->view().layout);
  if (m_panel->remembers()) {
    const auto stored = remember_import(rule, folder);
    if (!stored) m_window.messages().showError(words(stored.error()));
    return stored.ok();
  }
  for (const ImportRule& known : import_rules(folder).rules)
    if (known.layout == rule.layout && known.folder == rule.folder)
      if (const Status gone = forget_import(known.path); !gone) {
        m_window.messages().showError(words(gone.error()));
        return false;
      }
  return true;
}

void ImportDesk::accept() {
  const ImportView view = m_panel->view();
  m_window.remembered().setRemembersImports(m_panel->remembers());
  if (remember(view.reading)) m_accepted(view);
}

void ImportDesk::open(const QStringList& files, const MotionReading& reading) {
  // The joint map of the reading is the one that counts, also where another was among the files.
  QStringList without_map;
  for (const QString& file : files)
    if (kind_of_file(file.toStdString()) != FileKind::JointMap) without_map << file;
  m_window.openFiles(without_map, reading);
}

void ImportDesk::showRules() {
  auto* dialog = new ImportRulesDialog(m_window.remembered().importRuleFolder(),
                                       m_panel ? static_cast<QWidget*>(m_panel.data()) : &m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

}  // namespace abrazo::app

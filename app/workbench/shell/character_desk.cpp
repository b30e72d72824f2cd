#include "app/workbench/shell/character_desk.hpp"

#include <utility>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/base/user_settings.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/motion/scenes/read_worn_character.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/panel/character_rows.hpp"
#include "widgets/scene/panel/scene_tree.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {

using widgets::CharacterRows;
using widgets::SceneView;

CharacterDesk::CharacterDesk(MainWindow& window) : QObject(&window), m_window(window) {
  CharacterRows& rows = window.sceneTree().characters();
  connect(&rows, &CharacterRows::characterRequested, this, &CharacterDesk::choose);
  connect(&rows, &CharacterRows::capsulesRequested, this, [this](int body) { wear(body, {}); });
  connect(&window.scene(), &SceneView::optionsChanged, this,
          [this](const widgets::SceneOptions& options) { follow(options.character_files); });
  follow(window.scene().options().character_files);
}

void CharacterDesk::choose(int body) {
  const QString file = ask_file(&m_window, m_window.remembered(),
                                body == 0 ? "A character for the leader" : "A character for the follower",
                                "Characters (*.glb *.vrm);;All files (*)");
  if (!file.isEmpty()) wear(body, file.toStdString());
}

void CharacterDesk::wear(int body, const std::string& file) {
  widgets::SceneOptions options = m_window.scene().options();
  options.character_files[static_cast<std::size_t>(body)] = file;
  m_window.scene().setOptions(options);
}

void CharacterDesk::follow(const std::array<std::string, 2>& files) {
  const std::array<std::string, 2> before = std::exchange(m_files, files);
  if (before == files) return;
  m_window.sceneTree().characters().setFiles(files);
  for (std::size_t body = 0; body < 2; ++body)
    if (before[body] != files[body]) read(body);
}

void CharacterDesk::read(std::size_t body) {
  Job::retire(std::move(m_jobs[body]), this);
  if (m_files[body].empty()) return show(body, std::shared_ptr<const WornCharacter>());
  if (const auto& other = m_window.scene().characters()[1 - body]; other && other->file == m_files[body])
    return show(body, other);
  m_jobs[body] = std::make_unique<Job>([this, body, file = m_files[body]](const Progress&) -> Job::Finish {
    auto character =
        std::make_shared<Result<std::shared_ptr<const WornCharacter>>>(read_worn_character(file));
    return [this, body, character] { show(body, std::move(*character)); };
  });
}

void CharacterDesk::show(std::size_t body, Result<std::shared_ptr<const WornCharacter>> read) {
  widgets::WornPair characters = m_window.scene().characters();
  characters[body] = read ? std::move(*read) : nullptr;
  m_window.scene().setCharacters(characters);
  if (read) return;
  m_window.messages().showErrorOf("character", words(read.error()));
  wear(static_cast<int>(body), {});
}

}  // namespace abrazo::app

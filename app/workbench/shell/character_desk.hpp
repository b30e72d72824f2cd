#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <string>

#include "app/workbench/base/job.hpp"
#include "widgets/scene/values/worn_pair.hpp"

namespace abrazo::app {

class MainWindow;

/// Reads the character files that the scene's options name, beside the window, and shows them; says which
/// file cannot be shown and why, and gives its body the capsules again.
class CharacterDesk : public QObject {
  Q_OBJECT
 public:
  explicit CharacterDesk(MainWindow& window);
  /// Asks for a file for a body. @param body  0 = active, 1 = passive
  void choose(int body);
  /// An empty file takes the character off.
  void wear(int body, const std::string& file);

 private:
  void follow(const std::array<std::string, 2>& files);
  void read(std::size_t body);
  void show(std::size_t body, Result<std::shared_ptr<const WornCharacter>> read);

  MainWindow& m_window;
  std::array<std::string, 2> m_files;  ///< followed so far
  std::array<std::unique_ptr<Job>, 2> m_jobs;
};

}  // namespace abrazo::app

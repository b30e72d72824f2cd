#include "app/workbench/library/mapping_desk.hpp"

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/library/mapping_dialog.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/opening/open_files.hpp"
#include "widgets/common/message_bar.hpp"

namespace abrazo::app {

MappingDesk::MappingDesk(MainWindow& window) : QObject(&window), m_window(window) {
  connect(&window, &MainWindow::mappingOffered, this, &MappingDesk::offer);
  connect(&window, &MainWindow::coloursChanged, this, [this](const widgets::Palette& palette) {
    if (m_dialog) m_dialog->setColours(palette);
  });
}

void MappingDesk::offer(const QStringList& files, const UnmappedMotion& motion) {
  delete m_dialog;
  m_dialog = new MappingDialog(*motion, &m_window);
  m_dialog->setAttribute(Qt::WA_DeleteOnClose);
  m_dialog->setColours(m_window.colours());
  connect(m_dialog, &QDialog::accepted, this, [this, files] { use(files); });
  m_dialog->open();
}

void MappingDesk::use(const QStringList& files) {
  const auto map = remember_map(m_dialog->map(), m_window.remembered().jointMapFolder().toStdString());
  if (!map) return m_window.messages().showError(words(map.error()));
  std::vector<std::string> names{*map};
  for (const QString& file : files) names.push_back(file.toStdString());
  OpeningWish wish;
  wish.files = recognised(names);
  std::erase_if(wish.files, [](const FileToOpen& file) { return file.kind == FileKind::Video; });
  if (m_window.session()) wish.open = m_window.session()->material();
  wish.said = m_dialog->said();
  m_window.openMaterial([wish](const Progress& progress) { return open_files(wish, progress); }, files);
}

}  // namespace abrazo::app

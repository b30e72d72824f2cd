#include "app/workbench/library/mapping_desk.hpp"

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/library/mapping_dialog.hpp"
#include "app/workbench/shell/main_window.hpp"
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
  const auto map = m_dialog->keep(m_window.remembered().jointMapFolder());
  if (!map) return m_window.messages().showError(words(map.error()));
  m_window.openFiles(QStringList(QString::fromStdString(*map)) + files, m_dialog->said());
}

}  // namespace abrazo::app

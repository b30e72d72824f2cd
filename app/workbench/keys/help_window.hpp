#pragma once

#include <QDialog>
#include <vector>

class QLineEdit;
class QListWidget;

namespace abrazo::app {

class HelpPage;

/// The guide of this version, which is in the program: pages at the left, a search over all of them, and the
/// present keys. Needs no network.
class HelpWindow : public QDialog {
  Q_OBJECT
 public:
  explicit HelpWindow(QWidget* parent);
  /// @param html  the sheet of keys, the first page
  void setKeys(const QString& html);
  /// Titles of the pages that are listed, best first.
  QStringList listed() const;
  /// Lists the pages that have every word of a text; all pages if it is empty.
  void search(const QString& typed);

 private:
  struct Page {
    QString title, address, words;
  };
  void readPages();
  void showPage(int page);
  void mark();

  std::vector<Page> m_pages;
  QLineEdit* m_field;
  QListWidget* m_list;
  HelpPage* m_page;
};

}  // namespace abrazo::app

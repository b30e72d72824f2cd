#pragma once

#include <QDialog>
#include <QTimer>
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
  /// Lists all pages and shows one. @param page  address below docs/, such as "guide/workbench/plots.md"; one
  /// that is not there changes nothing
  void showAbout(const QString& page);

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
  QTimer m_soon;  ///< shows the best page once a person pauses: a long one takes a moment
};

}  // namespace abrazo::app

// The dialog that asks for files: what a name without an ending becomes, what is replaced, what is readable.
#include "widgets/common/file_dialog.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeView>
#include <functional>

namespace abrazo::widgets::file_dialog_test {
namespace {

class FileDialog : public testing::Test {
 protected:
  QString path(const QString& name) const { return m_folder.filePath(name); }
  void put(const QString& name, int bytes = 4) const {
    QFile file(path(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(bytes, 'x'));
  }
  /// A person types a name, and answers the question about a file that exists.
  QString save(const QString& name, QMessageBox::StandardButton answer = QMessageBox::Yes) {
    m_asked.clear();
    bool is_typed = false;
    Person person([&](QWidget* modal) {
      if (auto* question = qobject_cast<QMessageBox*>(modal)) {
        m_asked = question->text();
        question->button(answer)->click();
      } else if (auto* files = qobject_cast<QFileDialog*>(modal)) {
        if (is_typed) return files->reject();  // after "No"
        is_typed = true;
        files->findChild<QLineEdit*>()->setText(name);
        // Not from here: this timer does not come again while it waits for the answer.
        QMetaObject::invokeMethod(files, "accept", Qt::QueuedConnection);
      }
    });
    return choose_new_file(nullptr, "Save", path("proposed.csv"), ".csv", "Tables (*.csv)");
  }
  /// Does something with every modal window that stands still.
  struct Person : QTimer {
    explicit Person(const std::function<void(QWidget*)>& act) {
      callOnTimeout([act] {
        if (QWidget* modal = QApplication::activeModalWidget()) act(modal);
      });
      start(30);
    }
  };

  QTemporaryDir m_folder;
  QString m_asked;
};

TEST_F(FileDialog, ProposesANameAndKeepsTheEndingThatIsTyped) {
  QString proposed;
  {
    Person person([&](QWidget* modal) {
      auto* files = qobject_cast<QFileDialog*>(modal);
      proposed = files->findChild<QLineEdit*>()->text();
      files->reject();
    });
    EXPECT_EQ(choose_new_file(nullptr, "Save", path("proposed.csv"), ".csv", "Tables (*.csv)"), QString());
  }
  EXPECT_EQ(proposed, "proposed.csv");
  EXPECT_EQ(save("table.csv"), path("table.csv"));
  EXPECT_EQ(save("table.txt"), path("table.txt"));
  EXPECT_EQ(m_asked, QString());
}

TEST_F(FileDialog, ANameWithoutAnEndingGetsItBeforeAFileIsReplaced) {
  EXPECT_EQ(save("table"), path("table.csv"));
  EXPECT_EQ(m_asked, QString()) << "there is nothing to replace";
  put("table.csv");
  EXPECT_EQ(save("table", QMessageBox::No), QString());
  EXPECT_TRUE(m_asked.contains("table.csv")) << m_asked.toStdString();
  EXPECT_EQ(save("table"), path("table.csv"));
  EXPECT_TRUE(m_asked.contains("table.csv")) << m_asked.toStdString();
}

/// The page and the JSON of a sweep, for example.
TEST_F(FileDialog, TheUsualEndingIsThatOfTheChosenFilter) {
  Person person([](QWidget* modal) {
    auto* files = qobject_cast<QFileDialog*>(modal);
    emit files->filterSelected("JSON (*.json)");
    files->findChild<QLineEdit*>()->setText("sweep");
    QMetaObject::invokeMethod(files, "accept", Qt::QueuedConnection);
  });
  EXPECT_EQ(choose_new_file(nullptr, "Save", path("sweep.html"), ".html", "Page (*.html);;JSON (*.json)"),
            path("sweep.json"));
}

TEST_F(FileDialog, SizesTypesAndDatesAreNotCut) {
  put("recording of the whole afternoon.jsonl", 999 * 1024);
  int looks = 0;
  Person person([&](QWidget* modal) {
    auto* files = qobject_cast<QFileDialog*>(modal);
    auto* list = files->findChild<QTreeView*>("treeView");
    ASSERT_TRUE(list);
    if (list->model()->rowCount(list->rootIndex()) == 0 || ++looks < 3) return;  // is still reading
    for (int column = 1; column < 4; ++column)
      EXPECT_GE(list->columnWidth(column), static_cast<QAbstractItemView*>(list)->sizeHintForColumn(column))
          << "column " << column;
    EXPECT_LE(list->header()->length(), list->viewport()->width()) << "the date is in view";
    files->reject();
  });
  EXPECT_EQ(choose_file(nullptr, "Open", path("."), "Frames (*.jsonl)"), QString());
  EXPECT_GE(looks, 3);
}

}  // namespace
}  // namespace abrazo::widgets::file_dialog_test

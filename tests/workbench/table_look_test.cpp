// Tables of all dialogs have the header of the theme.
#include <QDialog>
#include <QHeaderView>
#include <QTableView>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/workbench/keys/shortcut_dialog.hpp"
#include "app/workbench/library/build_dialog.hpp"
#include "app/workbench/library/mapping_dialog.hpp"
#include "tests/workbench/demo_window.hpp"

namespace abrazo::app::table_look_test {
namespace {

class TableLook : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showWindow({900, 600}); }
};

QColor ground_of(QHeaderView& header) {
  return header.grab().toImage().pixelColor(header.width() - 3, 3);
}

/// Of a table that no code dressed.
struct Plain {
  QDialog dialog;
  QTreeWidget table{&dialog};
  Plain() {
    table.setHeaderLabels({"Name"});
    auto* column = new QVBoxLayout(&dialog);
    column->addWidget(&table);
    dialog.show();
    QTest::qWait(20);
  }
};

void expect_look_of_theme(QDialog& dialog) {
  Plain plain;
  dialog.show();
  QTest::qWait(20);
  int headers = 0;
  for (auto* table : dialog.findChildren<QAbstractItemView*>())
    for (auto* header : table->findChildren<QHeaderView*>()) {
      if (!header->isVisible() || header->orientation() != Qt::Horizontal) continue;
      ++headers;
      EXPECT_EQ(header->height(), plain.table.header()->height()) << table->accessibleName().toStdString();
      EXPECT_EQ(ground_of(*header).name(), ground_of(*plain.table.header()).name());
      EXPECT_EQ(table->frameWidth(), plain.table.frameWidth());
    }
  EXPECT_GT(headers, 0) << dialog.windowTitle().toStdString();
}

TEST_F(TableLook, ShortcutsHaveTheHeaderOfTheTheme) {
  QAction* shortcuts = action("Shortcuts…");
  ASSERT_TRUE(shortcuts);
  shortcuts->trigger();
  auto* dialog = window().findChild<ShortcutDialog*>();
  ASSERT_TRUE(dialog);
  expect_look_of_theme(*dialog);
  dialog->close();
}

TEST_F(TableLook, TheBuildDialogHasTheHeaderOfTheTheme) {
  BuildDialog dialog;
  dialog.setColours(window().colours());
  expect_look_of_theme(dialog);
}

TEST_F(TableLook, TheMappingDialogHasTheHeadersOfTheTheme) {
  NamedMotion motion;
  motion.name = "three", motion.points = {"LASI", "RASI", "Head top"}, motion.parents = {-1, -1, -1};
  Positions frame(3, 3);
  frame << 0.1, 1, 0, -0.1, 1, 0, 0, 1.7, 0;
  motion.frames.push_back(frame);
  MappingDialog dialog(motion, nullptr);
  dialog.setColours(window().colours());
  expect_look_of_theme(dialog);
}

}  // namespace
}  // namespace abrazo::app::table_look_test

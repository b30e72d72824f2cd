// Finding commands by what they are for, and the guide in the program.
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QCompleter>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>

#include "app/workbench/export/export_dialog.hpp"
#include "app/workbench/keys/command_meaning.hpp"
#include "app/workbench/keys/command_row.hpp"
#include "app/workbench/keys/help_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/plots/plot_pane.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app::help_window_test {
namespace {

class HelpAndSearch : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1280, 720}); }

  static QLineEdit& field() {
    for (auto* each : window().findChildren<QLineEdit*>())
      if (each->accessibleName() == "Search commands") return *each;
    throw std::invalid_argument("no search");
  }
  static QString first(int role = Qt::DisplayRole) {
    return field().completer()->popup()->model()->index(0, 0).data(role).toString();
  }
  static void type(const QString& text) {
    press(Qt::Key_P, Qt::ControlModifier);
    field().clear();
    QTest::keyClicks(&field(), text);
    turn();
  }
  static void leave() {
    field().completer()->popup()->hide();
    field().clear();
    window().setFocus();
    turn();
  }
  static HelpWindow& help() { return *window().findChild<HelpWindow*>(); }
};

TEST_F(HelpAndSearch, OtherWordsAreOfCommandsThatThereAre) {
  for (const CommandWords& command : command_words())
    EXPECT_TRUE(action_of(window(), command.id)) << command.id;
}

TEST_F(HelpAndSearch, ACommandIsFoundByWhatItIsFor) {
  const std::pair<const char*, const char*> asked[] = {{"EAF", "Export labels…"},
                                                       {"export", "Export…"},
                                                       {"export labels", "Export labels…"},
                                                       {"save eaf", "Export labels…"},
                                                       {"guide", "Help"},
                                                       {"screenshot", "Save picture of the window"},
                                                       {"joint map", "Import motion…"},
                                                       {"table", "Figures of the selection…"},
                                                       {"motive", "Connect to a stream…"},
                                                       {"alpha", "Find a setting…"},
                                                       {"w_delta", "Find a setting…"},
                                                       {"color", "Set the range of the legend…"},
                                                       {"theme", "Light colours"}};
  for (const auto& [typed, expected] : asked) {
    type(typed);
    EXPECT_EQ(first().toStdString(), expected) << typed;
    leave();
  }
}

TEST_F(HelpAndSearch, WhatNoCommandHasIsToldAndEscapeLeavesTheSearch) {
  type("zzzz");
  EXPECT_EQ(first(), QString("No command has these words"));
  QTest::keyClick(&field(), Qt::Key_Return);
  turn();
  EXPECT_EQ(field().text(), QString("zzzz")) << "nothing was run";
  field().completer()->popup()->hide();
  field().setFocus();
  QTest::keyClick(&field(), Qt::Key_Escape);  // which is a shortcut of the scene as well
  turn();
  EXPECT_EQ(field().text(), QString());
  EXPECT_FALSE(field().hasFocus());
}

TEST_F(HelpAndSearch, TheListSaysTheKeyOfACommand) {
  type("guide");
  EXPECT_EQ(first(CommandRow::key_role), QString("F1"));
  leave();
}

TEST_F(HelpAndSearch, ReturnRunsTheFirstThatWasFound) {
  type("eaf");
  QTest::keyClick(&field(), Qt::Key_Return);
  auto& dialog = *window().findChild<ExportDialog*>();
  EXPECT_TRUE(until([&] { return dialog.isVisible(); }));
  dialog.hide();
}

/// It opened a panel and closed it again, when its whole name was typed.
TEST_F(HelpAndSearch, ReturnInTheListRunsACommandOnce) {
  for (int times = 0; times < 3; ++times) {
    const bool before = window().panels().isWanted("video");
    type("Video panel");
    QAbstractItemView* list = field().completer()->popup();
    ASSERT_TRUE(list->isVisible());
    list->setCurrentIndex(list->model()->index(0, 0));
    QTest::keyClick(list, Qt::Key_Return);
    turn();
    EXPECT_NE(window().panels().isWanted("video"), before) << times;
    leave();
  }
  window().panels().want("video", false);
}

TEST_F(HelpAndSearch, F1ShowsTheGuideAndTheKeys) {
  window().setFocus();
  press(Qt::Key_F1);
  ASSERT_TRUE(help().isVisible());
  auto& page = *help().findChild<QTextBrowser*>();
  EXPECT_TRUE(page.toPlainText().startsWith("The workbench")) << page.toPlainText().left(80).toStdString();
  EXPECT_GT(help().listed().size(), 25);
  EXPECT_FALSE(help().listed().join("").contains("`")) << "titles are plain text";
  help().findChild<QListWidget*>()->setCurrentRow(0);
  EXPECT_TRUE(page.toPlainText().contains("Play or pause")) << page.toPlainText().left(200).toStdString();
  help().close();
}

TEST_F(HelpAndSearch, F1InAPanelShowsThePageAboutIt) {
  window().plots().pane(0).setFocus();
  press(Qt::Key_F1);
  auto& page = *help().findChild<QTextBrowser*>();
  EXPECT_TRUE(page.toPlainText().startsWith("Plots")) << page.toPlainText().left(80).toStdString();
  help().close();
  ASSERT_TRUE(until([] { return window().isActiveWindow(); }));
  window().timeline().setFocus();
  press(Qt::Key_F1);
  EXPECT_TRUE(page.toPlainText().startsWith("Timeline")) << page.toPlainText().left(80).toStdString();
  help().close();
}

TEST_F(HelpAndSearch, PagesOfTheWindowComeBeforeThoseOfProgramming) {
  press(Qt::Key_F1);
  help().search({});
  const QStringList pages = help().listed();
  EXPECT_LT(pages.indexOf("Annotation"), pages.indexOf("Command line"));
  EXPECT_LT(pages.indexOf("Reference video"), pages.indexOf("Embedding"));
  EXPECT_LT(pages.indexOf("Recording"), pages.indexOf("Datasets of two people"));
  help().close();
}

TEST_F(HelpAndSearch, TablesOfTheGuideHaveOneThinLineBetweenCells) {
  press(Qt::Key_F1);
  int tables = 0;
  for (QTextFrame* frame : help().findChild<QTextBrowser*>()->document()->rootFrame()->childFrames())
    if (const auto* table = qobject_cast<QTextTable*>(frame)) {
      EXPECT_TRUE(table->format().borderCollapse());
      EXPECT_LT(table->format().borderBrush().color().alphaF(), 0.5);
      ++tables;
    }
  EXPECT_GT(tables, 0);
  help().close();
}

TEST_F(HelpAndSearch, TheGuideIsSearchedAndTheWordIsMarked) {
  press(Qt::Key_F1);
  auto& page = *help().findChild<QTextBrowser*>();
  auto& search = *help().findChild<QLineEdit*>();
  search.clear();
  QTest::keyClicks(&search, "tap mode");
  const int place = help().listed().indexOf("Annotation");
  ASSERT_GE(place, 0) << help().listed().join(", ").toStdString();
  EXPECT_FALSE(help().listed().contains("Export")) << "it has one of the words only";
  help().findChild<QListWidget*>()->setCurrentRow(place);
  EXPECT_TRUE(until([&] { return page.toPlainText().startsWith("Annotation"); }));
  EXPECT_FALSE(page.extraSelections().isEmpty());
  search.clear();
  QTest::keyClicks(&search, "nosuchword");
  EXPECT_TRUE(help().listed().isEmpty());
  help().close();
}

TEST_F(HelpAndSearch, EveryPageHasItsPicturesAndNoLinkLeadsNowhere) {
  press(Qt::Key_F1);
  help().search({});
  auto& page = *help().findChild<QTextBrowser*>();
  page.setSource(QUrl("qrc:/docs/guide/workbench/candidates.md"));
  bool has_picture = false;
  for (QTextBlock block = page.document()->begin(); block.isValid(); block = block.next())
    for (auto at = block.begin(); !at.atEnd(); ++at)
      if (at.fragment().charFormat().isImageFormat()) {
        has_picture = true;
        const QString name = at.fragment().charFormat().toImageFormat().name();
        const QVariant picture =
            page.loadResource(QTextDocument::ImageResource, page.source().resolved(name));
        EXPECT_FALSE(picture.value<QImage>().isNull()) << name.toStdString();
      }
  EXPECT_TRUE(has_picture);
  emit page.anchorClicked(QUrl("../intent.md"));
  EXPECT_EQ(page.source(), QUrl("qrc:/docs/guide/intent.md"));
  help().close();
}

}  // namespace
}  // namespace abrazo::app::help_window_test

#pragma once

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <stdexcept>

#include "app/workbench/library/retarget_desk.hpp"
#include "core/base/atomic_file.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/common/value_slider.hpp"

namespace abrazo::app {

/// A window on a library file of the generated dance.
class RetargetWindow : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    showDemo({1280, 720}, 5);
    ASSERT_TRUE(write_library(*window().session()->material().library, library_file().toStdString()));
    window().openFiles({library_file()});
    ASSERT_TRUE(until([] {
      return window().session() &&
             window().session()->material().library_file == library_file().toStdString();
    }));
  }
  void SetUp() override {
    DemoWindow::SetUp();
    output = QDir(home().path()).filePath("out");
    QDir(output).removeRecursively();
    ASSERT_TRUE(QDir().mkpath(output));
    dialog().hide();
    desk().open();
    dialog().setFolder(output);
    dialog().chooseTakes({take(0)});
    body("Leader's body").setEditText("scale:0.9");
    body("Follower's body").setEditText("library");
    for (const char* weight : {"Contacts", "Smoothness"})
      emit named<widgets::ValueSlider>(weight).resetRequested(0);
    field("Character").clear();
    field("Name").setText("out");
    frame("From frame").setValue(0);
    frame("To frame").setValue(20);
    box("As").setCurrentIndex(0);
    dialog().findChild<QCheckBox*>()->setChecked(false);
    turn();
  }

  /// The command line is built beside the tests.
  static QString program() { return QCoreApplication::applicationDirPath() + "/abrazo"; }
  static QString library_file() { return home().filePath("demo.h5"); }
  static RetargetDesk& desk() { return *window().findChild<RetargetDesk*>(); }
  static RetargetDialog& dialog() { return desk().dialog(); }
  static QString take(std::size_t index) {
    return QString::fromStdString(window().session()->material().library->takes().at(index).name);
  }
  template <typename Widget>
  static Widget& named(const QString& name) {
    for (auto* each : dialog().findChildren<Widget*>())
      if (each->accessibleName() == name) return *each;
    throw std::invalid_argument(name.toStdString());
  }
  static QComboBox& box(const QString& name) { return named<QComboBox>(name); }
  static QComboBox& body(const QString& name) { return named<QComboBox>(name); }
  static QLineEdit& field(const QString& name) { return named<QLineEdit>(name); }
  static QSpinBox& frame(const QString& name) { return named<QSpinBox>(name); }
  static QPushButton& button(const QString& text) {
    for (auto* one : dialog().findChildren<QPushButton*>())
      if (one->text() == text) return *one;
    throw std::invalid_argument(text.toStdString());
  }
  static void chooseType(const QString& ending) {
    const int index = box("As").findData(ending);
    ASSERT_GE(index, 0) << ending.toStdString();
    box("As").setCurrentIndex(index);
  }
  static std::string state() { return dialog().findChild<QLabel*>("state")->text().toStdString(); }
  static std::string about() {
    std::string all;
    for (const auto* label : dialog().findChildren<QLabel*>("secondary"))
      all += label->text().toStdString() + "|";
    return all;
  }
  /// As a person does it, to the end.
  static void retarget() {
    ASSERT_TRUE(button("Retarget").isEnabled()) << about();
    button("Retarget").click();
    ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  }
  QStringList files() const { return QDir(output).entryList(QDir::Files | QDir::Hidden, QDir::Name); }
  std::string content(const QString& name) const {
    const auto read = read_whole_file(QDir(output).filePath(name).toStdString());
    return read ? *read : std::string();
  }
  /// What the command line writes for the same wish.
  void retargetOnTheCommandLine(const QStringList& more) const {
    QProcess abrazo;
    abrazo.setWorkingDirectory(output);
    abrazo.start(program(), QStringList{"retarget", "--library", library_file()} + more);
    ASSERT_TRUE(abrazo.waitForFinished(-1));
    ASSERT_EQ(abrazo.exitCode(), 0) << abrazo.readAllStandardError().toStdString();
  }

  QString output;
};

}  // namespace abrazo::app

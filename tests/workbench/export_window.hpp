#pragma once

// The window on the generated dance with its dialog of exports.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <stdexcept>

#include "app/workbench/export/export_desk.hpp"
#include "app/workbench/export/export_dialog.hpp"
#include "core/base/atomic_file.hpp"
#include "tests/support/humanoid_rig.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/offer_bar.hpp"

namespace abrazo::app::export_fixture {

class ExportWindow : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1100, 700}, 60); }

  static ExportDesk& desk() { return *window().findChild<ExportDesk*>(); }
  static ExportDialog& dialog() { return *window().findChild<ExportDialog*>(); }
  static QComboBox& box(const char* name) { return *dialog().findChild<QComboBox*>(name); }
  static QCheckBox& body(const QString& name) {
    for (auto* check : dialog().findChildren<QCheckBox*>())
      if (check->text() == name) return *check;
    throw std::invalid_argument(name.toStdString());
  }
  static QPushButton& button(const QString& text) {
    for (auto* one : dialog().findChildren<QPushButton*>())
      if (one->text() == text) return *one;
    throw std::invalid_argument(text.toStdString());
  }
  static void choose(const char* name, const QVariant& data) {
    const int index = box(name).findData(data);
    ASSERT_GE(index, 0) << name << " does not have " << data.toString().toStdString();
    box(name).setCurrentIndex(index);
  }
  static QString estimate() { return dialog().findChild<QLabel*>("estimate")->text(); }
  void SetUp() override {
    DemoWindow::SetUp();
    dialog().offer(desk().offer());
    choose("What", 0);
    choose("Of", QString());
    choose("Part", "all");
    for (const char* name : {"Leader", "Follower"}) body(name).setChecked(true);
    body("User as received").setChecked(false);
    character().clear();
  }
  static qsizetype rootsIn(const QString& name) {
    return QString::fromStdString(content(name)).count("ROOT ");
  }
  static QLineEdit& character() {
    for (auto* each : dialog().findChildren<QLineEdit*>())
      if (each->accessibleName() == "Character") return *each;
    throw std::invalid_argument("no field for a character");
  }
  /// What the dialog says below the choices: why they do not go together, or what the file will hold.
  static std::string about() { return dialog().findChild<QLabel*>("secondary")->text().toStdString(); }
  static std::string content(const QString& name) {
    const auto read = read_whole_file(file(name).toStdString());
    return read ? *read : std::string();
  }
  /// Presses Export, names the file and answers whether files may be replaced. @return the question
  static QString exportTo(const QString& name, QMessageBox::StandardButton answer) {
    QString asked;
    QTimer person;
    QObject::connect(&person, &QTimer::timeout, &person, [&] {
      QWidget* modal = QApplication::activeModalWidget();
      if (auto* files = qobject_cast<QFileDialog*>(modal)) {
        files->findChild<QLineEdit*>()->setText(file(name));
        QMetaObject::invokeMethod(files, "accept");
      } else if (auto* question = qobject_cast<QMessageBox*>(modal)) {
        asked = question->text();
        question->button(answer)->click();
      }
    });
    person.start(20);
    button("Export…").click();
    EXPECT_TRUE(until([] { return !desk().isBusy(); }));
    return asked;
  }
  /// A humanoid with the bone names of VRM 1.0.
  static QString rig() {
    EXPECT_TRUE(write_whole_file(file("rig.vrm").toStdString(), test::rig(test::Naming::Vrm1)));
    return file("rig.vrm");
  }
  static QString file(const QString& name) { return home().filePath(name); }
  /// Writes what the dialog says, to the end.
  static void write(const QString& name) {
    desk().write(dialog().request(), file(name));
    ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  }
  static QString told() { return desk().bar().text(); }
};

}  // namespace abrazo::app::export_fixture

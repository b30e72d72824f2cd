#include "widgets/settings/body_box.hpp"

namespace abrazo::widgets {

BodyBox::BodyBox(bool with_user, QWidget* parent) : QComboBox(parent) {
  setEditable(true);
  setInsertPolicy(QComboBox::NoInsert);
  setCompleter(nullptr);  // "scale:0.8" would become "scale:0.85"
  addItem("library");
  if (with_user) addItem("user");
  addItems({"scale:0.85", "scale:1.15"});
  setMinimumWidth(112);
  setFocusPolicy(Qt::StrongFocus);
}

}  // namespace abrazo::widgets

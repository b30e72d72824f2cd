#pragma once

#include <QComboBox>

namespace abrazo::widgets {

/// A body that a character can get, as text: an entry, or anything else that `parse_body_choice` reads.
class BodyBox : public QComboBox {
  Q_OBJECT
 public:
  /// @param with_user  the user's own body is an entry as well
  BodyBox(bool with_user, QWidget* parent);
};

}  // namespace abrazo::widgets

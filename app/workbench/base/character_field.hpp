#pragma once

#include <QWidget>

class QLineEdit;

namespace abrazo::app {

/// Field of a dialog for a humanoid of another program (GLB, VRM) that performs the motion: its path, and a
/// button that chooses the file. Reads no file itself.
class CharacterField : public QWidget {
  Q_OBJECT
 public:
  explicit CharacterField(QWidget* parent);
  /// The path; empty = no character.
  QString file() const;
  void setFile(const QString& file);
  /// Where the choice of a file starts.
  void setFolder(const QString& folder) { m_folder = folder; }
  /// Why no character can be read from the path; empty = it is a file, or there is no path.
  QString trouble() const;

 signals:
  void changed();

 private:
  void choose();

  QLineEdit* m_path;
  QString m_folder;
};

}  // namespace abrazo::app

#pragma once

#include <QDialog>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/session/export/export_plan.hpp"
#include "core/session/frames/playback.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace abrazo::app {

class CharacterField;

/// The available data.
struct ExportOffer {
  struct Stretch {
    QString name;
    Playback::Range range;
  };
  std::optional<Stretch> session;        ///< the whole session; none before the first frame
  std::vector<double> times_s;           ///< of its frames, ascending
  std::optional<Playback::Range> range;  ///< between in and out
  std::optional<double> cursor_s;        ///< time of the shown frame; none if it is not of the session
  std::vector<Stretch> takes;            ///< of the session
  std::vector<Stretch> library_takes;    ///< times of the take
  /// Times of the frames that the library has of a take, ascending.
  std::function<std::vector<double>(const QString&)> times_of_take;
  SessionBody partner = SessionBody::Passive;  ///< the body that answers the user at present
  std::array<QString, 2> worn;  ///< character files of the scene, leader then follower; empty = capsules
};

/// The chosen options, without the file.
struct ExportRequest {
  QString library_take;  ///< by name; empty = the session
  ExportWish wish;       ///< the output is only the extension, ".bvh"
  bool plots = false;    ///< export the plots instead, with that type
};

/// Dialog for an export of the session or of a take: content, range and format.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ExportDialog(QWidget* parent);
  /// Keeps choices that are still valid.
  void offer(ExportOffer offer);
  /// Chooses labels as EAF. @param subject  a take of the library; empty = the session
  void chooseLabels(const QString& subject);
  /// Where the choice of a character starts.
  void setFolder(const QString& folder);
  /// Chooses the type that a typed name ends with, if it is one of the offered ones.
  void chooseTypeOf(const QString& file);
  ExportRequest request() const;
  /// Whether the choices go together; if not, the dialog says why.
  bool canExport() const;
  /// The last choices, for the next start; what was only proposed is not among them. @see restore
  QStringList choices() const;
  /// Starts from the last choices, and proposes what the window is set to: the part from in to out, and the
  /// worn character where the type can hold it. Without choices also the partner as the body.
  void restore(const QStringList& choices);

 signals:
  void exportRequested();
  void videoRequested();

 private:
  enum What { Motion, Mesh, Labels, Trace, Plots };
  What what() const;
  ExportOffer::Stretch stretch() const;
  Playback::Range part() const;
  bool isPerformed() const;
  bool hasSpace() const;
  bool hasTiers() const;
  bool hasRate() const;
  QString trouble(const ExportRequest& request) const;
  std::span<const double> times() const;
  void sourceChanged();
  QCheckBox* boxOf(SessionBody body) const;
  void chooseBodies(const QStringList& names);
  QString worn() const;
  void proposeCharacter();
  void showTypes();
  void settle();
  void showRow(QWidget* field, bool on);

  ExportOffer m_offer;
  std::vector<double> m_takeTimes;  ///< of the frames of the chosen take of the library
  QFormLayout* m_form;
  QComboBox *m_source, *m_what, *m_part, *m_type, *m_tiers, *m_unit, *m_up;
  QWidget* m_bodies;
  CharacterField* m_character;
  QCheckBox *m_user, *m_active, *m_passive;
  QDoubleSpinBox* m_rate;
  QLabel *m_about, *m_estimate;
  QPushButton* m_export;
  bool m_filling = false;
  bool m_mayProposeCharacter = false;  ///< until one was proposed, or the field was changed
};

}  // namespace abrazo::app

#pragma once

#include <QDialog>
#include <optional>
#include <vector>

#include "core/session/export/export_wish.hpp"
#include "core/session/frames/playback.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace abrazo::app {

/// What there is to export.
struct ExportOffer {
  struct Stretch {
    QString name;
    Playback::Range range;
    double rate_hz = 0;
  };
  std::optional<Stretch> session;        ///< all there is of it; nothing while no frame was solved
  std::optional<Playback::Range> range;  ///< between in and out
  std::optional<double> cursor_s;      ///< of the frame that is shown; nothing while it is not of the session
  std::vector<Stretch> takes;          ///< of the session
  std::vector<Stretch> library_takes;  ///< times of the take
};

/// What a person chose; without the file.
struct ExportRequest {
  QString library_take;  ///< by name; empty = the session
  ExportWish wish;       ///< the output is the ending alone, ".bvh"
  bool plots = false;    ///< the plots instead, as that type
};

/// Asks what of the session or of a take of the library is to be written, which part and how.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ExportDialog(QWidget* parent);
  /// Keeps the choices that still fit.
  void offer(ExportOffer offer);
  ExportRequest request() const;
  /// Of what was chosen last, for the next start. @see restore
  QStringList choices() const;
  void restore(const QStringList& choices);

 signals:
  void exportRequested();
  void videoRequested();

 private:
  enum What { Motion, Mesh, Labels, Trace, Plots };
  What what() const;
  ExportOffer::Stretch stretch() const;
  Playback::Range part() const;
  void sourceChanged();
  void whatChanged();
  void settle();
  void showRow(QWidget* field, bool on);

  ExportOffer m_offer;
  QFormLayout* m_form;
  QComboBox *m_source, *m_what, *m_part, *m_type, *m_unit, *m_up;
  QWidget* m_bodies;
  QCheckBox *m_user, *m_active, *m_passive;
  QDoubleSpinBox* m_rate;
  QLabel *m_about, *m_estimate;
  QPushButton* m_export;
  bool m_filling = false;
};

}  // namespace abrazo::app

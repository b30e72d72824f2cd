#pragma once

#include <QStringList>
#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/stream/stream_address.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace abrazo::widgets {

/// Address of a stream: fields that form a URI, and the URI to type, paste or choose from recent ones.
class AddressForm : public QWidget {
  Q_OBJECT
 public:
  explicit AddressForm(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// Latest first.
  void setRecent(const QStringList& uris);
  void setConnected(bool connected);
  void setUri(const QString& uri);
  QString uri() const;
  /// The problem of the URI; empty if valid.
  QString complaint() const;
  /// Focuses the input field.
  void takeFocus();

 signals:
  void connectRequested(const QString& uri);
  void disconnectRequested();

 private:
  void makeFields();
  void lay();
  void fieldsChanged();
  void uriChanged(const QString& uri);
  void showScheme(StreamUri::Scheme scheme);
  void showComplaint(const QString& words);
  void press();
  void chooseFile();

  Palette m_palette;
  StreamAddress m_address;
  bool m_connected = false;
  QComboBox *m_scheme, *m_uri;
  QLineEdit *m_host, *m_port, *m_group, *m_file;
  QLabel* m_note;  ///< meaning of the address, or its problem
  QString m_wrong;
  QStackedWidget* m_more;  ///< fields of single schemes
  QPushButton* m_connect;
};

}  // namespace abrazo::widgets

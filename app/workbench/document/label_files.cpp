#include "app/workbench/document/label_files.hpp"

#include <QByteArray>
#include <QFile>
#include <QFileInfo>

#include "core/library/takes/tier_file.hpp"

namespace abrazo::app {
namespace {

QByteArray head_of(const QString& file) {
  QFile opened(file);
  constexpr int enough = 400;
  return opened.open(QIODevice::ReadOnly) ? opened.read(enough) : QByteArray();
}

}  // namespace

bool is_label_file(const QString& file) {
  if (!is_tier_file(file.toStdString())) return false;
  const QString ending = QFileInfo(file).suffix().toLower();
  if (ending == "csv") {
    const QByteArray head = head_of(file).trimmed().toLower();
    return head.startsWith("take,start") || head.startsWith("tier,start");
  }
  return ending != "json" || head_of(file).contains("\"tiers\"");
}

}  // namespace abrazo::app

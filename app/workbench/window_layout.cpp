#include "app/workbench/window_layout.hpp"

#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QScreen>
#include <QWidget>
#include <algorithm>

namespace abrazo::app {
namespace {

constexpr const char* version_key = "abrazo_layout";
constexpr int least_to_hold = 48;  // pixels of a window's head that suffice to move it

QJsonValue text_of(const std::optional<bool>& wish) {
  return wish ? QJsonValue(*wish) : QJsonValue();
}

std::optional<bool> wish_of(const QJsonValue& value) {
  return value.isBool() ? std::optional(value.toBool()) : std::nullopt;
}

QStringList names_of(const QJsonValue& value) {
  QStringList names;
  for (const QJsonValueRef name : value.toArray()) names << name.toString();
  return names;
}

}  // namespace

QByteArray text_of(const WindowLayout& layout) {
  const QJsonObject object{{version_key, layout_version},
                           {"docks", QString::fromLatin1(layout.docks.toBase64())},
                           {"known", QJsonArray::fromStringList(layout.known)},
                           {"shown", QJsonArray::fromStringList(layout.shown)},
                           {"left", text_of(layout.sides.left)},
                           {"right", text_of(layout.sides.right)},
                           {"below", text_of(layout.sides.plots)},
                           {"timeline_height", layout.timeline_height}};
  return QJsonDocument(object).toJson();
}

Result<WindowLayout> parse_layout(const QByteArray& text, const std::string& file) {
  const QJsonObject object = QJsonDocument::fromJson(text).object();
  if (!object.contains(version_key))
    return Error{"is no layout of a window; delete the file, or save the layout again", file};
  if (object.value(version_key).toInt() != layout_version)
    return Error{"is a layout of another version of Abrazo; arrange the window and save the layout again",
                 file};
  WindowLayout layout;
  layout.docks = QByteArray::fromBase64(object.value("docks").toString().toLatin1());
  layout.known = names_of(object.value("known"));
  layout.shown = names_of(object.value("shown"));
  layout.sides = {wish_of(object.value("left")), wish_of(object.value("right")),
                  wish_of(object.value("below"))};
  layout.timeline_height = std::max(0, object.value("timeline_height").toInt());
  return layout;
}

void bring_onto_screen(QWidget& window) {
  const QRect frame = window.frameGeometry();
  const QRect head(frame.topLeft(), QSize(frame.width(), least_to_hold));
  const auto reaches = [&](const QScreen* screen) {
    const QRect seen = screen->availableGeometry().intersected(head);
    return seen.width() >= least_to_hold && seen.height() >= least_to_hold / 3;
  };
  const QList<QScreen*> screens = QGuiApplication::screens();
  if (screens.isEmpty() || std::ranges::any_of(screens, reaches)) return;
  const QRect room = screens.front()->availableGeometry();
  window.resize(window.size().boundedTo(room.size()));
  window.move(room.center() - window.rect().center());
}

}  // namespace abrazo::app

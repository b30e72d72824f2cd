#include "app/workbench/shell/window_layout.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace abrazo::app {
namespace {

constexpr const char* version_key = "abrazo_layout";
constexpr int tallest_px = 1 << 14;  // a sum of heights stays a number

QJsonValue wish_json(const std::optional<bool>& wish) {
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

QJsonObject sizes_json(const std::map<QString, QSize>& sizes) {
  QJsonObject object;
  for (const auto& [id, size] : sizes) object[id] = QJsonArray{size.width(), size.height()};
  return object;
}

std::map<QString, QSize> sizes_of(const QJsonObject& object) {
  std::map<QString, QSize> sizes;
  for (auto each = object.begin(); each != object.end(); ++each) {
    const QJsonArray size = each.value().toArray();
    if (size.size() == 2)
      sizes[each.key()] = {std::clamp(size[0].toInt(), 0, tallest_px),
                           std::clamp(size[1].toInt(), 0, tallest_px)};
  }
  return sizes;
}

}  // namespace

QByteArray text_of(const WindowLayout& layout) {
  const QJsonObject object{
      {version_key, layout_version},
      {"docks", QString::fromLatin1(layout.docks.toBase64())},
      {"known", QJsonArray::fromStringList(layout.known)},
      {"shown", QJsonArray::fromStringList(layout.shown)},
      {"left", wish_json(layout.sides.left)},
      {"right", wish_json(layout.sides.right)},
      {"below", wish_json(layout.sides.plots)},
      {"timeline_height", layout.timeline_height ? QJsonValue(*layout.timeline_height) : QJsonValue()},
      {"sizes", sizes_json(layout.sizes)}};
  return QJsonDocument(object).toJson();
}

Result<WindowLayout> parse_layout(const QByteArray& text, const std::string& file) {
  const QJsonObject object = QJsonDocument::fromJson(text).object();
  if (!object.contains(version_key))
    return Error{"is not a window layout; delete the file, or save the layout again", file};
  if (object.value(version_key).toInt() != layout_version)
    return Error{"is a layout of another version of Abrazo; arrange the window and save the layout again",
                 file};
  WindowLayout layout;
  layout.docks = QByteArray::fromBase64(object.value("docks").toString().toLatin1());
  layout.known = names_of(object.value("known"));
  layout.shown = names_of(object.value("shown"));
  layout.sides = {wish_of(object.value("left")), wish_of(object.value("right")),
                  wish_of(object.value("below"))};
  if (const QJsonValue height = object.value("timeline_height"); height.isDouble())
    layout.timeline_height = std::clamp(height.toInt(), 0, tallest_px);
  layout.sizes = sizes_of(object.value("sizes").toObject());
  return layout;
}

}  // namespace abrazo::app

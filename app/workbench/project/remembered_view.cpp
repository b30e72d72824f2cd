#include "app/workbench/project/remembered_view.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/text.hpp"

namespace abrazo::app {

std::string text_of(const CameraTurn& turn) {
  return exact_text(turn.azimuth_rad) + " " + exact_text(turn.elevation_rad);
}

std::optional<CameraTurn> camera_turn_of(const std::string& text) {
  const auto words = split_words(text);
  const auto azimuth = words.size() == 2 ? parse_number(words[0]) : std::nullopt;
  const auto elevation = words.size() == 2 ? parse_number(words[1]) : std::nullopt;
  if (!azimuth || !elevation || !std::isfinite(*azimuth)) return std::nullopt;
  if (!(std::abs(*elevation) <= std::numbers::pi / 2)) return std::nullopt;
  return CameraTurn{std::remainder(*azimuth, 2 * std::numbers::pi), *elevation};
}

std::string text_of(const Markers& markers) {
  QJsonArray list;
  for (const Marker& marker : markers.all())
    list.append(QJsonObject{
        {"id", marker.id}, {"time_s", marker.time_s}, {"name", QString::fromStdString(marker.name)}});
  return QJsonDocument(list).toJson(QJsonDocument::Compact).toStdString();
}

Markers markers_of(const std::string& text) {
  std::vector<Marker> markers;
  int last_id = 0;
  for (const QJsonValue& each : QJsonDocument::fromJson(QByteArray::fromStdString(text)).array()) {
    const double time_s = each["time_s"].toDouble(std::nan(""));
    if (!std::isfinite(time_s)) continue;
    const int id = std::clamp(each["id"].toInt(), 0, 1'000'000'000);
    markers.push_back({id, time_s, each["name"].toString().toStdString()});
    last_id = std::max(last_id, id);
  }
  return Markers::restored(std::move(markers), last_id + 1);
}

}  // namespace abrazo::app

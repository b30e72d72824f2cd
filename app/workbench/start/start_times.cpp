#include "app/workbench/start/start_times.hpp"

#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <optional>
#include <string_view>

#include "app/workbench/document/document.hpp"
#include "app/workbench/shell/frame_ticker.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

/// Start time of this process since boot; none if unknown.
std::optional<double> process_start_s() {
  constexpr std::size_t start_field = 19;  // counted from behind the name, which may hold anything but ')'
  const auto stat = read_whole_file("/proc/self/stat");
  if (!stat || stat->rfind(") ") == std::string::npos) return std::nullopt;
  const auto fields = split_fields(std::string_view(*stat).substr(stat->rfind(") ") + 2), ' ');
  const auto ticks = fields.size() > start_field ? parse_integer(fields[start_field]) : std::nullopt;
  if (!ticks) return std::nullopt;
  return static_cast<double>(*ticks) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

double since_process_start_ms() {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  const double now_s = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  static const double start_s = process_start_s().value_or(now_s);
  return std::max(0.0, 1000 * (now_s - start_s));
}

void StartTimes::reached(const char* stage) {
  const bool is_known = std::any_of(m_stages.begin(), m_stages.end(), [stage](const Stage& known) {
    return std::string_view(known.name) == stage;
  });
  if (!is_known) m_stages.push_back({stage, since_process_start_ms()});
}

void StartTimes::follow(Document& document, FrameTicker& ticker, widgets::SceneView& scene) {
  connect(&document, &Document::began, this, [this] { reached("library ready"); });
  connect(&ticker, &FrameTicker::frameReady, this, [this] { reached("first frame solved"); });
  connect(&scene, &widgets::SceneView::pictureDrawn, this, &StartTimes::pictureDrawn);
}

void StartTimes::pictureDrawn(const FrameSnapshotPtr& shown) {
  if (!shown || m_hasMoved) return;
  reached("first picture");
  if (!m_first) m_first = shown;
  if (shown->result.passive() == m_first->result.passive()) return;
  reached("first moving picture");
  m_hasMoved = true;
  emit moved();
}

QString StartTimes::text() const {
  QString text;
  for (const Stage& stage : m_stages)
    text += QString("start: %1 ms  %2\n").arg(stage.after_ms, 6, 'f', 0).arg(stage.name);
  return text;
}

}  // namespace abrazo::app

#include "app/workbench/keys/shortcut_table.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;
using abrazo::app::KeyPlace;
using abrazo::app::ShortcutTable;

namespace {

ShortcutTable table() {
  ShortcutTable table;
  table.add({"play.play_or_pause", "Play", "Play or pause", {"Space"}, {"Space"}, KeyPlace::Window, false});
  table.add({"edit.undo", "Edit", "Undo", {"Ctrl+Z"}, {"Ctrl+Z"}, KeyPlace::Window, false});
  table.add({"view.top", "View", "From above", {"5"}, {"5"}, KeyPlace::Scene, false});
  table.add({"labels.five", "Labels", "Fifth", {"5"}, {"5"}, KeyPlace::Timeline, true});
  return table;
}

}  // namespace

ABRAZO_FUZZ_TARGET(shortcuts)(fuzz::Bytes bytes) {
  const auto normal = [](const std::string& key) { return key.size() < 20 ? key : std::string(); };
  ShortcutTable read = table();
  (void)read.read(std::string(fuzz::text_of(bytes)), normal);
  const std::string written = read.text();
  ShortcutTable again = table();
  (void)again.read(written, normal);
  fuzz::expect(again.text() == written, "shortcuts do not read back to what they were");
}

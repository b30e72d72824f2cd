#include "app/workbench/keys/key_sheet.hpp"

#include <QStringList>
#include <algorithm>

#include "app/workbench/keys/shortcuts.hpp"

namespace abrazo::app {
namespace {

struct Block {
  QString title;
  QStringList rows;
};

QString row(const QString& key, const QString& text) {
  return QString("<tr><td><b>%1</b>&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>")
      .arg(key.toHtmlEscaped(), text.toHtmlEscaped());
}

QString row(const Shortcut& shortcut) {
  constexpr int most_listed = 4;
  QStringList keys;
  for (const std::string& key : shortcut.keys) keys << Shortcuts::shown(key);
  if (keys.size() > most_listed) keys = QStringList{keys.front() + " to " + keys.back()};
  const std::string_view place = words_of(shortcut.place);
  return row(keys.join(", "), QString::fromStdString(shortcut.text + std::string(place)));
}

/// By menu, those within menus for themselves.
std::vector<Block> blocks_of(const ShortcutTable& table) {
  std::vector<Block> blocks;
  for (const Shortcut& shortcut : table.all()) {
    if (shortcut.keys.empty()) continue;
    const QString menu =
        shortcut.is_fixed ? QString("In a view") : QString::fromStdString(shortcut.menu).section(" > ", -1);
    auto block =
        std::find_if(blocks.begin(), blocks.end(), [&menu](const Block& b) { return b.title == menu; });
    if (block == blocks.end()) block = blocks.insert(blocks.end(), {menu, {}});
    block->rows << row(shortcut);
  }
  blocks.push_back({"Mouse in the scene",
                    {row("drag", "Turn"), row("Shift + middle, right", "Move"),
                     row("wheel", "Nearer, farther"), row("click", "Select; Shift adds")}});
  blocks.push_back({"Mouse in the timeline",
                    {row("drag", "Go to a time"), row("Shift + drag", "In and out"),
                     row("wheel", "Shorter or longer span")}});
  return blocks;
}

QString html_of(const Block& block, const widgets::Palette& colours) {
  return QString("<p style='color:%1'>%2</p><table cellspacing=2>%3</table>")
      .arg(colours.secondary.name(), block.title.toUpper().toHtmlEscaped(), block.rows.join(""));
}

}  // namespace

QString key_sheet(const ShortcutTable& table, const widgets::Palette& colours, int columns) {
  std::vector<Block> blocks = blocks_of(table);
  // Longest first, each into the shortest column.
  std::stable_sort(blocks.begin(), blocks.end(),
                   [](const Block& a, const Block& b) { return a.rows.size() > b.rows.size(); });
  std::vector<QString> cells(static_cast<std::size_t>(columns));
  std::vector<int> lengths(cells.size());
  for (const Block& block : blocks) {
    const auto shortest =
        static_cast<std::size_t>(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
    cells[shortest] += html_of(block, colours);
    lengths[shortest] += static_cast<int>(block.rows.size()) + 3;
  }
  QString html;
  for (const QString& cell : cells) html += "<td>" + cell + "</td><td width=32></td>";
  return "<table><tr>" + html + "</tr></table>";
}

}  // namespace abrazo::app

#include "app/workbench/keys/command_meaning.hpp"

#include <QRegularExpression>
#include <QStringList>
#include <array>

namespace abrazo::app {
namespace {

constexpr std::array<CommandWords, 37> other_words = {{
    {"annotation.export_labels",
     "export eaf elan csv json praat textgrid audacity annotations roles moves file save write"},
    {"annotation.import_labels",
     "open eaf elan csv json praat textgrid audacity annotations roles moves file read load"},
    {"file.export",
     "bvh glb gltf csv numpy npz vtu paraview blender motion mesh trace labels eaf file save write"},
    {"file.save_picture_of_the_window", "screenshot png image"},
    {"annotation.annotate_take", "label annotations eaf controlled vocabulary"},
    {"annotation.new_label", "annotate draw interval segment"},
    {"annotation.next_label", "find search annotation"},
    {"annotation.loop_the_label", "play repeat selection range annotation"},
    {"timeline.marker_with_a_name", "comment note bookmark"},
    {"annotation.change_of_role_here", "leader follower leads active passive swap"},
    {"live.switch_the_user_s_role", "leader follower leads active passive swap"},
    {"library.retarget_take",
     "body bodies size scale proportions taller smaller transfer character rig avatar vrm glb bvh export"},
    {"solve.sweep_two_settings", "grid search parameters heat map optimise tune"},
    {"solve.find_a_setting",
     "alpha w_delta w_c k temperature weight collisions playback foot locks slider parameter filter"},
    {"edit.undo", "revert back"},
    {"edit.redo", "again repeat"},
    {"play.play_or_pause", "start stop space"},
    {"play.slower", "slow motion half speed rate"},
    {"play.faster", "double speed rate"},
    {"play.normal_speed", "rate reset"},
    {"play.loop", "repeat selection range"},
    {"play.loop_back_and_forth", "repeat ping pong"},
    {"play.follow_the_live_end", "live now newest end"},
    {"help.help", "guide manual documentation f1 how"},
    {"help.keys", "shortcuts hotkeys keyboard bindings"},
    {"help.shortcuts", "keys hotkeys keyboard change bindings"},
    {"view.full_screen", "maximise fullscreen"},
    {"file.open", "load import bvh fbx c3d session library motion"},
    {"file.import_motion", "joint map markers unit axis floor fbx c3d trc bvh glb load"},
    {"view_selection.figures_of_the_selection",
     "table numbers values spreadsheet csv inspector edges tetrahedra"},
    {"plots.export_plot_samples_csv", "table numbers values spreadsheet file save write"},
    {"view_legend.set_the_range_of_the_legend", "scale limits minimum maximum colour color bar residual"},
    {"view_legend.logarithmic_colours", "legend scale log decades color"},
    {"view.light_colours", "dark theme mode bright appearance color"},
    {"live.connect_to_a_stream", "motive optitrack natnet vmc xsens mvn network suit"},
    {"file.save", "project session write"},
    {"file.render_range", "film movie video mp4 animation"},
}};

QStringList words_of_text(const QString& text) {
  static const QRegularExpression between("[^\\w']+", QRegularExpression::UseUnicodePropertiesOption);
  return text.toLower().split(between, Qt::SkipEmptyParts);
}

bool begins_one(const QStringList& words, const QString& typed) {
  for (const QString& word : words)
    if (word.startsWith(typed)) return true;
  return false;
}

}  // namespace

std::span<const CommandWords> command_words() {
  return other_words;
}

int command_match(const QString& typed, const QString& id, const QString& text, const QString& menu) {
  constexpr int by_name = 10000, by_text = 4000, by_meaning = 3000, by_menu = 1000, inside = 500;
  QStringList other;
  int place = 0;  // what stands first among the other words comes first where the rest is equal
  for (std::size_t i = 0; i < other_words.size(); ++i)
    if (id == other_words[i].id) {
      other = words_of_text(other_words[i].words);
      place = static_cast<int>(other_words.size() - i);
    }
  const QStringList own = words_of_text(text), of_menu = words_of_text(menu);
  int score = 0;
  for (const QString& word : words_of_text(typed)) {
    const bool is_own = begins_one(own, word), is_meant = begins_one(other, word);
    // A command that has the word and is meant by it as well comes before one that only has it.
    const int found = (is_own ? by_text : 0) + (is_meant ? by_meaning + place : 0) +
                      (begins_one(of_menu, word) ? by_menu : 0) +
                      (!is_own && text.contains(word, Qt::CaseInsensitive) ? inside : 0);
    if (found == 0) return 0;
    score += found;
  }
  if (score > 0 && text.startsWith(typed.trimmed(), Qt::CaseInsensitive)) score += inside;
  if (own == words_of_text(typed))
    score += by_name;  // "export" is "Export…" before all that export something
  return score;
}

}  // namespace abrazo::app

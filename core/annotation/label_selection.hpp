#pragma once

#include "core/annotation/label_edits.hpp"

namespace abrazo {

/// The active tier, the selected label and the conflict rule of the shown subject. The annotations belong to
/// the live project and are passed in.
class LabelSelection {
 public:
  int tier() const { return tier_; }          ///< id of the active one; 0 = none
  int selected() const { return selected_; }  ///< id of the selected annotation; 0 = none
  Conflict conflict() const { return conflict_; }

  /// Activates a tier and deselects an annotation of another tier. @return false if it does not exist or is
  /// active already
  bool choose_tier(const Annotations& shown, int tier);
  /// Selects an annotation and activates its tier. @param annotation 0 = none. @return whether the selection
  /// changed
  bool select(const Annotations& shown, int annotation);
  void set_conflict(Conflict conflict) { conflict_ = conflict; }

  /// Begins with another subject: nothing is selected, its first tier of moves is active.
  void begin(const Annotations& shown);
  /// After an edit: drops what no longer exists. Without an active tier the first of moves becomes active.
  void settle(const Annotations& shown);

 private:
  int tier_ = 0;
  int selected_ = 0;
  Conflict conflict_ = Conflict::Replace;
};

}  // namespace abrazo

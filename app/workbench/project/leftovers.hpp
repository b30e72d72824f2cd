#pragma once

#include <QStringList>
#include <vector>

#include "widgets/takes/leftover_bar.hpp"

namespace abrazo::app {

class UserSettings;

/// Files left behind by ended programs.
struct LeftoverFiles {
  QStringList sessions;   ///< not closed
  QStringList autosaves;  ///< with changes that were not saved
  QStringList histories;  ///< the newest file of each
  bool empty() const { return sessions.isEmpty() && autosaves.isEmpty() && histories.isEmpty(); }
};

LeftoverFiles leftover_files(const UserSettings& remembered);

/// Descriptions of these files for the user. Reads them: call it on a worker.
std::vector<widgets::LeftoverSession> described(const LeftoverFiles& files);

}  // namespace abrazo::app

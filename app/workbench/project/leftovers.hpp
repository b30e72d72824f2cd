#pragma once

#include <QStringList>
#include <vector>

#include "widgets/takes/leftover_bar.hpp"

namespace abrazo::app {

class UserSettings;

/// Files that programs which are gone left behind.
struct LeftoverFiles {
  QStringList sessions;   ///< not closed
  QStringList autosaves;  ///< with changes that were not saved
  QStringList histories;  ///< the newest file of each
  bool empty() const { return sessions.isEmpty() && autosaves.isEmpty() && histories.isEmpty(); }
};

LeftoverFiles leftover_files(const UserSettings& remembered);

/// What is offered of them, in words. Reads the files: call it on a worker.
std::vector<widgets::LeftoverSession> described(const LeftoverFiles& files);

}  // namespace abrazo::app

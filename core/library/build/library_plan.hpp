#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/library/build/pairing_guess.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo {

/// What a performer does in a take.
enum class PlannedRole { Either, Leads, Follows };

/// A performer of a motion file: how the file was read, and what it is to be in a library.
struct PlannedPerformer {
  Manifest::Performer source;  ///< with what a person said of the file; what is not said is found out
  std::optional<double> fps;   ///< likewise
  std::string name;
  int in_the_file = 1;  ///< performers that the file shows
  ImportReport report;
  std::shared_ptr<const Clip> clip;  ///< whole; null when the file could not be read
  std::optional<Error> trouble;      ///< then why

  std::string take;  ///< two performers with the same are its pair; empty = not used
  PlannedRole role = PlannedRole::Either;
  std::optional<PairGuess> guess;  ///< why it is in its take; nothing once a person said so

  int frames() const { return clip ? static_cast<int>(clip->poses.size()) : 0; }
};

/// A library to be built from motion files, while a person is still deciding about it.
struct LibraryPlan {
  std::string name = "library";
  std::filesystem::path labels;             ///< for all takes; empty = none
  std::vector<std::string> labelled_takes;  ///< that the label file names
  std::vector<PlannedPerformer> performers;
};

/// Reads a motion file as the plan says. One entry for each of its performers; a single one with `trouble`
/// when it cannot be read.
std::vector<PlannedPerformer> survey_motion(const Manifest::Performer& source, std::optional<double> fps,
                                            const Progress& progress = {});

/// Guesses the pairs among the performers that are in no take yet and could be read. Takes in use keep
/// theirs. Performers of a pair then stand one after the other, the one that leads first.
void pair_up(LibraryPlan& plan);

/// Gives takes the names that the label file has for them, where that is clear.
void name_like_labels(LibraryPlan& plan);

/// The other performer of its take; -1 when it has none or more than one.
int partner_of(const LibraryPlan& plan, int performer);

/// Puts a performer into a take (empty = none) and drops what was guessed.
void set_take(LibraryPlan& plan, int performer, const std::string& take);

/// Sets a role, and the partner's to what it then must be.
void set_role(LibraryPlan& plan, int performer, PlannedRole role);

/// Frames that are used of a performer's take: what both have from their starts on. 0 without a partner.
int used_frames(const LibraryPlan& plan, int performer);

struct PlanRemark {
  /// A question is what only a person knows and was guessed; an obstacle has to be out of the way before
  /// building.
  enum class Kind { Warning, Question, Obstacle };
  Kind kind = Kind::Warning;
  int performer = -1;  ///< -1 when it is about the whole
  std::string about;   ///< a file or take; may be empty
  std::string text;    ///< with what to change
  Hint hint = Hint::None;
  std::string whole() const { return about.empty() ? text : about + ": " + text; }
};
/// Obstacles first, then questions.
std::vector<PlanRemark> remarks_on(const LibraryPlan& plan);

/// One remark in place of several that say the same of different files: "60_01.amc and 13 more".
std::vector<PlanRemark> brought_together(const std::vector<PlanRemark>& remarks);

/// Every decision and every guess as it was shown, so that building it again gives the same library.
/// @throws std::invalid_argument while there are obstacles
Manifest manifest_of(const LibraryPlan& plan);

}  // namespace abrazo

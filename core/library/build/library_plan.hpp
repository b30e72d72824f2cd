#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/library/build/pairing_guess.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo {

/// Role of a performer in a take.
enum class PlannedRole { Either, Leads, Follows };

/// A performer of a motion file: how the file was read, and its planned use in a library.
struct PlannedPerformer {
  Manifest::Performer source;  ///< with the options that a person set; the others are detected
  std::optional<double> fps;   ///< set by a person, or detected
  std::string name;
  int in_the_file = 1;  ///< number of performers in the file
  ImportReport report;
  std::shared_ptr<const Clip> clip;  ///< whole; null when the file could not be read
  std::optional<Error> trouble;      ///< then why

  std::string take;  ///< two performers with the same name form the take; empty = not used
  PlannedRole role = PlannedRole::Either;
  std::optional<PairGuess> guess;  ///< why it is in its take; none if a person decided it

  int frames() const { return clip ? static_cast<int>(clip->poses.size()) : 0; }
};

/// A library to be built from motion files, while a person edits the plan.
struct LibraryPlan {
  std::string name = "library";
  std::filesystem::path labels;             ///< for all takes; empty = none
  std::vector<std::string> labelled_takes;  ///< takes named in the label file
  std::vector<PlannedPerformer> performers;
};

/// Reads a motion file as the plan says. One entry for each of its performers; a single one with `trouble`
/// when it cannot be read.
std::vector<PlannedPerformer> survey_motion(const Manifest::Performer& source, std::optional<double> fps,
                                            const Progress& progress = {});

/// Guesses the pairs among the readable performers without a take. Existing takes stay. The performers of a
/// pair are then adjacent, the leader first.
void pair_up(LibraryPlan& plan);

/// Renames takes to their names in the label file where the match is unambiguous.
void name_like_labels(LibraryPlan& plan);

/// The other performer of its take; -1 if there is none or more than one.
int partner_of(const LibraryPlan& plan, int performer);

/// Assigns a performer to a take (empty = none) and drops the guess.
void set_take(LibraryPlan& plan, int performer, const std::string& take);

/// Sets a role, and the partner's role accordingly.
void set_role(LibraryPlan& plan, int performer, PlannedRole role);

/// Number of used frames of a performer's take: those that both have after their start frames. 0 without a
/// partner.
int used_frames(const LibraryPlan& plan, int performer);

struct PlanRemark {
  /// Question: a guess that only a person can confirm. Obstacle: must be resolved before building.
  enum class Kind { Warning, Question, Obstacle };
  Kind kind = Kind::Warning;
  int performer = -1;  ///< -1 = about the whole plan
  std::string about;   ///< a file or take; may be empty
  std::string text;    ///< with what to change
  Hint hint = Hint::None;
  std::string whole() const { return about.empty() ? text : about + ": " + text; }
};
/// Obstacles first, then questions.
std::vector<PlanRemark> remarks_on(const LibraryPlan& plan);

/// Merges equal remarks about different files into one: "60_01.amc and 13 more".
std::vector<PlanRemark> brought_together(const std::vector<PlanRemark>& remarks);

/// The plan as a manifest, with every decision and guess, so that building it again gives the same library.
/// @throws std::invalid_argument while there are obstacles
Manifest manifest_of(const LibraryPlan& plan);

}  // namespace abrazo

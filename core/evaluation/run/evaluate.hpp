#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/evaluation/tables/evaluation.hpp"
#include "core/evaluation/takes/user_variant.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

enum class EvaluationPart { Selection, Timing, Moves, Zmp, Contact, Published, Bodies };

struct EvaluationOptions {
  std::set<EvaluationPart> parts;
  Settings settings;
  std::vector<std::string> hold_out;  ///< takes that are answered, each by the others; empty = all
  int queries = 1000;                 ///< poses drawn for Table I
  int largest_library = 1'000'000;    ///< pairs, for Table II
  bool variants = true;               ///< users of other builds and disturbed input, with Moves and Contact
  unsigned seed = 1;
};

/// The takes and their library, read once and used for any number of evaluations.
struct EvaluationData {
  std::string name;
  std::vector<PairedTake> takes;
  std::shared_ptr<const MotionLibrary> library;
  bool both_roles = false;
  std::string users_name;         ///< empty: the takes themselves are the users, left out one by one
  std::vector<PairedTake> users;  ///< takes of other people, answered by the whole library
  std::vector<std::string> warnings;
};

/// @param both_roles  either performer may be the active one in every frame, whatever the roles say: for
/// users who attack and defend in turn
/// @param users  null: leave one take out
Result<EvaluationData> read_evaluation_data(const Manifest& manifest, const Manifest* users, bool both_roles,
                                            const Progress& progress);

/// Checks `hold_out` against the manifests before their takes are read. An Error if a name is not among the
/// users' takes, or if the only take would be left out.
Status check_answered(const Manifest& manifest, const Manifest* users,
                      const std::vector<std::string>& hold_out);

/// The users' takes that are to be answered: `options.hold_out`, or all; an Error as `check_answered`.
Result<std::vector<const PairedTake*>> answered_takes(const EvaluationData& data,
                                                      const EvaluationOptions& options);

/// The paper's experiments and the further metrics. Takes are solved on every core.
Result<Evaluation> evaluate(const EvaluationData& data, const EvaluationOptions& options,
                            const Progress& progress);

}  // namespace abrazo

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/motion/body/clip.hpp"

namespace abrazo {

/// A performer of a motion file, with the properties that show who danced with whom.
struct LonePerformer {
  std::string file;             ///< path; performers of one file were captured together
  std::string name;             ///< of the performer, unique in the file
  std::string skeleton;         ///< path of its .asf; the same path means the same person. May be empty
  const Clip* clip = nullptr;   ///< never null
  std::size_t in_the_file = 1;  ///< number of performers in the file
};

enum class Confidence { Unsure, Likely, Sure };

/// Two performers that were probably captured together.
struct PairGuess {
  std::size_t a = 0, b = 0;  ///< indices; if roles are known, a is the active one
  bool roles_known = false;  ///< from words such as leader and follower
  std::string take;          ///< name, unique among the guesses
  double evidence = 0;       ///< 0 to 1
  std::string reason;        ///< "names differ in 60, 61; 2242 frames each; 0.62 m apart"
  Confidence confidence() const;
};

/// Pairs performers by the difference of their paths below the folder that all share (weight 0.5; one common
/// file counts as full evidence), their lengths (0.3) and their distance (0.2; median over the frames of the
/// horizontal distance of their roots). Where most files differ at one place in a way that names performers,
/// differences at other places are those of takes. No performer is in two pairs. The strongest evidence comes
/// first; below 0.4 nothing is guessed, unless there are only two performers. A guess is unsure where another
/// is nearly as good, where the bodies are in one another, where the shorter lacks much of the longer, and
/// where only words or numbers differ and most lengths do as well. Two with the same skeleton file or bone
/// lengths are most likely one person, unless all have these.
std::vector<PairGuess> guess_pairs(std::span<const LonePerformer> performers);

/// The .asf file that matches an .amc by name ("60_01.amc" -> "60.asf"), else the only one; empty if there is
/// none.
std::string guess_skeleton(const std::string& motion, std::span<const std::string> skeletons);

/// The name of a take in the label file: equal except for letter case and separators, or the only one with
/// the same last number ("01" -> "salsa_01"). Empty if there is none.
std::string guess_labelled_take(const std::string& take, std::span<const std::string> labelled);

}  // namespace abrazo

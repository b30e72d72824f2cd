#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/motion/body/clip.hpp"

namespace abrazo {

/// A performer that was found in a motion file, as far as it says who danced with whom.
struct LonePerformer {
  std::string file;             ///< path; two with the same were captured together
  std::string file_name;        ///< without folder and extension
  std::string name;             ///< of the performer; told from others of the file by it
  std::string skeleton;         ///< path of its .asf; two with the same are one person. May be empty
  const Clip* clip = nullptr;   ///< never null
  std::size_t in_the_file = 1;  ///< performers that the file shows
};

enum class Confidence { Unsure, Likely, Sure };

/// Two that seem to have been captured together.
struct PairGuess {
  std::size_t a = 0, b = 0;  ///< indices; where roles are known, a is the active one
  bool roles_known = false;  ///< by words such as leader and follower
  std::string take;          ///< a name, unique among the guesses
  double evidence = 0;       ///< 0 to 1
  std::string reason;        ///< "names differ in 60, 61; 2242 frames each; 0.62 m apart"
  Confidence confidence() const;
};

/// Pairs performers by what their names differ in (half of the evidence; being in one file counts as the
/// same), by their lengths (0.3), and by how near they are to one another (0.2; median over the frames of the
/// horizontal distance of their roots). Nobody is in two pairs. The strongest evidence goes first; below 0.4
/// nothing is guessed, except where there are two performers in all. Two with the same skeleton file or the
/// same bone lengths are most likely one person.
std::vector<PairGuess> guess_pairs(std::span<const LonePerformer> performers);

/// Of some .asf files the one that goes with an .amc by its name ("60_01.amc" -> "60.asf"), else the only
/// one; empty when there is none.
std::string guess_skeleton(const std::string& motion, std::span<const std::string> skeletons);

/// The label file's name of a take: the same but for letter case and separators, or the only one with the
/// same last number ("01" -> "salsa_01"). Empty when there is none.
std::string guess_labelled_take(const std::string& take, std::span<const std::string> labelled);

}  // namespace abrazo

#include "widgets/scene/view/scene_view_parts.hpp"

namespace abrazo::widgets {
namespace {

/// Measured from poses that are spread over the library.
std::array<Stance, 2> stances_of(const MotionLibrary& library) {
  constexpr int most_pairs = 400;
  const int step = std::max(1, library.pair_count() / most_pairs);
  std::array<std::vector<Pose>, 2> poses;
  for (int pair = 0; pair < library.pair_count(); pair += step) {
    const PairPose placed = library.pair_in_world(pair, library.root(pair));
    poses[0].push_back(placed.topRows<joint_count>());
    poses[1].push_back(placed.bottomRows<joint_count>());
  }
  return {stance_of(poses[0]), stance_of(poses[1])};
}

}  // namespace

const WornPair& SceneView::characters() const {
  return m_parts->characters;
}

void SceneView::setCharacters(const WornPair& characters,
                              const std::optional<std::array<Stance, 2>>& stances) {
  Parts& p = *m_parts;
  p.characters = characters;
  p.stances = stances;
  dressCharacters();
  refresh();
}

void SceneView::dressCharacters() {
  Parts& p = *m_parts;
  if (!p.characters[0] && !p.characters[1]) return p.actors.setCharacters({}, {});
  std::array<Stance, 2> stances{stance_of({}), stance_of({})};
  if (p.stances)
    stances = *p.stances;
  else if (p.library && p.library->pair_count() > 0)
    stances = stances_of(*p.library);
  p.actors.setCharacters(p.characters, stances);
}

}  // namespace abrazo::widgets

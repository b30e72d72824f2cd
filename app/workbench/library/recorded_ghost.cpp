#include "app/workbench/library/recorded_ghost.hpp"

namespace abrazo::app {

void RecordedGhost::begin(const MotionLibrary& library, int pair, const RootFrame& user_root,
                          bool user_is_passive) {
  m_recorded = library.root(pair);
  const PairPose first = library.pair_in_world(pair, user_root, user_is_passive);
  // The stored normalisation gives the root frame of the active body without computing a heading again.
  const Eigen::RowVector3d moved = first.row(0), before = library.pose(pair).row(0);
  m_shown = m_recorded;
  m_shown.heading_rad = user_root.heading_rad;
  if (user_is_passive) m_shown = root_frame(first.topRows<joint_count>());
  m_shown.position = moved.transpose() - m_shown.rotation() * before.transpose();
}

PairPose RecordedGhost::at(const MotionLibrary& library, int pair) const {
  const RootFrame& recorded = library.root(pair);
  const double turn = m_shown.heading_rad - m_recorded.heading_rad;
  const Eigen::Matrix3d rotation = RootFrame{Vec3::Zero(), turn}.rotation();
  RootFrame here;
  here.heading_rad = recorded.heading_rad + turn;
  here.position = m_shown.position + rotation * (recorded.position - m_recorded.position);
  return library.pair_in_world(pair, here);
}

}  // namespace abrazo::app

#include "widgets/scene/actors/scene_actors.hpp"

#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/capsules.hpp"
#include "core/motion/body/girth.hpp"
#include "core/motion/body/joint_set.hpp"
#include "widgets/scene/actors/ahead_lines.hpp"
#include "widgets/scene/values/body_light.hpp"

namespace abrazo::widgets {
namespace {

using Line = std::array<int, 2>;
using Rgba = std::array<unsigned char, 4>;

std::vector<Line> bone_lines(int first_vertex) {
  std::vector<Line> lines;
  lines.reserve(bone_count);
  for (int b = 0; b < bone_count; ++b)
    lines.push_back({first_vertex + bone(b).first, first_vertex + bone(b).second});
  return lines;
}

std::span<const double> coordinates(const PairPose& pair) {
  return {pair.data(), pair_vertex_count * 3};
}
std::span<const double> coordinates(const Pose& pose) {
  return {pose.data(), joint_count * 3};
}
std::span<const double> half(const PairPose& pair, std::size_t body) {
  return coordinates(pair).subspan(body * joint_count * 3, joint_count * 3);
}

/// Bones without a radius would leave holes in the drawn body; calibrated radii may be too thin to see.
CapsuleRadii drawn_radii(const CapsuleRadii& radii) {
  auto drawn = generic_capsule_radii();
  for (std::size_t b = 0; b < drawn.size(); ++b)
    drawn[b] = std::max({0.6 * drawn[b], radii[b], 0.045 * (drawn[b] == 0)});
  return drawn;
}

}  // namespace

SceneActors::SceneActors()
    : m_leader(BodyActor::Outline::Solid),
      m_follower(BodyActor::Outline::Dashed),
      m_joint_rims(LineSet::Kind::Dots),
      m_joints(LineSet::Kind::Dots) {
  m_user.setLines(bone_lines(0));
  for (auto* pair : {&m_selected, &m_candidate, &m_bones})
    for (LineSet& lines : *pair) lines.setLines(bone_lines(0));
  m_joints.setDots(pair_vertex_count);
  m_joint_rims.setDots(pair_vertex_count);
  const LibraryBody generic{"", {}, generic_capsule_radii()};
  setBodies(generic, generic);
}

/// Until the first frame. If they were hidden, the driver would compile them when it is shown.
void SceneActors::placeOutOfSight() {
  PairPose nowhere = PairPose::Zero();
  nowhere.col(1).setConstant(-1000);  // beyond all that a camera shows
  m_leader.setPose(nowhere.topRows<joint_count>(), 1);
  m_follower.setPose(nowhere.bottomRows<joint_count>(), 1);
  m_user.setPoints(half(nowhere, 0));
  for (std::size_t body = 0; body < 2; ++body)
    for (LineSet* lines : {&m_selected[body], &m_bones[body]}) lines->setPoints(half(nowhere, body));
  for (LineSet* dots : {&m_joints, &m_joint_rims}) dots->setPoints(coordinates(nowhere));
}

void SceneActors::addTo(vtkRenderer* solid, vtkRenderer* in_front, vtkRenderer* topmost) {
  m_floor.addTo(solid);
  m_leader.addTo(solid);
  m_follower.addTo(solid);
  for (SkinActor& skin : m_skins) skin.addTo(solid);
  m_locks.addTo(solid);
  m_mesh.addTo(solid, in_front);
  for (LineSet* lines : {&m_trail_lines, &m_ahead_lines, &m_morph, &m_user, &m_selected[0], &m_selected[1],
                         &m_bones[0], &m_bones[1], &m_candidate[0], &m_candidate[1], &m_joint_rims})
    lines->addTo(in_front);
  m_joints.addTo(topmost);
  m_contacts.addTo(in_front, topmost);
  m_reference.addTo(solid, in_front);
  m_cut.addTo(solid);
}

void SceneActors::setColours(const Palette& palette, double pixel_ratio) {
  m_palette = palette;
  m_floor.setColour(palette.grid, palette.dark);
  m_leader.setColour(palette.active);
  m_follower.setColour(palette.passive);
  m_skins[0].setColour(palette.active);
  m_skins[1].setColour(palette.passive);
  const auto style = [pixel_ratio](LineSet& lines, const QColor& colour, double width, double opacity) {
    lines.setColour(colour, opacity);
    lines.setWidth(width * pixel_ratio);
  };
  style(m_user, palette.user, 1.5, 0.9);
  const std::array<QColor, 2> ghosts = {palette.ghost_active, palette.ghost_passive};
  for (std::size_t body = 0; body < 2; ++body) {
    style(m_selected[body], ghosts[body], 2.2, 0.28);
    style(m_candidate[body], ghosts[body], 2.6, 0.95);
    style(m_bones[body], palette.dark ? QColor("#e9edf4") : QColor("#1d2026"), 1.2, 0.75);
  }
  style(m_morph, palette.text, 1.2, 1);
  style(m_locks, palette.good, 2.2, 1);
  style(m_trail_lines, palette.text, 2, 1);
  style(m_ahead_lines, palette.text, 1.5, 1);
  style(m_joint_rims, QColor("#14171c"), 7, 1);
  style(m_joints, Qt::white, 4.6, 1);
  m_mesh.setColours(palette, pixel_ratio);
  m_contacts.setColours(palette, pixel_ratio);
  m_reference.setColours(palette, pixel_ratio);
  m_cut.setColours(palette, pixel_ratio);
}

void SceneActors::setBodies(const LibraryBody& active, const LibraryBody& passive) {
  m_bodies = {active.body, passive.body};
  m_leader.setRadii(drawn_radii(active.capsule_radii));
  m_follower.setRadii(drawn_radii(passive.capsule_radii));
  m_contacts.setRadii(active.capsule_radii, passive.capsule_radii);
  if (!m_hasPose) placeOutOfSight();
}

double SceneActors::girthOf(std::size_t body, const Pose& shown, const Pose& recorded) const {
  const bool has_library = m_bodies[body].height() > 0;
  return girth(has_library ? m_bodies[body] : body_of(recorded), body_of(shown));
}

void SceneActors::setCharacters(const WornPair& characters, const std::array<Stance, 2>& stances) {
  for (std::size_t body = 0; body < 2; ++body) m_skins[body].wear(characters[body], stances[body]);
  setVisibility(m_visibility);
}

void SceneActors::setBodyVisible(std::size_t body, bool visible) {
  BodyActor& capsules = body == 0 ? m_leader : m_follower;
  capsules.setVisible(visible && !m_skins[body].wears());
  m_skins[body].setVisible(visible);
}

void SceneActors::setVisibility(const PartVisibility& visibility) {
  m_visibility = visibility;
  const auto shown = [&visibility](ScenePart part) { return visibility[static_cast<std::size_t>(part)]; };
  m_user.setVisible(shown(ScenePart::User));
  setBodyVisible(0, shown(ScenePart::Leader));
  setBodyVisible(1, shown(ScenePart::Follower));
  for (std::size_t body = 0; body < 2; ++body) {
    m_selected[body].setVisible(shown(ScenePart::SelectedPair));
    m_bones[body].setVisible(shown(ScenePart::Bones));
    m_candidate[body].setVisible(m_hasCandidate);
  }
  m_mesh.setVisibility(visibility);
  m_morph.setVisible(shown(ScenePart::MorphSteps));
  m_trail_lines.setVisible(shown(ScenePart::Trails));
  m_ahead_lines.setVisible(shown(ScenePart::LookAhead));
  m_locks.setVisible(shown(ScenePart::FootLocks));
  m_contacts.setVisible(shown(ScenePart::Contacts), shown(ScenePart::Touches));
  m_joints.setVisible(shown(ScenePart::Joints));
  m_joint_rims.setVisible(shown(ScenePart::Joints));
  m_floor.setVisible(shown(ScenePart::Floor));
  setReferenceOffset(m_reference_offset);
}

void SceneActors::setReferenceOffset(const Vec3& offset) {
  m_reference_offset = offset;
  const auto shown = [this](ScenePart part) { return m_visibility[static_cast<std::size_t>(part)]; };
  m_reference.setVisible(!offset.isZero(), shown(ScenePart::MeshBetween), shown(ScenePart::MeshWithin));
}

void SceneActors::sortFor(const Vec3& eye, const Vec3& direction) {
  m_mesh.sortFor(eye, direction);
  const BodyLight light(direction);
  m_leader.lightFor(light);
  m_follower.lightFor(light);
  for (SkinActor& skin : m_skins) skin.lightFor(light);
  m_contacts.outlineFor(direction);
}

void SceneActors::show(const FrameSnapshot& frame, const MeshLook& look) {
  m_hasPose = true;
  const FrameResult& result = frame.result;
  // Exploded cells are seen alone, with the bones that tell where they were.
  const auto is_on = [this](ScenePart part) { return m_visibility[static_cast<std::size_t>(part)]; };
  const bool exploded = look.apart > 0 && is_on(ScenePart::Tetrahedra);
  setBodyVisible(0, is_on(ScenePart::Leader) && !exploded);
  setBodyVisible(1, is_on(ScenePart::Follower) && !exploded);
  for (LineSet& bones : m_bones) bones.setVisible(is_on(ScenePart::Bones) || exploded);
  const std::array<double, 2> girths = {
      girthOf(0, result.active(), result.selected_pair.topRows<joint_count>()),
      girthOf(1, result.passive(), result.selected_pair.bottomRows<joint_count>())};
  m_leader.setPose(result.active(), girths[0]);
  m_follower.setPose(result.passive(), girths[1]);
  m_skins[0].setPose(result.active(), frame.time_s);
  m_skins[1].setPose(result.passive(), frame.time_s);
  m_user.setPoints(coordinates(frame.user));
  for (std::size_t body = 0; body < 2; ++body) {
    m_selected[body].setPoints(half(result.selected_pair, body));
    m_bones[body].setPoints(half(result.result, body));
  }
  m_joints.setPoints(coordinates(result.result));
  m_joint_rims.setPoints(coordinates(result.result));
  m_mesh.show(result, look);
  if (m_visibility[static_cast<std::size_t>(ScenePart::MorphSteps)]) showMorphSteps(result);
  m_trails.add(frame.time_s, result.result);
  if (m_visibility[static_cast<std::size_t>(ScenePart::Trails)]) showTrails();
  showFootLocks(result);
  m_contacts.show(result, girths);
  if (!m_reference_offset.isZero()) m_reference.show(result, m_mesh, m_reference_offset);
  showShadows(result);
  const auto count = [this](ScenePart part, std::size_t number) {
    m_counts[static_cast<std::size_t>(part)] = static_cast<int>(number);
  };
  count(ScenePart::MeshBetween, m_mesh.betweenCount());
  count(ScenePart::MeshWithin, result.edges.size() - m_mesh.betweenCount());
  count(ScenePart::Tetrahedra, result.tetrahedra.size());
  count(ScenePart::Bones, 2 * (bone_count + pseudo_bones.size()));
  count(ScenePart::Joints, pair_vertex_count);
  count(ScenePart::FootLocks, result.foot_locks.size());
  count(ScenePart::Contacts, result.collisions.size());
  count(ScenePart::Touches, m_contacts.touchCount());
  count(ScenePart::Trails, m_trail_joints.size());
  count(ScenePart::MorphSteps, result.morph_steps.size());
}

void SceneActors::showMorphSteps(const FrameResult& result) {
  std::vector<double> points;
  std::vector<Line> lines;
  std::vector<Rgba> colours;
  for (std::size_t step = 0; step < result.morph_steps.size(); ++step) {
    const auto xyz = coordinates(result.morph_steps[step]);
    points.insert(points.end(), xyz.begin(), xyz.end());
    const auto alpha = static_cast<unsigned char>(60 + 150 * (step + 1) / result.morph_steps.size());
    for (const int body : {0, 1}) {
      const QColor& colour = body == 0 ? m_palette.ghost_active : m_palette.ghost_passive;
      for (const Line& line : bone_lines(static_cast<int>(step) * pair_vertex_count + body * joint_count)) {
        lines.push_back(line);
        colours.push_back({static_cast<unsigned char>(colour.red()),
                           static_cast<unsigned char>(colour.green()),
                           static_cast<unsigned char>(colour.blue()), alpha});
      }
    }
  }
  m_morph.setPoints(points);
  m_morph.setLines(lines);
  m_morph.setCellColours(colours);
}

void SceneActors::showTrails() {
  constexpr double strength = 0.92;
  drawTrails(m_trails.lines_of(m_trail_joints), m_trail_lines, strength);
}

void SceneActors::showAhead(std::span<const Pose> poses, int first_vertex) {
  constexpr double strength = 0.7;  // fainter than the trails of the past: it is a prediction
  drawTrails(ahead_lines(poses, first_vertex), m_ahead_lines, strength);
  const double seconds = poses.empty() ? 0 : static_cast<double>(poses.size() - 1) * ahead_step_s;
  m_counts[static_cast<std::size_t>(ScenePart::LookAhead)] = static_cast<int>(std::lround(1000 * seconds));
}

/// In the colours of the bodies, fading with age.
void SceneActors::drawTrails(const JointTrails::Lines& trails, LineSet& lines, double strength) {
  std::vector<Rgba> colours;
  for (std::size_t l = 0; l < trails.lines.size(); ++l) {
    const QColor& colour = trails.vertex[l] < joint_count ? m_palette.active : m_palette.passive;
    colours.push_back({static_cast<unsigned char>(colour.red()), static_cast<unsigned char>(colour.green()),
                       static_cast<unsigned char>(colour.blue()),
                       static_cast<unsigned char>(std::lround(255 * strength * (1 - trails.age[l])))});
  }
  lines.setPoints(trails.xyz);
  lines.setLines(trails.lines);
  lines.setCellColours(colours);
}

void SceneActors::showFootLocks(const FrameResult& result) {
  constexpr int segments = 24;
  constexpr double radius_m = 0.10;
  std::vector<double> points;
  std::vector<Line> lines;
  for (const FootLock& lock : result.foot_locks) {
    const int vertex =
        (lock.active_body ? 0 : joint_count) + (lock.left ? joints::left_toe_base : joints::right_toe_base);
    const int first = static_cast<int>(points.size() / 3);
    for (int s = 0; s < segments; ++s) {
      const double angle = 2 * 3.14159265358979 * s / segments;
      points.insert(points.end(), {result.result(vertex, 0) + radius_m * std::cos(angle), 0.004,
                                   result.result(vertex, 2) + radius_m * std::sin(angle)});
      lines.push_back({first + s, first + (s + 1) % segments});
    }
  }
  m_locks.setPoints(points);
  m_locks.setLines(lines);
}

void SceneActors::showShadows(const FrameResult& result) {
  std::vector<FloorActor::Shadow> shadows;
  const double darkness = m_palette.dark ? 0.42 : 0.20;
  for (const int body : {0, 1}) {
    const auto at = [&](int joint) { return Vec3(result.result.row(body * joint_count + joint)); };
    shadows.push_back({at(joints::Root), 0.42, darkness});
    for (const int foot : {joints::left_toe_base, joints::right_toe_base}) {
      const double height = std::max(0.0, at(foot).y());
      shadows.push_back({at(foot), 0.13 + 0.3 * height, 1.2 * darkness / (1 + 8 * height)});
    }
  }
  m_floor.setCentre(0.5 * (Vec3(result.result.row(0)) + Vec3(result.result.row(joint_count))));
  m_floor.setShadows(shadows);
}

void SceneActors::showCandidate(const std::optional<PairPose>& pair) {
  m_hasCandidate = pair.has_value();
  for (std::size_t body = 0; body < 2; ++body) {
    if (pair) m_candidate[body].setPoints(half(*pair, body));
    m_candidate[body].setVisible(m_hasCandidate);
  }
}

}  // namespace abrazo::widgets

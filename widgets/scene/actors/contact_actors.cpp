#include "widgets/scene/actors/contact_actors.hpp"

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {
namespace {

using Line = std::array<int, 2>;
using Rgba = std::array<unsigned char, 4>;

Rgba rgba(const QColor& colour, int alpha) {
  return {static_cast<unsigned char>(colour.red()), static_cast<unsigned char>(colour.green()),
          static_cast<unsigned char>(colour.blue()), static_cast<unsigned char>(alpha)};
}

void add(std::vector<double>& points, const Vec3& point) {
  points.insert(points.end(), {point.x(), point.y(), point.z()});
}

}  // namespace

ContactActors::ContactActors() {
  m_outlines.setVisible(true);
}

void ContactActors::addTo(vtkRenderer* in_front, vtkRenderer* topmost) {
  for (LimbActor& body : m_bodies) body.addTo(in_front);
  m_outlines.addTo(in_front);
  m_holds.addTo(topmost);
  m_touches.addTo(topmost);
  m_lines.addTo(topmost);
  m_dots.addTo(topmost);
}

void ContactActors::setColours(const Palette& palette, double pixel_ratio) {
  m_palette = palette;
  m_bodies[0].setColour(palette.active, 0.30);
  m_bodies[1].setColour(palette.passive, 0.30);
  m_outlines.setColour(palette.text, 0.9);
  m_outlines.setWidth(2 * pixel_ratio);
  m_lines.setWidth(3 * pixel_ratio);
  m_dots.setWidth(7 * pixel_ratio);
  m_holds.setColour(palette.good, 1);
  m_holds.setWidth(4 * pixel_ratio);
  m_touches.setColour(palette.good, 1);
  m_touches.setWidth(8 * pixel_ratio);
}

void ContactActors::setRadii(const CapsuleRadii& active, const CapsuleRadii& passive) {
  m_radii = {active, passive};
  for (std::size_t body = 0; body < 2; ++body) m_bodies[body].setRadii(m_radii[body]);
}

void ContactActors::setVisible(bool collisions, bool touches) {
  m_visible = collisions;
  for (LimbActor& body : m_bodies) body.setVisible(collisions);
  for (LineSet* lines : {&m_outlines, &m_lines, &m_dots}) lines->setVisible(collisions);
  for (LineSet* lines : {&m_holds, &m_touches}) lines->setVisible(touches);
}

void ContactActors::show(const FrameResult& frame, const std::array<double, 2>& girths) {
  const auto bones = colliding_bones(frame);
  m_limbs.clear();
  for (std::size_t body = 0; body < 2; ++body) {
    const Pose pose = body == 0 ? Pose(frame.active()) : Pose(frame.passive());
    m_bodies[body].show(bones[body], pose, girths[body]);
    for (const int b : bones[body]) {
      const auto [from, to] = bone(b);
      m_limbs.push_back({pose.row(from).transpose(), pose.row(to).transpose(),
                         girths[body] * m_radii[body][static_cast<std::size_t>(b)]});
    }
  }
  std::vector<double> points;
  std::vector<Line> lines;
  std::vector<Rgba> colours;
  for (const ContactLine& contact : contact_lines(frame)) {
    const int first = static_cast<int>(points.size() / 3);
    add(points, contact.on_leader);
    add(points, contact.on_follower);
    lines.push_back({first, first + 1});
    // Deeper than the recorded pair is a fault; as deep as recorded is a touch.
    colours.push_back(rgba(contact.is_excess() ? m_palette.live : m_palette.warning, 255));
  }
  m_lines.setPoints(points);
  m_lines.setLines(lines);
  m_lines.setCellColours(colours);
  std::vector<Rgba> ends;
  for (const Rgba& colour : colours) ends.insert(ends.end(), 2, colour);
  m_dots.setPoints(points);
  m_dots.setDots(static_cast<int>(ends.size()));
  m_dots.setCellColours(ends);
  showTouches(frame);
}

void ContactActors::showTouches(const FrameResult& frame) {
  const auto vertex = [&frame](int v) { return Vec3(frame.result.row(v).transpose()); };
  std::vector<double> holds, dots;
  std::vector<Line> lines;
  for (const auto& [leader, follower] : held_hands(frame)) {
    const int first = static_cast<int>(holds.size() / 3);
    for (const int hand : {leader, follower}) add(holds, vertex(hand));
    lines.push_back({first, first + 1});
  }
  const std::vector<int> standing = floor_contacts(frame.result);
  for (const int toe : standing) {
    Vec3 below = vertex(toe);
    below.y() = 0;
    add(dots, below);
  }
  dots.insert(dots.end(), holds.begin(), holds.end());
  m_holds.setPoints(holds);
  m_holds.setLines(lines);
  m_touches.setPoints(dots);
  m_touches.setDots(static_cast<int>(dots.size() / 3));
  m_touch_count = lines.size() + standing.size();
}

void ContactActors::outlineFor(const Vec3& direction) {
  if (!m_visible) return;
  std::vector<double> points;
  std::vector<Line> lines;
  for (const Limb& limb : m_limbs) {
    const auto outline = capsule_outline(limb.from, limb.to, limb.radius_m, direction);
    const int first = static_cast<int>(points.size() / 3), count = static_cast<int>(outline.size());
    for (const Vec3& point : outline) add(points, point);
    for (int p = 0; p < count; ++p) lines.push_back({first + p, first + (p + 1) % count});
  }
  m_outlines.setPoints(points);
  m_outlines.setLines(lines);
}

}  // namespace abrazo::widgets

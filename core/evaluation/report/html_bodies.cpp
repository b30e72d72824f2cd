#include <fmt/format.h>

#include <algorithm>

#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/report/html_sections.hpp"

namespace abrazo {

namespace {

std::vector<std::string> body_cells(std::string_view name, const BodyFigures& figures) {
  const auto score = [](const ContactScore& contact) {
    return fmt::format("{:.2f} / {:.2f} / {:.3f}", contact.precision, contact.recall, contact.f1);
  };
  const auto posture = [](const PostureChange& change) {
    return fmt::format("{:.2f}, {:+.1f}\u00b0, {:+.1f}\u00b0", change.pelvis, change.knee_deg,
                       change.trunk_deg);
  };
  return {std::string(name),
          posture(figures.posture[0]),
          posture(figures.posture[1]),
          score(figures.within_15cm),
          score(figures.within_25cm),
          number_text(1000 * figures.hold_change_mean_m) + " mm",
          number_text(1000 * figures.penetration_excess_p99_m) + " mm",
          fmt::format("{:.1f} %", 100 * figures.floor_contact),
          number_text(figures.slide_ratio),
          number_text(figures.speed_p99_ratio),
          number_text(figures.acceleration_p99_ratio),
          fmt::format("{:.3f} %", 100 * figures.bone_error_max)};
}

std::string bodies_of_row(const BodyRow& row) {
  HtmlTable html("Bodies as a ratio of the recorded lengths: " + row.bodies + ".",
                 {"method", "posture of the active body: pelvis, knees, trunk", "of the passive body",
                  "contacts within 15 cm: precision / recall / F1", "within 25 cm", "change of holds, mean",
                  "penetration beyond the recording's, p99", "feet on the floor", "sliding", "speed, p99",
                  "acceleration, p99", "bone error"});
  for (std::size_t m = 0; m < row.methods.size(); ++m)
    html.row(body_cells(body_method_names[m], row.methods[m]),
             m <= 1 ? HtmlTable::Row::Own : HtmlTable::Row::Baseline);
  return html.html();
}

std::string bodies_finding(const BodyTable& bodies) {
  double worst_f1 = 1, worst_hold_m = 0;
  for (const BodyRow& row : bodies.rows)
    if (row.has_marks) {
      worst_f1 = std::min(worst_f1, row.methods.front().within_25cm.f1);
      worst_hold_m = std::max(worst_hold_m, row.methods.front().hold_change_mean_m);
    }
  return fmt::format(
      "On bodies of 85 to 115 % of the recorded size, joints within 25 cm of one another are the recorded "
      "ones "
      "with an F1 of at least {:.3f}, and hands that hold one another change their distance by {} mm on "
      "average "
      "at most.",
      worst_f1, number_text(1000 * worst_hold_m));
}

}  // namespace

std::optional<HtmlSection> bodies_section(const Evaluation& evaluation) {
  if (!evaluation.bodies || evaluation.bodies->rows.empty()) return std::nullopt;
  const BodyTable& bodies = *evaluation.bodies;
  std::string content = html_finding(bodies_finding(bodies));
  for (const BodyRow& row : bodies.rows) content += bodies_of_row(row);
  content += html_definitions(
      {"Posture: height of the pelvis over the recorded one, in proportion to the legs; changes of the "
       "angles "
       "of the knees (negative: more bent) and of the trunk against the vertical. Means over the frames.",
       "Recorded pairs on other bodies, whole takes. Live: as the solver shows a pair on other bodies, frame "
       "by "
       "frame without the future; the active pose is given. Joint angles copied: bones keep their "
       "directions, the "
       "common "
       "path is scaled by the mean ratio of the legs. Mesh of the paper: the active body retargeted alone, "
       "the "
       "recorded pair edited to it frame after frame. No mesh: inverse kinematics brings feet to their steps "
       "and "
       "hands to where the recording has them, scaled as the path is.",
       "Contact: two joints of different bodies within that distance; the recording's are the truth. Hold: "
       "hand "
       "ends within 13 cm in the recording. Penetration: what two capsules overlap more than those of the "
       "recorded bodies do. Feet on the floor: share of standing feet within 2 cm of their recorded height, "
       "in "
       "proportion to the legs.",
       "Sliding, speed and acceleration: over the recording's; the last two are divided by the ratio of the "
       "legs "
       "first."});
  return HtmlSection{"bodies", "Beyond the paper \u2014 recorded pairs on other bodies", "Bodies", content};
}

}  // namespace abrazo

#include <fmt/format.h>

#include "core/base/units.hpp"
#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_plot.hpp"
#include "core/evaluation/report/html_sections.hpp"

namespace abrazo {

namespace {

std::string cm_text(double metres) {
  return small_number(metres * cm_per_m, 0.01) + " cm";
}

std::string contact_table(const ContactTable& contact) {
  HtmlTable html("Contact.", {"figure", "original", "synthesised"});
  html.row({"holds in the selected pairs", "", number_text(contact.holds.holds, 1)})
      .row({"change of hold distance, mean", "", cm_text(contact.holds.change_mean_m)})
      .row({"change of hold distance, 95th percentile", "", cm_text(contact.holds.change_p95_m)})
      .row({"holds kept", "", percent_text(contact.holds.holds > 0 ? contact.holds.kept : not_known)})
      .row({"precision of holds", "",
            percent_text(contact.holds.shown_holds > 0 ? contact.holds.precision : not_known)})
      .row({"F1 of holds", "", percent_text(contact.holds.holds > 0 ? contact.holds.f1 : not_known)})
      .row({"frames with penetration deeper than 1 cm", percent_text(contact.original_penetration.deep_share),
            percent_text(contact.penetration.deep_share)})
      .row({"deepest penetration of a frame, mean", cm_text(contact.original_penetration.mean_m),
            cm_text(contact.penetration.mean_m)})
      .row({"deepest penetration of a frame, 99th percentile", cm_text(contact.original_penetration.p99_m),
            cm_text(contact.penetration.p99_m)})
      .row({"penetration beyond the selected pair's own, 99th percentile", "",
            cm_text(contact.penetration.excess_p99_m)})
      .row({"penetration beyond the selected pair's own, largest", "",
            cm_text(contact.penetration.excess_max_m)})
      .row({"sliding of the partner's landed feet, mean", cm_text(contact.original_foot_slide_m_s) + "/s",
            cm_text(contact.foot_slide_m_s) + "/s"})
      .row({"sliding of the user's character's landed feet, mean", "",
            cm_text(contact.user_foot_slide_m_s) + "/s"})
      .row({"bone length error, largest", "", percent_text(contact.bone_length_max, 4)})
      .row({"drift of a locked foot, largest", "",
            small_number(contact.foot_lock_drift_max_m * 1000, 0.01) + " mm"});
  return html.html();
}

std::string partner_table(const PartnerTable& partner) {
  const ContinuityMetric::Figures &own = partner.continuity, &original = partner.original_continuity;
  HtmlTable html("The partner against the captured partner.", {"figure", "original", "synthesised"});
  const auto both = [&](const std::string& name, double original_m, double own_m) {
    html.row({name, cm_text(original_m), cm_text(own_m)});
  };
  html.row({"joint error, mean over steps", "", cm_text(partner.mean_joint_error_m)})
      .row({"joint error, median", "", cm_text(partner.median_joint_error_m)})
      .row({"joint error, 95th percentile", "", cm_text(partner.p95_joint_error_m)})
      .row({"lag", "", number_text(partner.lag_s * ms_per_s) + " ms"})
      .row({"correlation at that lag", "", number_text(partner.lag_correlation, 2)})
      .row({"displacement from the selected pair's partner, mean", "",
            cm_text(partner.behind_selected_mean_m)})
      .row({"changes of source per 100 steps", "", number_text(own.source_changes_per_100)});
  both("displacement a step, mean", original.displacement_mean_m, own.displacement_mean_m);
  both("displacement a step, 95th percentile", original.displacement_p95_m, own.displacement_p95_m);
  both("displacement a step, 99th percentile", original.displacement_p99_m, own.displacement_p99_m);
  both("displacement a step, largest", original.displacement_max_m, own.displacement_max_m);
  both("second difference, mean", original.second_difference_mean_m, own.second_difference_mean_m);
  both("second difference, 99th percentile", original.second_difference_p99_m, own.second_difference_p99_m);
  return html.html();
}

std::string solve_table(const SolveTimes& solve) {
  HtmlTable html(
      "Time of one whole step, retargeting to result, while takes are solved on every core at once.",
      {"median", "95th percentile", "99th percentile", "steps", "relaxed", "failed"});
  html.row({number_text(solve.p50_us / us_per_ms) + " ms", number_text(solve.p95_us / us_per_ms) + " ms",
            number_text(solve.p99_us / us_per_ms) + " ms", number_text(solve.steps, 1),
            number_text(solve.relaxed, 1), number_text(solve.failed, 1)});
  return html.html();
}

std::string continuity_bars(const PartnerTable& partner) {
  const ContinuityMetric::Figures &own = partner.continuity, &original = partner.original_continuity;
  return svg_bar_plot(
      {.title = "How the partner moves from step to step",
       .value = {.title = "mean over the joints (cm)", .minimum = 0},
       .groups = {"displacement, mean", "displacement, p95", "displacement, p99", "second difference, mean",
                  "second difference, p99"},
       .series = {
           {.name = "captured partner",
            .values = {cm_per_m * original.displacement_mean_m, cm_per_m * original.displacement_p95_m,
                       cm_per_m * original.displacement_p99_m, cm_per_m * original.second_difference_mean_m,
                       cm_per_m * original.second_difference_p99_m}},
           {.name = "synthesised",
            .values = {cm_per_m * own.displacement_mean_m, cm_per_m * own.displacement_p95_m,
                       cm_per_m * own.displacement_p99_m, cm_per_m * own.second_difference_mean_m,
                       cm_per_m * own.second_difference_p99_m}}}});
}

std::string contact_bars(const ContactTable& contact) {
  return svg_bar_plot(
      {.title = "Contact",
       .value = {.title = "cm, sliding in cm/s", .minimum = 0},
       .groups = {"change of holds, mean", "penetration, p99", "penetration beyond the pair's own, p99",
                  "sliding feet"},
       .series = {
           {.name = "captured partner",
            .values = {std::nullopt, cm_per_m * contact.original_penetration.p99_m, std::nullopt,
                       cm_per_m * contact.original_foot_slide_m_s}},
           {.name = "synthesised",
            .values = {cm_per_m * contact.holds.change_mean_m, cm_per_m * contact.penetration.p99_m,
                       cm_per_m * contact.penetration.excess_p99_m, cm_per_m * contact.foot_slide_m_s}}}});
}

std::vector<std::string> contact_notes(const Evaluation& evaluation) {
  const PartnerTable& partner = evaluation.result->partner;
  const ContinuityMetric::Figures &own = partner.continuity, &original = partner.original_continuity;
  std::vector<std::string> notes;
  notes.push_back(
      fmt::format("The source changes {} times in 100 steps. A step of the partner is {} in the 99th "
                  "percentile, {} times the captured partner's.",
                  number_text(own.source_changes_per_100), cm_text(own.displacement_p99_m),
                  number_text(share_of(own.displacement_p99_m, original.displacement_p99_m), 2)));
  if (evaluation.settings.velocity_weight > 0)
    notes.push_back(fmt::format(
        "The velocity energy (w_\u0394 = {}) smooths what selection makes jump, at a price: it holds the "
        "partner back where it was. The partner is on average {} from where the selected pair has it; "
        "editing to the user's own pose has a part in that.",
        plain_number(evaluation.settings.velocity_weight), cm_text(partner.behind_selected_mean_m)));
  if (partner.lag_correlation < 0.3)
    notes.push_back(
        fmt::format("The velocities of captured and synthesised partner correlate only by {}, so the lag of "
                    "{} ms says little.",
                    number_text(partner.lag_correlation, 2), number_text(partner.lag_s * ms_per_s)));
  notes.emplace_back(
      "Joint error is no mark for quality by itself: the user's pose alone often fits several moves of the "
      "partner, and another valid answer counts as an error here. It shows when something got worse.");
  return notes;
}

std::string contact_finding(const Evaluation& evaluation) {
  const UserResult& result = *evaluation.result;
  std::string holds;
  if (evaluation.has_contact && result.contact.holds.holds == 0)
    holds = "No hands hold one another in the selected pairs. ";
  else if (evaluation.has_contact)
    holds = fmt::format(
        "Hands that hold one another in the selected pair change their distance by {} on average, {} of the "
        "holds are kept. ",
        cm_text(result.contact.holds.change_mean_m), percent_text(result.contact.holds.kept));
  return holds + fmt::format(
                     "The synthesised partner's joints are on average {} from the captured partner's (median "
                     "{}), with a lag of {} ms. One step takes {} ms (99th percentile {} ms).",
                     cm_text(result.partner.mean_joint_error_m), cm_text(result.partner.median_joint_error_m),
                     number_text(result.partner.lag_s * ms_per_s),
                     number_text(result.solve.p50_us / us_per_ms),
                     number_text(result.solve.p99_us / us_per_ms));
}

std::vector<std::string> contact_definitions(const Evaluation& evaluation) {
  std::vector<std::string> texts;
  if (evaluation.has_contact)
    texts = {
        "Hold: hand ends of different bodies within 13 cm in the selected pair. Its change: |distance in the "
        "result \u2212 distance in the selected pair|. Kept: within 16 cm in the result. Precision: the "
        "share of holds of the result that are within 16 cm in the selected pair; F1: harmonic mean of both.",
        "Penetration: deepest overlap of two capsules of different bodies; radii are calibrated for each "
        "body; hands and forearms that hold one another are left out. Beyond the pair's own: what the "
        "same two capsules overlap more than in the selected pair. Sliding: mean horizontal speed of toe "
        "bases less than 3 cm above their rest, the 5th percentile of the captured foot's height, over all "
        "takes together; captured feet pivot and brush, so zero is not the aim. Radii are those of the "
        "bodies that a result has, for result and capture alike."};
  texts.emplace_back(
      "Joint error: mean over 25 joints of the distance to the captured partner in world space. Lag: time "
      "shift at which the joint velocities of captured and synthesised partner correlate best, mean over the "
      "takes by length. Displacement and second difference: mean over the joints, from step to step; not "
      "across failed steps.");
  texts.emplace_back(
      "Relaxed: constraints contradicted one another, and some were relaxed in a fixed order. Failed: the "
      "last good pose was held.");
  return texts;
}

}  // namespace

std::optional<HtmlSection> contact_section(const Evaluation& evaluation) {
  if (!evaluation.result) return std::nullopt;
  const UserResult& result = *evaluation.result;
  const bool contact = evaluation.has_contact;
  return HtmlSection{
      "beyond", "Beyond the paper \u2014 contact, continuity, lag and time", "Beyond",
      html_finding(contact_finding(evaluation)) +
          html_side_by_side({contact ? contact_table(result.contact) : "", partner_table(result.partner)}) +
          solve_table(result.solve) +
          html_figures({contact ? contact_bars(result.contact) : "", continuity_bars(result.partner)}) +
          html_notes("Reading it", contact_notes(evaluation)) +
          html_definitions(contact_definitions(evaluation))};
}

}  // namespace abrazo

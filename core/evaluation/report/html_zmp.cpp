#include <fmt/format.h>

#include "core/base/units.hpp"
#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_plot.hpp"
#include "core/evaluation/report/html_paper.hpp"
#include "core/evaluation/report/html_sections.hpp"
#include "core/metrics/zmp.hpp"

namespace abrazo {

namespace {

std::string rounded_cm_text(double metres) {
  return number_text(metres * cm_per_m) + " cm";
}

std::string zmp_table(const ZmpTable& zmp) {
  HtmlTable html("Mean distance of the zero moment point from the support polygon, per frame.",
                 {"motion", "original (cm)", "synthesised (cm)", "original (ASF units)",
                  "synthesised (ASF units)", "synthesised / original"});
  for (const paper::ZmpRow& row : paper::table_4)
    html.row({"paper: " + std::string(row.motion) + " (no unit printed)", "", "", fixed_text(row.original, 2),
              fixed_text(row.synthesised, 2), number_text(row.synthesised / row.original, 4)},
             HtmlTable::Row::Paper);
  const auto own = [&](const std::string& name, double original_m, double synthesised_m) {
    html.row({name, number_text(original_m * cm_per_m), number_text(synthesised_m * cm_per_m),
              number_text(original_m / metres_per_asf_unit), number_text(synthesised_m / metres_per_asf_unit),
              number_text(share_of(synthesised_m, original_m), 4)});
  };
  own("both bodies", zmp.original_m, zmp.synthesised_m);
  own("the partner alone", zmp.original_partner_m, zmp.synthesised_partner_m);
  own("both bodies, frames that count in both motions", zmp.common.first_m, zmp.common.second_m);
  own("the partner alone, frames that count in both motions", zmp.common_partner.first_m,
      zmp.common_partner.second_m);
  if (zmp.between_changes_share > 0)
    own(fmt::format("the partner between changes of source ({} of the steps)",
                    percent_text(zmp.between_changes_share, 0)),
        zmp.original_between_changes_m, zmp.partner_between_changes_m);
  return html.html();
}

std::string zmp_bars(const ZmpTable& zmp) {
  BarPlot plot{.title = "ZMP error",
               .value = {.title = "mean distance (ASF units, 1 = 5.64 cm)", .minimum = 0},
               .groups = {"both bodies", "partner alone"},
               .series = {{.name = "original",
                           .values = {zmp.original_m / metres_per_asf_unit,
                                      zmp.original_partner_m / metres_per_asf_unit}},
                          {.name = "synthesised",
                           .values = {zmp.synthesised_m / metres_per_asf_unit,
                                      zmp.synthesised_partner_m / metres_per_asf_unit}}}};
  for (const paper::ZmpRow& row : paper::table_4) {
    plot.groups.push_back("paper: " + std::string(row.motion));
    plot.series[0].values.emplace_back(row.original);
    plot.series[1].values.emplace_back(row.synthesised);
  }
  return svg_bar_plot(plot);
}

std::vector<std::string> zmp_notes(const Evaluation& evaluation, const ZmpTable& zmp) {
  const Style style = style_of(evaluation);
  std::vector<std::string> notes;
  for (const paper::ZmpRow& row : paper::table_4) {
    if (!(row.motion == "fighting" ? style.fight : style.dance)) continue;
    notes.push_back(
        fmt::format("{}: the ratio is {} here and {} in the paper; the originals' error is {} ASF units here "
                    "and {} there.",
                    row.motion == "fighting" ? "Fighting" : "Dance",
                    number_text(share_of(zmp.synthesised_m, zmp.original_m), 3),
                    number_text(row.synthesised / row.original, 3),
                    number_text(zmp.original_m / metres_per_asf_unit, 2), fixed_text(row.original, 2)));
  }
  if (const int left_out = zmp.partner_free_fall + zmp.partner_no_support; left_out > 0)
    notes.push_back(fmt::format(
        "Of the partner's frames {} are left out: in {} (captured {}) too little presses on the floor for "
        "the point to be defined, in {} (captured {}) no foot is near it. Those are the worst ones. Over the "
        "frames that count in both motions the partner's ratio is {}.",
        percent_text(share_of(left_out, zmp.partner_frames + left_out)),
        number_text(zmp.partner_free_fall, 1), number_text(zmp.original_partner_free_fall, 1),
        number_text(zmp.partner_no_support, 1), number_text(zmp.original_partner_no_support, 1),
        number_text(share_of(zmp.common_partner.second_m, zmp.common_partner.first_m), 3)));
  const double partner = share_of(zmp.synthesised_partner_m, zmp.original_partner_m);
  const double between = share_of(zmp.partner_between_changes_m, zmp.original_between_changes_m);
  if (zmp.between_changes_share > 0 && partner - between > 0.02)
    notes.push_back(
        fmt::format("Jumps from one recorded pair to another have a part in the partner's error: in the "
                    "stretches without a change of source its ratio is {} instead of {}.",
                    number_text(between, 3), number_text(partner, 3)));
  notes.emplace_back(
      "The paper prints no unit. In metres its 0.70 would put the zero moment point far outside any foot; in "
      "the unit of the CMU skeleton files (1 = 5.644 cm) it is 4 cm. The ratios can be compared for any "
      "unit, the values only if that guess is right.");
  notes.emplace_back(
      "The value depends much on the rate and on how accelerations are smoothed, and the paper names "
      "neither. Original and synthesis are measured in the same way here.");
  return notes;
}

std::string zmp_definition(const Evaluation& evaluation, const ZmpTable& zmp) {
  const ZmpSettings& s = zmp.settings;
  const char* const segments = s.segments == ZmpSettings::Segments::Male     ? "men"
                               : s.segments == ZmpSettings::Segments::Female ? "women"
                                                                             : "men and women, mean";
  const std::string window =
      evaluation.step_rate_hz > 0
          ? fmt::format(", which is {} to either side",
                        count_text(smoothing_half_width(s, evaluation.step_rate_hz), "whole step"))
          : "";
  return fmt::format(
      "x_zmp = \u03a3 m_i [(a_iy + g) x_i \u2212 a_ix y_i] / \u03a3 m_i (a_iy + g), z likewise (Ikemoto, "
      "Arikan, Forsyth 2007): segments as point masses, de Leva's (1996) table ({}), floor at {} m. "
      "Accelerations: central differences at {}, then a triangular window of half width {} ms{}. Error: "
      "distance to the convex hull of ankle, toe base and toe tip of the feet whose lower toe joint is less "
      "than {} above the floor, widened by {}; 0 inside. Of the synthesis {} body frames count; {} are "
      "skipped (no foot on the floor, vertical force below 0.2 of the weight, or first and last frames); of "
      "the original {} are skipped.",
      segments, plain_number(s.floor_m),
      evaluation.step_rate_hz > 0 ? plain_number(evaluation.step_rate_hz) + " Hz (the step rate)"
                                  : "the step rate",
      number_text(s.smoothing_s * ms_per_s), window, plain_number(cm_per_m * s.contact_height_m) + " cm",
      plain_number(cm_per_m * s.sole_margin_m) + " cm", number_text(zmp.frames, 1),
      number_text(zmp.skipped_frames, 1), number_text(zmp.original_skipped_frames, 1));
}

}  // namespace

std::optional<HtmlSection> zmp_section(const Evaluation& evaluation) {
  if (!evaluation.result || !evaluation.has_zmp) return std::nullopt;
  const ZmpTable& zmp = evaluation.result->zmp;
  const std::string finding = fmt::format(
      "The error of the synthesised motion is {} times that of the original ({} against {}); of the partner "
      "alone {} times. The paper's figures give {} (salsa) and {} (fighting).",
      number_text(share_of(zmp.synthesised_m, zmp.original_m), 4), rounded_cm_text(zmp.synthesised_m),
      rounded_cm_text(zmp.original_m),
      number_text(share_of(zmp.synthesised_partner_m, zmp.original_partner_m), 4),
      number_text(paper::table_4[0].synthesised / paper::table_4[0].original, 4),
      number_text(paper::table_4[1].synthesised / paper::table_4[1].original, 4));
  return HtmlSection{"table-4", "Table IV \u2014 zero moment point error (4.5)", "IV \u00b7 ZMP",
                     html_finding(finding) + zmp_table(zmp) +
                         html_side_by_side({html_figures({zmp_bars(zmp)}),
                                            html_notes("Beside the paper", zmp_notes(evaluation, zmp))}) +
                         html_definitions({zmp_definition(evaluation, zmp)})};
}

}  // namespace abrazo

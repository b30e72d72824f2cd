#include <fmt/format.h>

#include <cmath>

#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/report/html_sections.hpp"

namespace abrazo {

namespace {

std::string published_text(const PublishedRow& row, double value) {
  const std::string number = small_number(row.scale * value, 0.001);
  return std::isfinite(value) && !row.unit.empty() ? number + " " + std::string(row.unit) : number;
}

std::string_view better_text(PublishedRow::Better better) {
  switch (better) {
    case PublishedRow::Better::Lower:
      return "lower";
    case PublishedRow::Better::Higher:
      return "higher";
    case PublishedRow::Better::AsRecorded:
      break;
  }
  return "as recorded";
}

std::string published_rows_table(const PublishedTable& published) {
  HtmlTable html("Figures of the literature on two people.",
                 {"figure", "better", "synthesised", "nearest neighbour", "recording"});
  for (const PublishedRow& row : published_rows())
    html.row({std::string(row.title), std::string(better_text(row.better)),
              published_text(row, published.made.*row.figure),
              published_text(row, published.nearest.*row.figure),
              published_text(row, published.captured.*row.figure)});
  return html.html();
}

std::string published_finding(const PublishedTable& published) {
  const PublishedFigures &made = published.made, &nearest = published.nearest;
  std::string text = fmt::format(
      "The partner's joints are {} mm from the captured ones (MPJPE), those of the recorded partner of the "
      "nearest "
      "pose {} mm. ",
      number_text(1000 * made.mpjpe_m), number_text(1000 * nearest.mpjpe_m));
  if (std::isfinite(made.fid_cd))
    text += fmt::format(
        "The distances between the two bodies are {} from the recorded ones (FID_cd), the nearest "
        "neighbour's {}. ",
        number_text(made.fid_cd), number_text(nearest.fid_cd));
  else
    text += "No FID_cd: it compares clips of 2 s, and no take is so long. ";
  return text + fmt::format("Jitter is {}, of the nearest neighbour {}, of the recording {}.",
                            number_text(made.jitter_10_m_s3), number_text(nearest.jitter_10_m_s3),
                            number_text(published.captured.jitter_10_m_s3));
}

std::vector<std::string> published_definitions(const PublishedTable& published) {
  return {
      "All motions at 30 frames a second, world positions, the user as captured. Mean over the takes, each "
      "weighing "
      "the same; contacts are counted over all frames. Nearest neighbour: in every frame the recorded "
      "partner of the "
      "pair whose 15-D feature is nearest to the user's, moved to the user and not edited.",
      "MPJPE, MPJVE: mean distance of the joints, and of their displacements in a frame, from the captured "
      "ones "
      "(ReMoS, Ghosh et al. 2024). Foot sliding: displacement in a frame of toe bases less than 5 cm above "
      "the "
      "lowest of the take; jitter: third difference of the joints; turned away: headings more than 45\u00b0 "
      "from "
      "opposite (Ready-to-React, Cen et al. 2025). Captured dancers slide, pivot and turn away: the "
      "recording is the "
      "aim, not zero.",
      "Skating: the pelvis moves more than 3 cm in a frame and both ankles less than 1 cm relative to it. "
      "Penetration: the least distance of two joints is below 1 cm; its depth: what is lacking to 1 cm, mean "
      "over "
      "all frames. Beat echo degree: mean over the user's beats (minima of the smoothed speed) of "
      "exp(\u2212d\u00b2 / "
      "18), d the frames to the partner's nearest (Duolando, Siyao et al. 2024).",
      "Contact: two of ten joints, one of each body, within 25 cm; those of the recording are the truth.",
      fmt::format(
          "FID of cross-distances: Fr\u00e9chet distance of mean and covariance of the 100 distances between "
          "ten joints of each body, mean over a clip, z-scored by the recorded clips; diversity: mean "
          "distance of two clips (Duolando). Here {} of 2 s each: fewer clips than features, so the "
          "covariances are not of full rank, and figures from other numbers or lengths of clips are not "
          "comparable.",
          count_text(published.clips, "clip")),
      "FIDs of learned feature spaces need the networks of those papers and are not imitated."};
}

}  // namespace

std::optional<HtmlSection> published_section(const Evaluation& evaluation) {
  if (!evaluation.result || !evaluation.result->published) return std::nullopt;
  const PublishedTable& published = *evaluation.result->published;
  return HtmlSection{"published", "Beyond the paper \u2014 figures of the recent literature", "Literature",
                     html_finding(published_finding(published)) + published_rows_table(published) +
                         html_definitions(published_definitions(published))};
}

}  // namespace abrazo

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/evaluation/report/html_page.hpp"
#include "core/evaluation/tables/evaluation.hpp"

namespace abrazo {

// The sections of report.html; none if a part was not measured. Sentences follow from the figures and state
// only what the data show.

std::optional<HtmlSection> selection_section(const Evaluation& evaluation);  ///< Table I
std::optional<HtmlSection> timing_section(const Evaluation& evaluation);     ///< Table II
std::optional<HtmlSection> moves_section(const Evaluation& evaluation);      ///< Table III
std::optional<HtmlSection> zmp_section(const Evaluation& evaluation);        ///< Table IV
std::optional<HtmlSection> movement_section(
    const Evaluation& evaluation);  ///< motion of the partner and of the captured one
std::optional<HtmlSection> contact_section(
    const Evaluation& evaluation);  ///< figures that the paper does not have
std::optional<HtmlSection> published_section(
    const Evaluation& evaluation);  ///< figures of the recent literature
std::optional<HtmlSection> bodies_section(const Evaluation& evaluation);  ///< recorded pairs on other bodies
std::optional<HtmlSection> robustness_section(
    const Evaluation& evaluation);  ///< other users, disturbed input
/// @param swept  keys of settings that vary instead
HtmlSection settings_section(const Settings& settings, const std::vector<std::string>& swept = {});

/// The row for k, if the table has one.
const SelectionRow* row_for(const SelectionTable& table, int k);

/// Settings in which an evaluation differs from the nearest preset.
struct PresetDifference {
  std::string preset;
  std::vector<std::string> keys;
};
PresetDifference nearest_preset(const Settings& settings);

}  // namespace abrazo

#pragma once

#include <string>

#include "core/evaluation/tables/suggestion_agreement.hpp"

namespace abrazo {

/// agreement.json: figures of all takes together, of each take and label, and the calibration of the
/// confidences.
std::string suggestion_json(const SuggestionAgreement& agreement, const std::string& library);

/// One self-contained page of the same.
std::string suggestion_html(const SuggestionAgreement& agreement, const std::string& library);

/// The most important figures, as lines.
std::string suggestion_summary(const SuggestionAgreement& agreement);

}  // namespace abrazo

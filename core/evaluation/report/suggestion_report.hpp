#pragma once

#include <string>

#include "core/evaluation/tables/suggestion_agreement.hpp"

namespace abrazo {

/// agreement.json: figures of all takes together, of each, of each label, and how far confidences hold.
std::string suggestion_json(const SuggestionAgreement& agreement, const std::string& library);

/// One self-contained page of the same.
std::string suggestion_html(const SuggestionAgreement& agreement, const std::string& library);

/// The few figures a person asks for first, as lines.
std::string suggestion_summary(const SuggestionAgreement& agreement);

}  // namespace abrazo

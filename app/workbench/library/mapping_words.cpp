#include "app/workbench/library/mapping_words.hpp"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.hpp"

namespace abrazo::app {

QString in_words(const JointRule& rule) {
  if (rule.terms.size() == 1 && rule.terms.front().weight == 1.0)
    return QString::fromStdString(rule.terms.front().point);
  QString words;
  for (const JointRule::Term& term : rule.terms)
    words += (words.isEmpty() ? "" : " + ") + QString::number(term.weight, 'g', 4) + " " +
             QString::fromStdString(term.point);
  return words;
}

Result<JointRule> rule_of_words(const QString& text, const std::vector<std::string>& points) {
  JointRule rule;
  if (text.trimmed().isEmpty()) return rule;
  const std::string whole = text.trimmed().toStdString();
  // A name may hold blanks and signs.
  if (std::count(points.begin(), points.end(), whole) > 0) return JointRule{{{whole, 1.0}}};
  std::vector<std::optional<double>> weights;
  for (const QString& part : text.split(" + ")) {
    const std::string term = part.trimmed().toStdString();
    const auto blank = term.find(' ');
    const auto weight =
        blank == std::string::npos ? std::nullopt : parse_number(std::string_view(term).substr(0, blank));
    const std::string point = weight ? std::string(trimmed(std::string_view(term).substr(blank))) : term;
    if (std::count(points.begin(), points.end(), point) == 0)
      return Error{"the file has no point " + in_quotes(point) + "; write LASI, or 0.5 LASI + 0.5 RASI", ""};
    rule.terms.push_back({point, weight.value_or(0)});
    weights.push_back(weight);
  }
  double sum = 0;
  for (std::size_t t = 0; t < weights.size(); ++t) {
    if (!weights[t]) rule.terms[t].weight = 1.0 / static_cast<double>(weights.size());
    sum += rule.terms[t].weight;
  }
  // Four digits are shown of a weight.
  if (std::abs(sum - 1) > 0.002)
    return Error{
        "the weights add up to " + exact_text(std::round(sum * 1e4) / 1e4) + "; they must add up to 1", ""};
  for (JointRule::Term& term : rule.terms) term.weight /= sum;
  return rule;
}

}  // namespace abrazo::app

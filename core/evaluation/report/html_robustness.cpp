#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.hpp"
#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_plot.hpp"
#include "core/evaluation/report/html_sections.hpp"

namespace abrazo {

namespace {

std::vector<const UserResult*> all_users(const Evaluation& evaluation) {
  std::vector<const UserResult*> users = {&*evaluation.result};
  for (const auto* group : {&evaluation.builds, &evaluation.disturbed})
    for (const UserResult& user : *group) users.push_back(&user);
  return users;
}

std::string users_table(const Evaluation& evaluation) {
  std::vector<std::string> columns = {"user"};
  if (evaluation.has_moves) columns.insert(columns.end(), {"success rate", "lenient"});
  columns.insert(columns.end(), {"joint error, mean (cm)", "lag (ms)", "speed, p99 (m/s)",
                                 "acceleration, times the captured"});
  if (evaluation.has_contact)
    columns.insert(columns.end(), {"hold change (cm)", "excess penetration, p99 (cm)", "sliding (cm/s)"});
  columns.insert(columns.end(), {"relaxed", "failed"});
  HtmlTable html("All takes, answered for users who differ from those captured.", columns);
  for (const UserResult* user : all_users(evaluation)) {
    std::vector<std::string> cells = {user->user};
    if (evaluation.has_moves)
      cells.insert(cells.end(), {percent_text(share_of(user->moves.all.successful, user->moves.all.total)),
                                 percent_text(share_of(user->moves.all.lenient, user->moves.all.total))});
    cells.insert(cells.end(),
                 {number_text(cm_per_m * user->partner.mean_joint_error_m),
                  number_text(ms_per_s * user->partner.lag_s), number_text(user->movement.all.speed_p99_m_s),
                  number_text(user->movement.all.acceleration_ratio)});
    if (evaluation.has_contact)
      cells.insert(cells.end(), {number_text(cm_per_m * user->contact.holds.change_mean_m),
                                 small_number(cm_per_m * user->contact.penetration.excess_p99_m, 0.01),
                                 number_text(cm_per_m * user->contact.foot_slide_m_s)});
    cells.insert(cells.end(), {percent_text(share_of(user->solve.relaxed, user->solve.steps)),
                               percent_text(share_of(user->solve.failed, user->solve.steps))});
    html.row(cells, user == &*evaluation.result ? HtmlTable::Row::Baseline : HtmlTable::Row::Own);
  }
  return html.html();
}

template <typename Value>
std::string bars(const Evaluation& evaluation, const std::string& title, const PlotAxis& axis, Value value) {
  BarPlot plot{.title = title,
               .value = axis,
               .series = {{.name = axis.title}},
               .lines = {{"as captured", value(*evaluation.result)}}};
  for (const UserResult* user : all_users(evaluation)) {
    if (user == &*evaluation.result) continue;
    plot.groups.push_back(user->user);
    plot.series[0].values.emplace_back(value(*user));
  }
  return svg_bar_plot(plot);
}

/// The user for whom something changes most against the one as captured.
template <typename Value>
const UserResult& farthest(const Evaluation& evaluation, Value value) {
  const auto users = all_users(evaluation);
  const auto change = [&](const UserResult* user) { return std::abs(value(*user) - value(*users.front())); };
  return **std::max_element(users.begin(), users.end(),
                            [&](const UserResult* a, const UserResult* b) { return change(a) < change(b); });
}

double success(const UserResult& user) {
  return user.moves.all.rate();
}
double joint_error(const UserResult& user) {
  return user.partner.mean_joint_error_m;
}

std::string robustness_finding(const Evaluation& evaluation) {
  const UserResult& as_is = *evaluation.result;
  std::string text;
  if (evaluation.has_moves && as_is.moves.all.total > 0) {
    const UserResult& user = farthest(evaluation, success);
    text += fmt::format("The success rate is {} as captured and changes most for \u201c{}\u201d, to {}. ",
                        percent_text(success(as_is)), user.user, percent_text(success(user)));
  }
  const UserResult& user = farthest(evaluation, joint_error);
  return text +
         fmt::format(
             "The partner's joint error is {} cm as captured and changes most for \u201c{}\u201d, to {} cm.",
             number_text(cm_per_m * joint_error(as_is)), user.user,
             number_text(cm_per_m * joint_error(user)));
}

}  // namespace

std::optional<HtmlSection> robustness_section(const Evaluation& evaluation) {
  if (!evaluation.result || (evaluation.builds.empty() && evaluation.disturbed.empty())) return std::nullopt;
  std::vector<std::string> figures;
  if (evaluation.has_moves && evaluation.result->moves.all.total > 0)
    figures.push_back(bars(evaluation, "Success rate of the moves",
                           {.title = "moves (%)", .minimum = 0, .maximum = 100},
                           [](const UserResult& user) { return 100 * success(user); }));
  figures.push_back(bars(evaluation, "Partner's joint error", {.title = "mean (cm)", .minimum = 0},
                         [](const UserResult& user) { return cm_per_m * joint_error(user); }));
  return HtmlSection{
      "robustness", "Robustness \u2014 users of other builds, disturbed input", "Robustness",
      html_finding(robustness_finding(evaluation)) + users_table(evaluation) + html_figures(figures) +
          html_definitions(
              {"Other builds: bone lengths multiplied as named, directions of bones kept, the path scaled "
               "with the legs. Frames lost: in gaps of random length; the last frame that arrived stands in. "
               "Noise: normal error of every coordinate, its standard deviation named. Delay: every frame "
               "arrives so much later, which the partner cannot make up for. The captured partner, with whom "
               "errors are measured, stays as captured: a smaller or a late user has errors for that "
               "alone."})};
}

}  // namespace abrazo

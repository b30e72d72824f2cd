#include "core/evaluation/report/report_html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <vector>

#include "core/evaluation/report/html_paper.hpp"
#include "core/evaluation/report/html_sections.hpp"
#include "tests/core/evaluation/report_example.hpp"

namespace abrazo::report_html_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// What is wrong with a text as XML, by a reading of its own: tags that do not close in order, attributes
/// without quotes, a stray '<' or '&'. Empty when nothing is.
std::string xml_fault(const std::string& text) {
  static const std::regex tag(R"(</?([A-Za-z][A-Za-z0-9]*)((\s+[A-Za-z][A-Za-z0-9:-]*="[^"<]*")*)\s*(/?)>)");
  static const std::regex entity("&(amp|lt|gt|quot|#39);");
  std::vector<std::string> open;
  for (std::size_t at = text.find_first_of("<&"); at != std::string::npos;
       at = text.find_first_of("<&", at + 1)) {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
    const std::string near = text.substr(at, 60);
    std::smatch match;
    if (text[at] == '&') {
      if (!std::regex_search(begin, text.end(), match, entity, std::regex_constants::match_continuous))
        return "stray & at " + near;
      continue;
    }
    if (text.compare(at, 9, "<!DOCTYPE") == 0) continue;
    if (!std::regex_search(begin, text.end(), match, tag, std::regex_constants::match_continuous))
      return "not a tag: " + near;
    if (text[at + 1] == '/') {
      if (open.empty() || open.back() != match[1]) return "does not close what is open: " + near;
      open.pop_back();
    } else if (match[4].length() == 0) {
      open.push_back(match[1]);
    }
  }
  return open.empty() ? "" : "left open: " + open.back();
}

TEST(XmlFault, IsFoundByTheseTests) {
  EXPECT_EQ(xml_fault("<a><b x=\"1\"/>&amp;</a>"), "");
  EXPECT_NE(xml_fault("<a><b></a></b>"), "");
  EXPECT_NE(xml_fault("<a>1 < 2</a>"), "");
  EXPECT_NE(xml_fault("<a>this & that</a>"), "");
  EXPECT_NE(xml_fault("<a>"), "");
}

TEST(ReportHtml, IsWellFormed) {
  EXPECT_EQ(xml_fault(report_html(test::example_evaluation())), "");
}

TEST(ReportHtml, LoadsNothingFromAnywhere) {
  const std::string html = report_html(test::example_evaluation());
  EXPECT_FALSE(std::regex_search(html, std::regex(R"((src|href)="(?!#))"))) << "only links within the page";
  EXPECT_THAT(html, Not(HasSubstr("@import")));
  EXPECT_THAT(html, Not(HasSubstr("url(")));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
}

TEST(ReportHtml, ShowsThePapersPrintedFiguresBesideOurs) {
  const std::string html = report_html(test::example_evaluation());
  // A row of Table I: k, here at 60 and 15 Hz, paper; the same for the best two; excess, time here, time
  // there.
  EXPECT_THAT(
      html,
      HasSubstr("<th scope=\"row\">10</th><td>83.00\u00a0%</td><td>94.90\u00a0%</td><td>95.07\u00a0%</td>"
                "<td>88.10\u00a0%</td><td>96.43\u00a0%</td><td>97.73\u00a0%</td><td>1.20\u00a0%</td>"
                "<td>0.0500</td><td>14.9</td>"));
  EXPECT_THAT(html, HasSubstr("<td>12.4</td><td>40.5</td>"));
  EXPECT_THAT(html, HasSubstr("<td>15.0</td><td>145.2</td>"));
  for (const char* rate : {"96.30", "85.00", "83.87", "92.31"})
    EXPECT_THAT(html, HasSubstr("<td>" + std::string(rate) + "\u00a0%</td>"));
  EXPECT_THAT(html, HasSubstr("<td>0.70</td><td>0.72</td>"));
  EXPECT_THAT(html, HasSubstr("<td>2.24</td><td>2.21</td>"));
  EXPECT_THAT(html, HasSubstr("<td>70.00\u00a0%</td>")) << "14 of 20 moves";
}

TEST(ReportHtml, EscapesNamesFromOutside) {
  Evaluation evaluation = test::example_evaluation();
  const std::string evil = "<script>&\"'";
  evaluation.data = evaluation.users = evil;
  evaluation.takes = evaluation.remarks = {evil};
  evaluation.result->moves.per_take = {{evil, {.total = 1, .successful = 1, .lenient = 1}}};
  evaluation.result->moves.per_label = {{evil, {.total = 1, .successful = 0, .lenient = 0}}};
  evaluation.result->moves.labels[0] = evil;
  evaluation.disturbed[0].user = evil;
  const std::string html = report_html(evaluation);
  EXPECT_EQ(xml_fault(html), "");
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;&amp;"));
}

TEST(ReportHtml, HasNoSectionForWhatWasNotMeasured) {
  Evaluation evaluation = test::example_evaluation();
  evaluation.timing.clear();
  evaluation.has_zmp = false;
  const std::string html = report_html(evaluation);
  for (const char* id : {"table-1", "table-3", "beyond"})
    EXPECT_THAT(html, HasSubstr("<section id=\"" + std::string(id) + "\">"));
  for (const char* id : {"table-2", "table-4"})
    EXPECT_THAT(html, Not(HasSubstr("<section id=\"" + std::string(id) + "\">")));
  EXPECT_EQ(xml_fault(report_html(Evaluation{})), "") << "not even of an empty one";
}

TEST(ReportHtml, IsTheSameForTheSameFigures) {
  EXPECT_EQ(report_html(test::example_evaluation()), report_html(test::example_evaluation()));
}

TEST(ReportHtml, BlamesNearDuplicatesOnlyWhenThinningHelps) {
  Evaluation evaluation = test::example_evaluation();
  EXPECT_THAT(report_html(evaluation), HasSubstr("raises the share by 11.9 points"));
  evaluation.selection[1].rows = evaluation.selection[0].rows;
  const std::string html = report_html(evaluation);
  EXPECT_THAT(html, Not(HasSubstr("raises the share")));
  EXPECT_THAT(html, HasSubstr("near duplicates do not explain"));
}

TEST(ReportHtml, SaysWhetherRatesDifferByMoreThanCounting) {
  Evaluation evaluation = test::example_evaluation();
  EXPECT_THAT(report_html(evaluation), HasSubstr("(48 \u2013 85\u00a0% and 82 \u2013 99\u00a0%) overlap"));
  evaluation.result->moves.all = {.total = 200, .successful = 100, .lenient = 100};
  EXPECT_THAT(report_html(evaluation), HasSubstr("do not overlap"));
}

TEST(ReportHtml, ComparesFightsWithThePapersFights) {
  Evaluation evaluation = test::example_evaluation();
  evaluation.result->moves.per_label = {{"punch_block", {.total = 20, .successful = 14, .lenient = 14}}};
  const std::string html = report_html(evaluation);
  EXPECT_THAT(html, HasSubstr("70.00\u00a0% here against 92.31\u00a0% printed for fighting"));
  EXPECT_THAT(html, Not(HasSubstr("printed for salsa")));
}

TEST(ReportHtml, SaysWhenNoTakeHasMoves) {
  Evaluation evaluation = test::example_evaluation();
  evaluation.result->moves = {};
  const std::string html = report_html(evaluation);
  EXPECT_THAT(html, HasSubstr("there is no success rate"));
  EXPECT_EQ(xml_fault(html), "");
}

TEST(ReportHtml, BlamesJumpsForTheZmpErrorOnlyWhenItIsLowerBetweenThem) {
  Evaluation evaluation = test::example_evaluation();
  EXPECT_THAT(report_html(evaluation), HasSubstr("its ratio is 1.01 instead of 1.05"));
  evaluation.result->zmp.partner_between_changes_m = evaluation.result->zmp.original_between_changes_m * 1.06;
  EXPECT_THAT(report_html(evaluation), Not(HasSubstr("Jumps from one recorded pair")));
}

TEST(ReportHtml, ShowsThePartnerWithoutContactWhenOnlyMovesWereAskedFor) {
  Evaluation evaluation = test::example_evaluation();
  evaluation.has_contact = false;
  const std::string html = report_html(evaluation);
  EXPECT_THAT(html, HasSubstr("joint error, mean over steps"));
  EXPECT_THAT(html, Not(HasSubstr("holds kept")));
  EXPECT_THAT(html, Not(HasSubstr("hold change")));
}

TEST(ReportHtml, ShowsHowThePartnerMovesBesideTheCapturedOne) {
  Evaluation evaluation = test::example_evaluation();
  std::string html = report_html(evaluation);
  EXPECT_THAT(html, HasSubstr("<section id=\"movement\">"));
  EXPECT_THAT(html, HasSubstr("moves at 4.46 m/s in the 99th percentile, the captured one at 1.57 m/s"));
  EXPECT_THAT(html,
              HasSubstr("<th scope=\"row\">speed, 99th percentile</th><td>1.57 m/s</td><td>4.46 m/s</td>"));
  EXPECT_THAT(html, HasSubstr("Of the holds of the capture 77\u00a0% are held"));
  for (const char* title : {"Speed of the partner", "Acceleration of the partner&#39;s joints",
                            "Sliding of landed feet", "Pace of the source"})
    EXPECT_THAT(html, HasSubstr(title));
  evaluation.result->movement.all.slide_m_s = evaluation.result->movement.all.captured_holds_held =
      std::nan("");
  evaluation.result->movement.made.slide_m_s.clear();
  evaluation.result->movement.captured.slide_m_s.clear();
  html = report_html(evaluation);
  EXPECT_THAT(html, Not(HasSubstr("landed feet slide at")));
  EXPECT_THAT(html, Not(HasSubstr("Of the holds of the capture ")));
  EXPECT_EQ(xml_fault(html), "");
}

TEST(ReportHtml, ShowsTheFiguresOfTheLiteratureBesideTheNearestNeighbourAndTheRecording) {
  const std::string html = report_html(test::example_evaluation());
  for (const PublishedRow& row : published_rows())
    EXPECT_NE(html.find(std::string(row.title)), std::string::npos) << row.title;
  EXPECT_NE(html.find("nearest neighbour"), std::string::npos);
  EXPECT_NE(html.find("Here 44 clips of 2 s each"), std::string::npos);
}

TEST(ReportHtml, SaysWhatIsLeftOutOfTheZmpError) {
  Evaluation evaluation = test::example_evaluation();
  std::string html = report_html(evaluation);
  EXPECT_THAT(html, HasSubstr("frames 5.6\u00a0% are left out: in 30 (captured 1) too little"));
  EXPECT_THAT(html, HasSubstr("in 20 (captured 2) no foot is near it"));
  ZmpTable& zmp = evaluation.result->zmp;
  zmp.partner_free_fall = zmp.partner_no_support = 0;
  EXPECT_THAT(report_html(evaluation), Not(HasSubstr("no foot is near it")));
}

TEST(ReportHtml, WarnsOfALagThatSaysLittle) {
  Evaluation evaluation = test::example_evaluation();
  EXPECT_THAT(report_html(evaluation), Not(HasSubstr("says little")));
  evaluation.result->partner.lag_correlation = 0.1;
  EXPECT_THAT(report_html(evaluation), HasSubstr("says little"));
}

TEST(NearestPreset, NamesTheSettingsThatDiffer) {
  Settings settings = *preset("responsive");
  EXPECT_EQ(nearest_preset(settings).preset, "responsive");
  EXPECT_THAT(nearest_preset(settings).keys, IsEmpty());
  settings.alpha = 0.7;
  EXPECT_EQ(nearest_preset(settings).preset, "responsive");
  EXPECT_THAT(nearest_preset(settings).keys, ElementsAre("alpha"));
}

TEST(ShareInterval, IsWilsons) {
  // p = 26/27, z = 1.96: (p + z^2/2n +- z sqrt(p(1-p)/n + z^2/4n^2)) / (1 + z^2/n), worked out by hand.
  EXPECT_NEAR(share_interval(26, 27).low, 0.8172, 5e-4);
  EXPECT_NEAR(share_interval(26, 27).high, 0.9934, 5e-4);
  EXPECT_DOUBLE_EQ(share_interval(0, 0).low, 0);
  EXPECT_DOUBLE_EQ(share_interval(0, 0).high, 1);
  EXPECT_DOUBLE_EQ(share_interval(5, 5).high, 1);
}

}  // namespace
}  // namespace abrazo::report_html_test

#include "core/base/json_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace abrazo::json_text_test {
namespace {

TEST(JsonText, WritesObjectsAndArraysWithCommasWhereTheyBelong) {
  JsonText json;
  json.begin_object();
  json.key("a").value(1);
  json.key("b").begin_array().value(true).null().value("x").begin_object().end_object().end_array();
  json.key("c").begin_object().key("d").value(0.5).end_object();
  json.end_object();
  EXPECT_EQ(json.text(), R"({"a":1,"b":[true,null,"x",{}],"c":{"d":0.5}})");
}

TEST(JsonText, WritesWhatAJsonReaderReadsBack) {
  const std::string awkward = "quote \" backslash \\ line\nend \x01 \xC3\xA4";
  JsonText json;
  json.begin_array().value(awkward).value(1.0 / 3.0).value(-1e-300).end_array();
  const nlohmann::json read = nlohmann::json::parse(json.text());
  EXPECT_EQ(read[0].get<std::string>(), awkward);
  EXPECT_EQ(read[1].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(read[2].get<double>(), -1e-300);
}

TEST(JsonText, WritesNullForWhatIsNotFinite) {
  JsonText json;
  json.begin_array()
      .value(std::numeric_limits<double>::quiet_NaN())
      .value(std::numeric_limits<double>::infinity())
      .end_array();
  EXPECT_EQ(json.text(), "[null,null]");
}

TEST(JsonText, WritesAMatrixAsRows) {
  Eigen::Matrix<double, 2, 3> matrix;
  matrix << 1, 2, 3, 4, 5, 6.5;
  JsonText json;
  json.rows(matrix);
  EXPECT_EQ(json.text(), "[[1,2,3],[4,5,6.5]]");
}

TEST(JsonText, CanBeUsedAgainAfterClear) {
  JsonText json;
  json.begin_array().value(1).end_array();
  json.clear();
  json.begin_array().value(2).end_array();
  EXPECT_EQ(json.take(), "[2]");
}

}  // namespace
}  // namespace abrazo::json_text_test

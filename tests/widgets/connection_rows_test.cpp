// The words and numbers of the connection panel and the latency table: no display.
#include <gtest/gtest.h>

#include <cmath>

#include "widgets/stream/latency_rows.hpp"
#include "widgets/stream/sink_rates.hpp"
#include "widgets/stream/stream_address.hpp"
#include "widgets/stream/stream_words.hpp"

namespace abrazo::widgets::connection_rows_test {
namespace {

using Scheme = StreamUri::Scheme;

PerformerHealth ana() {
  PerformerHealth performer;
  performer.performer = "Ana";
  performer.rate_hz = 119.96;
  performer.interval_p50_ms = 8.33;
  performer.interval_p95_ms = 9.1;
  performer.tracked = true;
  performer.joint_map = "unity";
  performer.height_m = 1.617;
  return performer;
}

StreamHealth receiving() {
  StreamHealth health;
  health.state = StreamHealth::State::Receiving;
  health.uri = "vmc://0.0.0.0:39539";
  health.listening = "0.0.0.0:39539";
  health.performers = {ana()};
  return health;
}

StreamAddress address(Scheme scheme, const char* host, int port) {
  StreamAddress made;
  made.scheme = scheme;
  made.host = host;
  made.port = port;
  return made;
}

TEST(StreamAddress, FieldsMakeTheUriAndEmptyOnesTheUsualValues) {
  EXPECT_EQ(uri_of({}), "vmc://127.0.0.1:39539") << "nobody else is heard unless one says so";
  EXPECT_EQ(uri_of(address(Scheme::Xsens, "10.0.0.2", 9764)), "xsens://10.0.0.2:9764");
  StreamAddress motive = address(Scheme::NatNet, "motive", 0);
  motive.group = "239.255.42.99";
  EXPECT_EQ(uri_of(motive), "natnet://motive:1510?multicast=239.255.42.99");
  StreamAddress clip = address(Scheme::Clip, "", 0);
  clip.file = "a b.bvh";
  EXPECT_EQ(uri_of(clip), "clip:a b.bvh");
}

TEST(StreamAddress, APastedUriFillsTheFieldsAndKeepsItsOptions) {
  const auto address = address_of("natnet://10.0.0.9:1511?multicast=239.1.1.1&delay=20");
  ASSERT_TRUE(address) << address.error().text();
  EXPECT_EQ(address->host, "10.0.0.9");
  EXPECT_EQ(address->port, 1511);
  EXPECT_EQ(address->group, "239.1.1.1");
  EXPECT_EQ(uri_of(*address), "natnet://10.0.0.9:1511?delay=20&multicast=239.1.1.1");
}

TEST(StreamAddress, WhatAnOptionMayNotHaveInAUriIsWrittenSoThatItReadsBack) {
  StreamAddress address;
  address.options["performer"] = "Ana & Bo 100%";
  const auto back = address_of(uri_of(address));
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_EQ(back->options.at("performer"), "Ana & Bo 100%");
}

TEST(StreamAddress, SaysWhoWillBeHeardBeforeOneConnects) {
  EXPECT_EQ(reach_of({}), "Listens on this machine only (127.0.0.1:39539); 0.0.0.0 is every network");
  EXPECT_EQ(reach_of(address(Scheme::Xsens, "0.0.0.0", 9764)), "Listens on every network (0.0.0.0:9764)");
  EXPECT_EQ(reach_of(address(Scheme::Vmc, "10.0.0.2", 0)),
            "Listens on the network of 10.0.0.2 (10.0.0.2:39539)");
  EXPECT_EQ(reach_of(address(Scheme::NatNet, "10.0.0.9", 0)),
            "Asks Motive at 10.0.0.9:1510; listens on the network that leads there");
  EXPECT_EQ(reach_of(address(Scheme::Clip, "", 0)), "");
}

TEST(StreamAddress, NonsenseIsAnError) {
  EXPECT_FALSE(address_of("osc://here"));
  EXPECT_FALSE(address_of("vmc://0.0.0.0:99999"));
}

TEST(StreamWords, EachStateHasAWordAndAMarkOfItsOwn) {
  StreamHealth health = receiving();
  EXPECT_EQ(headline_of(&health).mark, StreamMark::Good);
  EXPECT_EQ(headline_of(&health).detail, "VMC, on every network (0.0.0.0:39539)");
  health.listening = "127.0.0.1:39539";
  health.senders = {"127.0.0.1:50021"};
  EXPECT_EQ(headline_of(&health).detail, "VMC from this machine, on this machine only (127.0.0.1:39539)");
  health.state = StreamHealth::State::Waiting;
  EXPECT_EQ(headline_of(&health).mark, StreamMark::Waiting);
  health.state = StreamHealth::State::Stalled;
  EXPECT_EQ(headline_of(&health).mark, StreamMark::Warning);
  health.state = StreamHealth::State::Failed;
  EXPECT_EQ(headline_of(&health).mark, StreamMark::Bad);
  EXPECT_EQ(headline_of(nullptr).mark, StreamMark::Off);
}

TEST(StreamWords, AStreamIsCalledAfterItsSenderAndNotAfterThePortItComesTo) {
  StreamHealth health = receiving();
  EXPECT_EQ(stream_name(health), "VMC") << "nobody has sent yet";
  health.senders = {"192.168.1.20:50021"};
  EXPECT_EQ(stream_name(health), "VMC from 192.168.1.20");
  EXPECT_EQ(stream_name(health, "192.168.1.20:50021"), "VMC from 192.168.1.20");
  health.senders.push_back("127.0.0.1:50022");
  EXPECT_EQ(stream_name(health), "VMC from 2 machines");
  EXPECT_EQ(stream_name(health, "127.0.0.1:50022"), "VMC from this machine") << "whose poses are meant";
  EXPECT_EQ(stream_name(health, "all senders"), "VMC from 2 machines") << "in VMC nobody has a name";
}

TEST(StreamWords, APerformerWhomTheStreamNamesIsInItsName) {
  StreamHealth health = receiving();
  health.uri = "natnet://10.0.0.9:1510";
  EXPECT_EQ(stream_name(health), "NatNet (Motive) at 10.0.0.9");
  EXPECT_EQ(stream_name(health, "Ana"), "Ana, NatNet (Motive) at 10.0.0.9");
  health.uri = "xsens://0.0.0.0:9763";
  health.senders = {"10.0.0.4:51000"};
  EXPECT_EQ(stream_name(health, "Ana"), "Ana, Xsens MVN from 10.0.0.4");
}

TEST(StreamWords, AReceivingStreamWhoseOnlyPerformerIsLostIsAWarning) {
  StreamHealth health = receiving();
  health.performers[0].tracked = false;
  EXPECT_EQ(headline_of(&health).mark, StreamMark::Warning);
  EXPECT_EQ(headline_of(&health).word, "receiving, tracking lost");
}

TEST(StreamWords, FiguresHaveUnitsAndAConstantNumberOfDigits) {
  const auto figures = figures_of(ana());
  EXPECT_EQ(figures[0].value, "120.0 Hz");
  EXPECT_EQ(figures[2].value, "8.3 / 9.1 ms");
}

TEST(StreamWords, OnlyCountsThatShouldBeZeroAreOddWhenTheyAreNot) {
  PerformerHealth performer = ana();
  for (const StreamFigure& figure : figures_of(performer)) EXPECT_FALSE(figure.is_odd) << figure.name;
  performer.lost = 3;
  performer.reordered = 5;  // those came in time
  for (const StreamFigure& figure : figures_of(performer)) EXPECT_EQ(figure.is_odd, figure.name == "lost");
}

TEST(StreamWords, ACalibrationInAnotherPoseIsDoubtful) {
  PerformerHealth performer = ana();
  performer.calibration_doubts = {"no pose came meanwhile"};
  EXPECT_TRUE(body_line(performer).ends_with("not calibrated"));
  performer.calibrated = true;
  EXPECT_TRUE(body_line(performer).ends_with(" · calibrated, doubtful")) << body_line(performer);
  performer.calibration_doubts.clear();
  EXPECT_TRUE(body_line(performer).ends_with(" · calibrated")) << body_line(performer);
}

TEST(StreamWords, CountsAreGroupedAndBytesHaveThreeOrMoreFigures) {
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1234567), "1\u202f234\u202f567");
  EXPECT_EQ(byte_count_text(17), "17 bytes");
  EXPECT_EQ(byte_count_text(1250), "1.2 kB");
  EXPECT_EQ(byte_count_text(999'960), "1.0 MB");
  EXPECT_EQ(byte_count_text(34'500'000), "34.5 MB");
}

TEST(StreamWords, BytesOfAnotherProtocolAreShownAsNumbersAndLetters) {
  const std::array<std::uint8_t, 4> bytes = {0x56, 0x4d, 0x00, 0xff};
  EXPECT_EQ(dump_text(bytes), "56 4d 00 ff  VM..");
}

TEST(StreamWords, TheReportHasDiagnosesIssuesAndPerformers) {
  StreamHealth health = receiving();
  health.issues = {{"truncated", 12, "packet of 7 bytes: expected 24 at least"}};
  health.diagnoses = {{"low-rate", StreamDiagnosis::Severity::Warning, "5 Hz come in; raise the rate"}};
  const std::string report = report_of(health);
  for (const char* part : {"receiving", "Ana: tracked", "unity map · head at 1.62 m · not calibrated",
                           "warning low-rate: 5 Hz come in", "12 x truncated: packet of 7 bytes"})
    EXPECT_NE(report.find(part), std::string::npos) << part << " in\n" << report;
}

TEST(SinkRates, AreThePacketsOfTheLastSecondOrSo) {
  SinkRates rates;
  SinkHealth sink;
  sink.uri = "vmc://127.0.0.1:39540";
  sink.packets = 100;
  EXPECT_EQ(rates.update({sink}, 10)[0].packets_per_s, 0);
  sink.packets = 220;
  EXPECT_EQ(rates.update({sink}, 10.25)[0].packets_per_s, 0) << "too short a time to tell";
  sink.packets = 580;
  EXPECT_DOUBLE_EQ(rates.update({sink}, 11)[0].packets_per_s, 480);
  sink.packets = 600;
  EXPECT_DOUBLE_EQ(rates.update({sink}, 11.25)[0].packets_per_s, 480) << "does not jump meanwhile";
}

TEST(SinkRates, ASinkThatWasOpenedAnewCountsFromZero) {
  SinkRates rates;
  SinkHealth sink;
  sink.packets = 1000;
  (void)rates.update({sink}, 1);
  sink.packets = 10;
  EXPECT_EQ(rates.update({sink}, 3)[0].packets_per_s, 0);
}

FrameSnapshot frame_at(double arrived_s) {
  FrameSnapshot frame;
  frame.time_s = arrived_s + 0.004;
  frame.times = {arrived_s, arrived_s + 0.0005, arrived_s + 0.0025, arrived_s + 0.003, arrived_s + 0.0031};
  return frame;
}

TEST(LatencySample, SplitsTheWayOfAPoseIntoItsStages) {
  const FrameSnapshot before = frame_at(10), frame = frame_at(10.01);
  const LatencySample sample = latency_sample(frame, &before);
  EXPECT_NEAR(sample.interval, 10, 1e-6);
  EXPECT_NEAR(sample.stage(LatencyStage::Assembly), 0.5, 1e-6);
  EXPECT_NEAR(sample.stage(LatencyStage::Wait), 2, 1e-6);
  EXPECT_NEAR(sample.stage(LatencyStage::Solve), 0.5, 1e-6);
  EXPECT_NEAR(sample.stage(LatencyStage::Send), 0.1, 1e-6);
  EXPECT_NEAR(sample.end_to_end, 3.1, 1e-6);
  EXPECT_TRUE(std::isnan(sample.stage(LatencyStage::Render)));
}

TEST(LatencySample, WithoutASinkTheWayEndsAtThePoseAndAClipHasOnlyTheStep) {
  FrameSnapshot frame = frame_at(10);
  frame.times.sent_s = -1;
  EXPECT_NEAR(latency_sample(frame, nullptr).end_to_end, 3, 1e-6);
  EXPECT_FALSE(latency_sample(frame, nullptr).is_sent);
  frame.times.arrived_s = frame.times.assembled_s = -1;
  EXPECT_TRUE(std::isnan(latency_sample(frame, nullptr).end_to_end));
  EXPECT_NEAR(latency_sample(frame, nullptr).stage(LatencyStage::Solve), 0.5, 1e-6);
}

TEST(LatencyRows, HaveThePercentilesOfWhatWasMeasured) {
  std::vector<LatencySample> samples(100);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].end_to_end = static_cast<double>(i + 1);
  samples.emplace_back();  // nothing measured: does not count
  const auto rows = latency_rows(samples, nullptr);
  const LatencyRow& way = rows[1 + latency_stage_count];
  EXPECT_EQ(way.name, "In → pose");
  EXPECT_EQ(way.p50, 50);
  EXPECT_EQ(way.p95, 95);
  EXPECT_EQ(way.p99, 99);
  EXPECT_TRUE(std::isnan(rows[1].p50));
}

TEST(LatencyRows, TheShownFrameHasAColumnOfItsOwn) {
  const LatencySample here = latency_sample(frame_at(3), nullptr);
  const auto rows = latency_rows({}, &here);
  EXPECT_EQ(rows[1 + latency_stage_count].name, "In → out");
  EXPECT_EQ(latency_text(rows[1 + latency_stage_count].here), "3.10");
  EXPECT_EQ(latency_text(rows[0].here), "–") << "there was no frame before";
}

TEST(LatencyRows, TextsHaveThreeFigures) {
  EXPECT_EQ(latency_text(0.4), "0.40");
  EXPECT_EQ(latency_text(9.996), "10.0");
  EXPECT_EQ(latency_text(123.4), "123");
}

TEST(LatencyVerdict, IsOfTheWayWithoutTheDelayThatWasAskedFor) {
  EXPECT_EQ(verdict_of(3, 0, 8.3), LatencyVerdict::Good);
  EXPECT_EQ(verdict_of(14, 0, 8.3), LatencyVerdict::Warning);
  EXPECT_EQ(verdict_of(14, 0, 16.7), LatencyVerdict::Good) << "a slower input allows more";
  EXPECT_EQ(verdict_of(103, 100, 8.3), LatencyVerdict::Good);
  EXPECT_EQ(verdict_of(31, 0, 8.3), LatencyVerdict::Bad);
  EXPECT_EQ(verdict_of(LatencySample::none, 0, 8.3), LatencyVerdict::None);
}

}  // namespace
}  // namespace abrazo::widgets::connection_rows_test

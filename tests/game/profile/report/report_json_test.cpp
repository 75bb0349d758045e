// report.json: what is written reads back the same, and what is no report is refused in a sentence.
#include "game/profile/report/report_json.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host/platform/atomic_file.h"
#include "tests/game/profile/report/sample_report.h"
#include "tests/game/profile/report/scratch_folder.h"

namespace gw::profile::test {
namespace {

using Json = nlohmann::ordered_json;

class ReportJson : public ScratchFolder {
 protected:
  std::filesystem::path path() const { return folder_ / "report.json"; }
  Report readBack(const std::string& text) const {
    put(path(), text);
    return readReport(path());
  }
  std::string refused(const std::string& text) const {
    const std::string sentence = refusal<FileError>([&] { readBack(text); });
    EXPECT_TRUE(sentence.starts_with(path().string() + " cannot be read as a report: ")) << sentence;
    EXPECT_TRUE(sentence.ends_with("; give the report.json of another session, or profile again")) << sentence;
    EXPECT_EQ(sentence.find('\n'), sentence.npos);
    return sentence;
  }
};

TEST_F(ReportJson, ReadsBackAsItWasWritten) {
  const Report report = sampleReport();
  const std::string text = reportJson(report);
  const Report back = readBack(text);
  EXPECT_EQ(reportJson(back), text);
  ASSERT_EQ(back.cases.size(), 3u);
  const Contender& before = report.cases[1].contenders[2];
  const Contender& after = back.cases[1].contenders[2];
  EXPECT_EQ(after.name, before.name);
  EXPECT_EQ(after.runs, before.runs) << "to the last bit";
  EXPECT_EQ(after.seconds[7].stages_ms, before.seconds[7].stages_ms);
  EXPECT_EQ(after.histogram[9].frames, before.histogram[9].frames);
  EXPECT_EQ(after.percentiles[3].y, before.percentiles[3].y);
  EXPECT_EQ(after.tickOverLive[2].x, before.tickOverLive[2].x);
  EXPECT_EQ(back.cases[0].speedUps[1].tick.high, report.cases[0].speedUps[1].tick.high);
  EXPECT_EQ(back.growth[1].fit->exponent, report.growth[1].fit->exponent);
  EXPECT_FALSE(back.growth[3].fit.has_value());
  EXPECT_EQ(back.growth[3].why, report.growth[3].why);
  EXPECT_EQ(back.machine.gpuPower_W, 214.5);
  ASSERT_TRUE(back.machine.processors.has_value());
  EXPECT_EQ(back.machine.processors->governor, "performance");
  EXPECT_EQ(back.machine.processors->quota, 1.5);
  EXPECT_EQ(back.setup.warmUp, 120u);
  EXPECT_EQ(back.warnings, report.warnings);
}

TEST_F(ReportJson, UnknownNumbersAreNullAndReadBackAsUnknown) {
  Report report;
  report.machine.gpuPower_W = kUnknown;
  report.machine.loadBefore = INFINITY;
  const Json json = Json::parse(reportJson(report));
  EXPECT_TRUE(json["machine"]["gpuPower_W"].is_null());
  EXPECT_TRUE(json["machine"]["loadBefore"].is_null());
  EXPECT_TRUE(std::isnan(readBack(reportJson(report)).machine.gpuPower_W));
}

TEST_F(ReportJson, OfAnEarlierProgramHasNoStateOfTheProcessors) {
  Json json = Json::parse(reportJson(sampleReport()));
  json["machine"].erase("processors");
  const Report back = readBack(json.dump());
  EXPECT_FALSE(back.machine.processors.has_value());
  EXPECT_FALSE(Json::parse(reportJson(back))["machine"].contains("processors"));
}

RC_GTEST_FIXTURE_PROP(ReportJson, AnyReportReadsBackTheSame, (uint32_t seed)) {
  const std::string text = reportJson(randomReport(seed));
  RC_ASSERT(reportJson(readBack(text)) == text);
}

RC_GTEST_FIXTURE_PROP(ReportJson, EveryFiniteNumberKeepsItsBits, (uint64_t bits)) {
  Report report;
  report.stageTimersCost = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(report.stageTimersCost));
  RC_ASSERT(std::bit_cast<uint64_t>(readBack(reportJson(report)).stageTimersCost) == bits);
}

TEST_F(ReportJson, ExplainsItsMetrics) {
  const Json table = Json::parse(reportJson({}))["metrics"];
  ASSERT_EQ(table.size(), metrics().size());
  for (size_t i = 0; i < table.size(); ++i) {
    EXPECT_EQ(table[i]["name"], metrics()[i].name);
    EXPECT_EQ(table[i]["unit"], metrics()[i].unit);
    EXPECT_EQ(table[i]["definition"], metrics()[i].definition);
    EXPECT_TRUE(table[i]["better"] == "higher" || table[i]["better"] == "lower" || table[i]["better"] == "neither");
  }
}

TEST_F(ReportJson, NamesMayHoldAnyBytes) {
  const Report back = readBack(reportJson(hostileReport()));
  EXPECT_NE(back.setup.scene.find("<script>"), std::string::npos);
  EXPECT_NE(back.setup.scene.find("\xEF\xBF\xBD"), std::string::npos) << "bytes that are no text are replaced";
}

TEST_F(ReportJson, WhatIsNoReportIsRefused) {
  EXPECT_NE(refused("").find("not JSON"), std::string::npos);
  EXPECT_NE(refused("hello").find("not JSON"), std::string::npos);
  EXPECT_NE(refused("{}").find("gpuwarsProfile is missing"), std::string::npos);
  EXPECT_NE(refused("[]").find("its content is not an object"), std::string::npos);
  EXPECT_NE(refused("{\"gpuwarsProfile\": \"1\"}").find("gpuwarsProfile is not a whole number"), std::string::npos);
  EXPECT_NE(refused("{\"gpuwarsProfile\": 1}").find("machine is missing"), std::string::npos);
  EXPECT_NE(refused(std::string(100000, '[')).find("not JSON"), std::string::npos);
}

TEST_F(ReportJson, AnotherVersionIsRefusedByItsNumber) {
  Json json = Json::parse(reportJson(sampleReport()));
  json["gpuwarsProfile"] = 2;
  EXPECT_NE(refused(json.dump()).find("it is of version 2, and this program knows version 1"), std::string::npos);
}

TEST_F(ReportJson, EveryCutIsRefused) {
  const std::string text = reportJson(sampleReport());
  for (size_t length = 0; length + 2 < text.size(); length += text.size() / 40) refused(text.substr(0, length));
}

// Every key of every object, one at a time; but of maps by metric, which say what was measured by what is there.
void eachKey(const Json& json, const Json::json_pointer& at,
             const std::function<void(const Json::json_pointer&)>& visit) {
  for (const auto& [key, child] : json.items()) {
    const bool free = key == "overall" || key == "metrics" || (!at.empty() && at.back() == "runs" && json.is_object());
    if (json.is_object()) visit(at / key);
    if (json.is_array() && key != "0") break;  // the first of each list stands for the others
    const Json::json_pointer below = json.is_array() ? at / size_t(0) : at / key;
    if (!free && key != "runs" && child.is_structured()) eachKey(child, below, visit);
  }
}

TEST_F(ReportJson, EveryKeyIsNeededAndOfItsKind) {
  const Json whole = Json::parse(reportJson(sampleReport()));
  size_t keys = 0;
  eachKey(whole, Json::json_pointer(), [&](const Json::json_pointer& key) {
    if (key.back() == "metrics") return;  // for people only
    ++keys;
    Json without = whole;
    without.at(key.parent_pointer()).erase(key.back());
    if (key.back() != "processors") {  // which earlier programs did not write
      EXPECT_NE(refused(without.dump()).find(key.back() + " is missing"), std::string::npos) << key;
    }
    Json odd = whole;
    odd.at(key) = Json::parse("{\"odd\": [false]}");
    if (key.back() == "overall") return;  // a map may have any key; below it something else is refused
    EXPECT_NE(refused(odd.dump()).find(key.back()), std::string::npos) << key;
  });
  EXPECT_GT(keys, 60u);
}

TEST_F(ReportJson, NumbersOutOfTheirRangeAreRefused) {
  const Json whole = Json::parse(reportJson(sampleReport()));
  for (const char* odd : {"-1", "4294967296", "1.5", "null", "true"}) {
    Json json = whole;
    json["cases"][0]["enemies"] = Json::parse(odd);
    EXPECT_NE(refused(json.dump()).find("cases[0].enemies is not a whole number in its range"), std::string::npos);
  }
}

TEST_F(ReportJson, WhatCannotBeReadIsRefused) {
  EXPECT_NE(refusal<FileError>([&] { readReport(folder_ / "none.json"); }).find("it is not there"), std::string::npos);
  EXPECT_NE(refusal<FileError>([&] { readReport(folder_); }).find("not a plain file"), std::string::npos);
  EXPECT_NE(refusal<FileError>([&] { readReport("/dev/zero"); }).find("not a plain file"), std::string::npos);
}

}  // namespace
}  // namespace gw::profile::test

#include "game/commands/verify_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "game/desync/desync_text.h"
#include "host/platform/junit_xml.h"
#include "host/platform/number_format.h"

namespace gw {
namespace {

double ticksPerSecond(const Outcome& outcome) {
  return outcome.seconds > 0 ? outcome.compared / outcome.seconds : 0;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

// Empty when all is equal. Ends in a newline.
std::string failureText(const Outcome& outcome) {
  const std::string& name = outcome.file;
  if (outcome.desync) {
    return name + ": the two sides part in tick " + std::to_string(outcome.desync->tick) + ":\n" + outcome.desyncText;
  }
  if (outcome.first) {
    std::string text = name + ": tick " + std::to_string(outcome.first->tick) +
                       " is the first that differs: recorded " + hexadecimal(outcome.first->recorded) + ", computed " +
                       hexadecimal(outcome.first->actual);
    if (outcome.fields) {
      text += outcome.fields->fields.empty()
                  ? "; by tick " + std::to_string(outcome.fields->tick) + " all fields are equal again"
                  : "; by tick " + std::to_string(outcome.fields->tick) + " " + listed(outcome.fields->fields) +
                        (outcome.fields->fields.size() == 1 ? " differs" : " differ");
    }
    if (!outcome.fields && outcome.compared == outcome.ticks) text += "; no hashes by field are kept from there on";
    if (!outcome.reference.empty()) text += "; so it is on both sides";
    return text + "; see docs/design/determinism.md for how to find the cause.\n";
  }
  if (!outcome.wrong.empty()) return name + ": " + outcome.wrong + "\n";
  return outcome.error.empty() ? "" : outcome.error + "\n";
}

}  // namespace

void sayOutcome(const Outcome& outcome, bool quiet) {
  const bool differs = outcome.first || outcome.desync || !outcome.wrong.empty();
  if (!quiet && (outcome.code == ExitCode::fine || differs)) {
    const std::string beside = outcome.reference.empty() ? "" : ", beside " + outcome.reference;
    std::printf("%s %s: %s of %s ticks compared, %s ticks/s, %s%s\n", differs ? "DESYNC  " : "equal   ",
                outcome.file.c_str(), withCommas(outcome.compared).c_str(), withCommas(outcome.ticks).c_str(),
                oneDecimal(ticksPerSecond(outcome)).c_str(), outcome.device.c_str(), beside.c_str());
    std::fflush(stdout);
  }
  std::fputs(failureText(outcome).c_str(), stderr);
}

nlohmann::ordered_json outcomeJson(const Outcome& outcome) {
  nlohmann::ordered_json json;
  json["file"] = outcome.file;
  json["equal"] = outcome.code == ExitCode::fine;
  json["exitCode"] = int(outcome.code);
  json["device"] = outcome.device;
  if (!outcome.reference.empty()) json["reference"] = outcome.reference;
  json["ticks"] = outcome.ticks;
  json["ticksCompared"] = outcome.compared;
  json["ticksPerSecond"] = ticksPerSecond(outcome);
  if (outcome.first) {
    json["firstDifference"] = {{"tick", outcome.first->tick},
                               {"recorded", hexadecimal(outcome.first->recorded)},
                               {"computed", hexadecimal(outcome.first->actual)}};
  }
  if (outcome.fields) json["fields"] = {{"tick", outcome.fields->tick}, {"differ", outcome.fields->fields}};
  if (outcome.desync) {
    json["desync"] = desyncJson(*outcome.desync,
                                {outcome.device, outcome.reference, outcome.config.rules, outcome.recordedAtDesync});
  }
  if (!outcome.wrong.empty()) json["wrong"] = outcome.wrong;
  if (!outcome.error.empty()) json["error"] = outcome.error;
  factsToJson(json, outcome.facts, outcome.config);
  return json;
}

std::string junitXml(const std::vector<Outcome>& outcomes) {
  std::vector<JunitCase> cases;
  for (const Outcome& outcome : outcomes) {
    JunitCase test{"gpuwars.verify", outcome.file, outcome.seconds};
    if (outcome.code != ExitCode::fine) {
      test.result = outcome.code == ExitCode::desync ? JunitCase::Result::failure : JunitCase::Result::error;
      test.text = failureText(outcome);
      test.message = test.text.substr(0, test.text.find('\n'));
    }
    cases.push_back(std::move(test));
  }
  return junitXml("gpuwars verify", cases);
}

}  // namespace gw

// gpuwars diff A B: where two recorded runs part.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "game/cli/diff_options.h"
#include "game/commands/json_output.h"
#include "game/replay/replay_diff.h"
#include "game/replay/replay_reader.h"
#include "host/platform/number_format.h"

namespace gw {
namespace {

using Json = nlohmann::ordered_json;

std::string inputText(const InputRecord& input) {
  return fmt::format("move {},{} aim {} buttons {:#x}", input.move_x, input.move_y, input.aim, input.buttons);
}

std::string fieldsText(const FieldsDifference& difference) {
  if (difference.fields.empty()) return fmt::format("none at tick {}: by then both are equal again", difference.tick);
  std::string text;
  for (const uint32_t field : difference.fields) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", kHashFieldNames[field]);
  }
  return fmt::format("{} at tick {}", text, difference.tick);
}

std::string resultText(const Replay& replay) {
  if (!replay.whole) return fmt::format("{} ticks, then it is cut short", withCommas(replay.ticks()));
  return fmt::format("{} ticks, score {}, {} kills, {}", withCommas(replay.ticks()), withCommas(replay.result.score),
                     withCommas(replay.result.kills), replay.result.over ? "over" : "not over");
}

// A line for each kind of difference; what differs in A, then in B.
void print(const ReplayDiff& diff, const Replay& a, const Replay& b, const DiffOptions& options) {
  const std::string nameA = options.files[0].string(), nameB = options.files[1].string();
  if (diff.same()) {
    fmt::print("same run: {} and {}: {}\n", nameA, nameB, resultText(a));
    return;
  }
  fmt::print("they differ: {} | {}\n", nameA, nameB);
  const auto line = [](const char* what, const std::string& text) { fmt::print("{:<8} {}\n", what, text); };
  for (const NamedDifference& d : diff.header) line("header", fmt::format("{}: {} | {}", d.name, d.a, d.b));
  for (const TableDifference& d : diff.tables) {
    line("table", fmt::format("{} from line {} on: '{}' | '{}'", d.file, d.line, d.a, d.b));
  }
  if (diff.input) {
    line("input",
         fmt::format("from tick {} on: {} | {}", diff.input->tick, inputText(diff.input->a), inputText(diff.input->b)));
  }
  if (diff.hash) {
    line("hash", fmt::format("from tick {} on: {} | {}", diff.hash->tick, hexadecimal(diff.hash->a),
                             hexadecimal(diff.hash->b)));
    line("fields", diff.fields ? fieldsText(*diff.fields) : "not recorded at or after that tick in both");
  }
  if (!diff.input && !diff.hash) {
    line("equal", fmt::format("in the {} ticks that both have", withCommas(std::min(diff.ticks_a, diff.ticks_b))));
  }
  line("result", fmt::format("{} | {}", resultText(a), resultText(b)));
}

Json named(const std::vector<NamedDifference>& differences) {
  Json json = Json::array();
  for (const NamedDifference& d : differences) json.push_back({{"name", d.name}, {"a", d.a}, {"b", d.b}});
  return json;
}

Json inputJson(const InputRecord& input) {
  return {{"move_x", input.move_x}, {"move_y", input.move_y}, {"aim", input.aim}, {"buttons", input.buttons}};
}

Json fileJson(const std::filesystem::path& file, const Replay& replay) {
  Json json{{"file", file.string()}, {"ticks", replay.ticks()}, {"whole", replay.whole}};
  if (replay.whole) {
    json["result"] = {{"score", replay.result.score},
                      {"kills", replay.result.kills},
                      {"frameTime_us", replay.result.frameTime_us},
                      {"over", replay.result.over}};
  }
  return json;
}

// What does not differ is null or empty.
Json toJson(const ReplayDiff& diff, const Replay& a, const Replay& b, const DiffOptions& options) {
  Json json;
  json["same"] = diff.same();
  json["a"] = fileJson(options.files[0], a);
  json["b"] = fileJson(options.files[1], b);
  json["header"] = named(diff.header);
  json["tables"] = Json::array();
  for (const TableDifference& d : diff.tables) {
    json["tables"].push_back({{"file", d.file}, {"line", d.line}, {"a", d.a}, {"b", d.b}});
  }
  json["input"] = nullptr;
  if (diff.input) {
    json["input"] = {{"tick", diff.input->tick}, {"a", inputJson(diff.input->a)}, {"b", inputJson(diff.input->b)}};
  }
  json["hash"] = nullptr;
  if (diff.hash) {
    json["hash"] = {{"tick", diff.hash->tick}, {"a", hexadecimal(diff.hash->a)}, {"b", hexadecimal(diff.hash->b)}};
  }
  json["fields"] = nullptr;
  if (diff.fields) {
    json["fields"] = {{"tick", diff.fields->tick}, {"names", Json::array()}};
    for (const uint32_t field : diff.fields->fields) json["fields"]["names"].push_back(kHashFieldNames[field]);
  }
  json["result"] = named(diff.result);
  return json;
}

}  // namespace

ExitCode runVerb(const DiffOptions& options) {
  const auto read = [&](size_t index) {
    return readReplay(options.files[index], SimulationVersions::any, Completeness::partial);
  };
  const Replay a = read(0), b = read(1);
  const ReplayDiff diff = diffReplays(a, b);
  if (options.jsonPath != "-") print(diff, a, b, options);
  if (!options.jsonPath.empty()) writeJson(options.jsonPath, toJson(diff, a, b, options));
  return diff.same() ? ExitCode::fine : ExitCode::differ;
}

}  // namespace gw

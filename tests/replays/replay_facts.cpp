// replay_facts [--hashes] [--played] FILE
// What a replay holds, of whatever simulation version, and what no report of it tells, as JSON: how extreme its inputs
// are; with --played (today's version only) where the ship went, and how many enemies stood at exactly one place.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "game/replay/replay_reader.h"
#include "game/ui/mode_choice.h"

namespace gw {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kDiagonal = 23170;  // a component of two keys' move: 32767 / sqrt(2)

bool fromKeys(const InputRecord& input) {
  const int x = std::abs(int(input.move_x)), y = std::abs(int(input.move_y));
  return (x == kStickFull && y == 0) || (x == 0 && y == kStickFull) || (x == kDiagonal && y == kDiagonal);
}

void addInputs(Json& json, const std::vector<InputRecord>& inputs) {
  uint32_t square = 0, halfTurns = 0, presses = 0, allButtons = 0, analogue = 0, keyMoves = 0, idle = 0, longest = 0;
  InputRecord before{};
  for (const InputRecord& input : inputs) {
    const bool still = input.move_x == 0 && input.move_y == 0;
    square += std::abs(int(input.move_x)) == kStickFull && std::abs(int(input.move_y)) == kStickFull;
    halfTurns += uint16_t(input.aim - before.aim) == 32768;
    presses += (input.buttons & ~before.buttons) != 0;
    allButtons += input.buttons == kButtonsKnown;
    keyMoves += fromKeys(input);
    analogue += !still && std::abs(int(input.move_x)) < kStickFull && std::abs(int(input.move_y)) < kStickFull &&
                !fromKeys(input);
    idle = input == InputRecord{} ? idle + 1 : 0;
    longest = std::max(longest, idle);
    before = input;
  }
  json["squareSticks_ticks"] = square;  // both components full, which no stick reaches
  json["halfTurns"] = halfTurns;        // of the aim, from one tick to the next
  json["presses"] = presses;            // ticks in which a button went down
  json["allButtons_ticks"] = allButtons;
  json["analogueMoves_ticks"] = analogue;
  json["keyMoves_ticks"] = keyMoves;
  json["idle_ticks"] = longest;  // the longest time without any input
}

void addPlayed(Json& json, const Replay& replay) {
  const std::unique_ptr<Simulation> simulation = cpu::makeSimulation(replayConfig(replay));
  constexpr float kNear_m = 2;
  bool corner[4] = {};
  uint32_t together = 0, alone = 0;
  for (const InputRecord& input : replay.inputs) {
    simulation->tick(input);
    const TickReport report = simulation->report();
    const bool left = report.ship_x<kNear_m, right = report.ship_x> simulation->worldWidth_m() - kNear_m;
    const bool low = report.ship_y<kNear_m, high = report.ship_y> simulation->worldHeight_m() - kNear_m;
    if ((left || right) && (low || high)) corner[right * 2 + high] = true;
    std::map<std::pair<float, float>, uint32_t> places;
    for (const EntityRecord& entity : simulation->snapshot().entities) {
      if (entity.type < kMaxEnemyTypes && entity.state != uint32_t(State::dead)) {
        together = std::max(together, ++places[{entity.x, entity.y}]);
      }
    }
    alone += report.enemies == 0;
  }
  json["corners"] = std::count(std::begin(corner), std::end(corner), true);
  json["atOnePlace"] = together;  // the most living enemies that ever stood at exactly one place
  json["alone_ticks"] = alone;    // without any enemy
}

}  // namespace

Json factsOf(const char* file, bool hashes, bool played) {
  const Replay replay = readReplay(file, played ? SimulationVersions::current : SimulationVersions::any);
  Json json;
  json["mode"] = std::string(modeName(replay.header.mode));
  json["enemiesFit"] = replay.header.enemies;
  json["ticks"] = replay.ticks();
  json["score"] = replay.result.score;
  json["kills"] = replay.result.kills;
  json["over"] = replay.result.over;
  json["options"] = replay.header.options;
  addInputs(json, replay.inputs);
  if (played) addPlayed(json, replay);
  if (hashes) json["hashes"] = replay.hashes;
  return json;
}

}  // namespace gw

int main(int argc, char** argv) {
  bool hashes = false, played = false;
  int at = 1;
  for (; at + 1 < argc; ++at) {
    const std::string option = argv[at];
    hashes |= option == "--hashes";
    played |= option == "--played";
    if (option != "--hashes" && option != "--played") break;
  }
  if (at + 1 != argc) {
    std::fprintf(stderr, "Usage: replay_facts [--hashes] [--played] FILE\n");
    return 2;
  }
  try {
    std::printf("%s\n", gw::factsOf(argv[at], hashes, played).dump().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}

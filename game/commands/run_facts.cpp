#include "game/commands/run_facts.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "game/ui/mode_choice.h"
#include "host/platform/number_format.h"

namespace gw {

namespace {

const char* endingName(Ending ending) {
  constexpr const char* kNames[] = {"none", "frame_rate", "time_up", "cleared"};
  return kNames[uint32_t(ending)];
}

}  // namespace

void RunFacts::add(const TickReport& report) {
  travelled_m += std::hypot(double(report.ship_x) - double(report.shipPrevious_x),
                            double(report.ship_y) - double(report.shipPrevious_y));
  for (uint32_t pan = 0; pan < kPans; ++pan) {
    shots += report.sounds[uint32_t(SoundEvent::shot)][pan];
    flushes += report.sounds[uint32_t(SoundEvent::flush)][pan];
  }
  for (uint32_t m = 0; m < kMachines; ++m) {
    for (uint32_t from = 0; from < kStates; ++from) {
      for (uint32_t to = 0; to < kStates; ++to) edges.taken[m][from][to] += report.edges.taken[m][from][to];
    }
  }
  last = report;
}

void factsToJson(nlohmann::ordered_json& json, const RunFacts& facts, const SimulationConfig& config) {
  const Rules& rules = config.rules;
  const TickReport& last = facts.last;
  json["mode"] = std::string(modeName(config.mode));
  json["enemiesFit"] = config.enemies;
  json["score"] = last.score;
  json["kills"] = last.kills;
  json["over"] = last.over != 0;
  json["ending"] = endingName(last.ending);
  json["travelled_m"] = facts.travelled_m;
  json["shots"] = facts.shots;
  json["flushes"] = facts.flushes;
  json["contacts"] = last.contacts;
  json["bitsTaken"] = last.bitsTaken;
  json["peakEnemies"] = last.peakEnemies;
  json["enemiesLeft"] = last.enemies;
  json["refused"] = last.refused;
  for (uint32_t t = 0; t < rules.enemyTypeCount; ++t) json["killsByType"][rules.enemies[t].name] = last.killsByType[t];
  for (uint32_t m = 0; m < kMachines; ++m) {
    for (uint32_t from = 0; from < kStates; ++from) {
      for (uint32_t to = 0; to < kStates; ++to) {
        if (!hasEdge(Machine(m), State(from), State(to))) continue;
        json["edges"][nameOf(Machine(m))][std::string(nameOf(State(from))) + " -> " + nameOf(State(to))] =
            facts.edges.taken[m][from][to];
      }
    }
  }
  json["lastHash"] = hexadecimal(last.hash);
}

}  // namespace gw

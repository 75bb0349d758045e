#include "game/desync/desync_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <nlohmann/json.hpp>

namespace gw {
namespace {

float realOf(uint64_t bits) {
  return std::bit_cast<float>(uint32_t(bits));
}

std::string typeName(uint64_t type, const Rules& rules) {
  if (type < rules.enemyTypeCount) return rules.enemies[type].name;
  if (type == kTypeShot) return "shot";
  if (type == kTypeBit) return "bit";
  return type == kTypeNone ? "none" : fmt::format("type {}", type);
}

// As a number and as bits.
std::string text(const FieldValue& value, const Rules& rules, bool ofEnemy = true) {
  if (value.field == "type") return fmt::format("{} ({})", value.bits, typeName(value.bits, rules));
  if (value.kind == ValueKind::real) return fmt::format("{:.9g} ({:08x})", realOf(value.bits), value.bits);
  if (ofEnemy && value.field == "state" && value.bits < kStates) {
    return fmt::format("{} ({})", value.bits, nameOf(State(value.bits)));
  }
  return fmt::format("{} ({:x})", value.bits, value.bits);
}

std::string nearText(const std::vector<NearEntity>& near, const Rules& rules) {
  std::string line;
  for (const NearEntity& entity : near) {
    line += fmt::format("{}{} {} at {:.3f} m", line.empty() ? "" : ", ", entity.id, typeName(entity.type, rules),
                        entity.distance_m);
  }
  return line.empty() ? "none" : line;
}

// The two values of each field of the entity, those that differ marked.
std::string entityText(const Desync& desync, const DesyncNames& names) {
  std::string lines;
  const bool ofEnemy = !desync.entity[0].empty() && desync.entity[0][0].bits < kMaxEnemyTypes;
  for (const FieldValue& own : desync.entity[0]) {
    const auto other = std::find_if(desync.entity[1].begin(), desync.entity[1].end(),
                                    [&](const FieldValue& value) { return value.field == own.field; });
    if (other == desync.entity[1].end()) continue;
    lines +=
        fmt::format("  {} {:<13} {:<28} {}\n", own == *other ? ' ' : '*', own.field, text(own, names.rules, ofEnemy),
                    own == *other ? "the same" : text(*other, names.rules, ofEnemy));
  }
  return lines;
}

std::string whoAgrees(const Desync& desync, const DesyncNames& names) {
  if (!names.recorded) return "";
  const char* who = desync.hashes[0] == *names.recorded   ? "this side"
                    : desync.hashes[1] == *names.recorded ? "the reference"
                                                          : "neither";
  return fmt::format("  recorded      {:016x}  {} agrees\n", *names.recorded, who);
}

nlohmann::ordered_json valueJson(const FieldValue& value) {
  nlohmann::ordered_json json;
  if (value.kind == ValueKind::real) {
    json["number"] = realOf(value.bits);
  } else {
    json["number"] = value.bits;
  }
  json["bits"] = fmt::format("{:x}", value.bits);
  return json;
}

nlohmann::ordered_json nearJson(const std::vector<NearEntity>& near, const Rules& rules) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const NearEntity& entity : near) {
    list.push_back({{"entity", entity.id}, {"type", typeName(entity.type, rules)}, {"distance_m", entity.distance_m}});
  }
  return list;
}

nlohmann::ordered_json entityJson(const std::vector<FieldValue>& entity) {
  nlohmann::ordered_json json;
  for (const FieldValue& value : entity) json[value.field] = valueJson(value);
  return json;
}

}  // namespace

std::string desyncText(const Desync& desync, const DesyncNames& names) {
  std::string lines = fmt::format(
      "  tick          {}\n"
      "  this side     {:016x}  {}\n"
      "  reference     {:016x}  {}\n",
      desync.tick, desync.hashes[0], names.own, desync.hashes[1], names.reference);
  lines += whoAgrees(desync, names);
  if (!desync.unplaced.empty()) {
    return lines + fmt::format("  Where could not be found out: {}\n", desync.unplaced);
  }
  if (desync.stage.empty()) {
    return lines +
           "  Played again, from the last snapshot and from the start, the two were equal: something that is no "
           "state, as a race or uninitialised memory, made them part.\n";
  }
  lines += fmt::format("  stage         {}\n", desync.stage);
  if (desync.fromStart) {
    lines += "  Only a run from the start parts again: what makes it part is not in the snapshots.\n";
  }
  if (desync.field.empty()) {
    return lines + "  All values are equal after every stage, only their hashes are not: look at hash.cu.\n";
  }
  if (desync.id) {
    lines +=
        fmt::format("  entity        {} ({})\n", *desync.id,
                    typeName(desync.entity[0].empty() ? uint64_t(kTypeNone) : desync.entity[0][0].bits, names.rules));
  }
  lines += fmt::format("  field         {}: {} here, {} in the reference\n", desync.field,
                       text(desync.values[0], names.rules), text(desync.values[1], names.rules));
  std::string differing;
  for (const std::string& field : desync.fields) differing += (differing.empty() ? "" : ", ") + field;
  lines += fmt::format("  differing     {}\n", differing);
  if (desync.id && desync.entities > 1)
    lines += fmt::format("  entities      {} differ in {}\n", desync.entities, desync.field);
  if (!desync.id) return lines;
  lines += entityText(desync, names);
  if (desync.around[0] == desync.around[1]) {
    return lines + fmt::format("  near it       {}\n", nearText(desync.around[0], names.rules));
  }
  return lines + fmt::format("  near it       here: {}\n                reference: {}\n",
                             nearText(desync.around[0], names.rules), nearText(desync.around[1], names.rules));
}

nlohmann::ordered_json desyncJson(const Desync& desync, const DesyncNames& names) {
  nlohmann::ordered_json json;
  json["tick"] = desync.tick;
  const auto both = [&](const char* key, const auto& of) { json[key] = {{"own", of(0)}, {"reference", of(1)}}; };
  both("sides", [&](size_t side) { return side == 0 ? names.own : names.reference; });
  both("hashes", [&](size_t side) { return fmt::format("{:016x}", desync.hashes[side]); });
  if (names.recorded) json["recorded"] = fmt::format("{:016x}", *names.recorded);
  if (!desync.unplaced.empty()) {
    json["unplaced"] = desync.unplaced;
    return json;
  }
  json["partsAgain"] = !desync.stage.empty();
  if (desync.stage.empty()) return json;
  json["fromStart"] = desync.fromStart;
  json["stage"] = desync.stage;
  if (desync.field.empty()) return json;
  json["field"] = desync.field;
  both("values", [&](size_t side) { return valueJson(desync.values[side]); });
  json["fieldsDiffering"] = desync.fields;  // in the order in which they are looked at
  if (!desync.id) return json;
  json["entity"] = *desync.id;
  json["entitiesDiffering"] = desync.entities;
  both("entities", [&](size_t side) { return entityJson(desync.entity[side]); });
  both("near", [&](size_t side) { return nearJson(desync.around[side], names.rules); });
  return json;
}

}  // namespace gw

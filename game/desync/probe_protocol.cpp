#include "game/desync/probe_protocol.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace gw {
namespace {

using nlohmann::json;

json fieldsJson(const std::vector<FieldHash>& fields) {
  json list = json::array();
  for (const FieldHash& field : fields) list.push_back({field.field, field.hash});
  return list;
}

std::vector<FieldHash> fieldsFrom(const json& list) {
  std::vector<FieldHash> fields;
  for (const json& field : list) fields.push_back({field.at(0).get<std::string>(), field.at(1).get<uint64_t>()});
  return fields;
}

json answer(Probe& probe, const json& question) {
  const std::string what = question.at("do").get<std::string>();
  const auto word = [&](const char* key) { return question.at(key).get<std::string>(); };
  const auto number = [&](const char* key) { return question.at(key).get<uint32_t>(); };
  if (what == "play") return {{"hashes", probe.play(number("ticks"))}};
  if (what == "playByStages") return {{"stages", toJson(probe.playByStages())}};
  if (what == "blocks") return {{"hashes", probe.blocks(word("stage"), word("field"))}};
  if (what == "values") return {{"values", probe.values(word("stage"), word("field"), number("block"))}};
  if (what == "global") return {{"value", toJson(probe.global(word("stage"), word("field")))}};
  if (what == "around") return {{"near", toJson(probe.around(word("stage"), number("id"), number("count")))}};
  if (what == "entity") {
    json values = json::array();
    for (const FieldValue& value : probe.entity(word("stage"), number("id"))) values.push_back(toJson(value));
    return {{"values", values}};
  }
  if (what == "keep") {
    probe.keep();
  } else if (what == "goBack") {
    probe.goBack();
  } else if (what == "restart") {
    probe.restart();
  } else {
    throw std::invalid_argument("This program does not know the question '" + what + "'.");
  }
  return json::object();
}

}  // namespace

void serveProbe(Probe& probe, const std::function<bool(std::string&)>& read,
                const std::function<void(const std::string&)>& write) {
  write(json{{"gpuwarsProbe", kProbeProtocol}, {"name", probe.name()}}.dump());
  for (std::string line; read(line);) {
    json reply;
    try {
      reply = answer(probe, json::parse(line));
    } catch (const std::exception& error) {
      reply = {{"error", error.what()}};
    }
    write(reply.dump());
  }
}

json toJson(const std::vector<StageHashes>& stages) {
  json list = json::array();
  for (const StageHashes& stage : stages) {
    list.push_back(
        {{"stage", stage.stage}, {"entities", fieldsJson(stage.entities)}, {"globals", fieldsJson(stage.globals)}});
  }
  return list;
}

std::vector<StageHashes> stagesFrom(const json& list) {
  std::vector<StageHashes> stages;
  for (const json& stage : list) {
    stages.push_back(
        {stage.at("stage").get<std::string>(), fieldsFrom(stage.at("entities")), fieldsFrom(stage.at("globals"))});
  }
  return stages;
}

json toJson(const FieldValue& value) {
  return json::array({value.field, uint32_t(value.kind), value.bits});
}

FieldValue valueFrom(const json& value) {
  return {value.at(0).get<std::string>(), ValueKind(value.at(1).get<uint32_t>()), value.at(2).get<uint64_t>()};
}

json toJson(const std::vector<NearEntity>& near) {
  json list = json::array();
  for (const NearEntity& entity : near) list.push_back({entity.id, entity.type, entity.distance_m});
  return list;
}

std::vector<NearEntity> nearFrom(const json& list) {
  std::vector<NearEntity> near;
  for (const json& entity : list) {
    near.push_back({entity.at(0).get<uint32_t>(), entity.at(1).get<uint32_t>(), entity.at(2).get<float>()});
  }
  return near;
}

}  // namespace gw

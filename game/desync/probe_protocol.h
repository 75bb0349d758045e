// What two processes say to each other about one run: a line of JSON each way, a question and its answer.
//
//   -> {"do": "play", "ticks": 60}                       <- {"hashes": [..]}
//   -> {"do": "keep"}  "goBack"  "restart"               <- {}
//   -> {"do": "playByStages"}                            <- {"stages": [{"stage", "entities": [[field, hash]..],
//   "globals": ..}]}
//   -> {"do": "blocks", "stage": .., "field": ..}        <- {"hashes": [..]}
//   -> {"do": "values", .., "block": 3}                  <- {"values": [..]}
//   -> {"do": "global", "stage": .., "field": ..}        <- {"value": [field, kind, bits]}
//   -> {"do": "entity", "stage": .., "id": 7}            <- {"values": [[field, kind, bits]..]}
//   -> {"do": "around", .., "id": 7, "count": 6}         <- {"near": [[id, type, distance]..]}
//
// The first line is the answering side's: {"gpuwarsProbe": 1, "name": "cpu, 2 threads"}. What fails is answered by
// {"error": "one sentence"}. Later versions may add questions and fields; who changes the meaning of one counts up.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "game/desync/probe.h"

namespace gw {

inline constexpr uint32_t kProbeProtocol = 1;

// Answers questions until `read` says that there are no more. `write` takes whole lines without their ends.
void serveProbe(Probe& probe, const std::function<bool(std::string&)>& read,
                const std::function<void(const std::string&)>& write);

nlohmann::json toJson(const std::vector<StageHashes>& stages);
nlohmann::json toJson(const FieldValue& value);
nlohmann::json toJson(const std::vector<NearEntity>& near);
// These throw nlohmann::json::exception on anything else.
std::vector<StageHashes> stagesFrom(const nlohmann::json& json);
FieldValue valueFrom(const nlohmann::json& json);
std::vector<NearEntity> nearFrom(const nlohmann::json& json);

}  // namespace gw

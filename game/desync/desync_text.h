// A desync in words and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "game/desync/desync_finder.h"

namespace gw {

struct DesyncNames {
  std::string own, reference;          // what the sides are called
  const Rules& rules;                  // for the names of types
  std::optional<uint64_t> recorded{};  // the replay's hash of the tick
};

// Lines, the last one ended too.
std::string desyncText(const Desync& desync, const DesyncNames& names);

nlohmann::ordered_json desyncJson(const Desync& desync, const DesyncNames& names);

}  // namespace gw

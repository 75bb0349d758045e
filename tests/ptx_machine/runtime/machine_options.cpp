#include "tests/ptx_machine/runtime/machine_options.h"

#include <charconv>
#include <optional>
#include <string_view>

namespace gw::ptx {
namespace {

// What stands behind "name=", if that is what the option begins with.
std::optional<std::string_view> valueOf(std::string_view option, std::string_view name) {
  if (!option.starts_with(name) || option.size() == name.size() || option[name.size()] != '=') return std::nullopt;
  return option.substr(name.size() + 1);
}

bool takeEngine(Engine& engine, std::string_view value) {
  if (value == "interpreter") {
    engine = Engine::interpreter;
  } else if (value == "translated") {
    engine = Engine::translated;
  } else {
    return false;
  }
  return true;
}

bool takeOrder(Order& order, std::string_view value) {
  if (value == "ascending") {
    order = Order::ascending;
  } else if (value == "reversed") {
    order = Order::reversed;
  } else if (value == "shuffled") {
    order = Order::shuffled;
  } else {
    return false;
  }
  return true;
}

bool takeSeed(uint64_t& seed, std::string_view value) {
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), seed);
  return error == std::errc{} && end == value.data() + value.size();
}

}  // namespace

bool takeMachineOption(MachineOptions& options, const std::string& option) {
  if (const auto engine = valueOf(option, "engine")) return takeEngine(options.engine, *engine);
  if (const auto order = valueOf(option, "order")) return takeOrder(options.machine.order, *order);
  if (const auto seed = valueOf(option, "seed")) return takeSeed(options.machine.seed, *seed);
  if (option == "unchecked") {
    options.machine.checkAccesses = options.machine.checkRaces = false;
  } else if (option == "races=off") {
    options.machine.checkRaces = false;
  } else if (option == "stop-at-fault") {
    options.stopAtFault = true;
  } else {
    return false;
  }
  return true;
}

}  // namespace gw::ptx

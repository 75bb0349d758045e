#include "game/desync/remote_probe.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "game/desync/probe_protocol.h"
#include "host/platform/child_process.h"

namespace gw {

using nlohmann::json;

RemoteProbe::RemoteProbe(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                         std::function<bool()> giveUp)
    : program_(program.string()), giveUp_(std::move(giveUp)) {
  try {
    child_ = std::make_unique<ChildProcess>(program, arguments, giveUp_);
    std::string line;
    if (!child_->readLine(line)) {
      refuseToWait();
      throw ProbeError(
          fmt::format("{} ended before it had played anything; give a build of GpuWars that knows 'gpuwars probe', and "
                      "options that it takes",
                      program_));
    }
    const json hello = json::parse(line);
    const uint32_t protocol = hello.at("gpuwarsProbe").get<uint32_t>();
    if (protocol != kProbeProtocol) {
      throw ProbeError(
          fmt::format("{} speaks version {} of the probe's language and this program version {}; build "
                      "the reference from a commit with the same",
                      program_, protocol, kProbeProtocol));
    }
    name_ = hello.at("name").get<std::string>();
  } catch (const json::exception&) {
    throw ProbeError(fmt::format("{} is no build of GpuWars that knows 'gpuwars probe'; give one that is", program_));
  } catch (const std::system_error& error) {
    throw ProbeError(
        fmt::format("{} cannot be started ({}); give the path of a gpuwars program", program_, error.code().message()));
  }
}

RemoteProbe::~RemoteProbe() = default;

template <class Read>
auto RemoteProbe::ask(const json& question, const Read& read) {
  std::string line;
  if (!child_->writeLine(question.dump()) || !child_->readLine(line)) {
    refuseToWait();
    throw ProbeError(
        fmt::format("{} ended while it was asked to '{}'; run it by itself with 'gpuwars verify' to see why", program_,
                    question.at("do").get<std::string>()));
  }
  try {
    const json reply = json::parse(line);
    if (reply.contains("error")) {
      throw ProbeError(fmt::format("{} failed: {}", program_, reply["error"].get<std::string>()));
    }
    return read(reply);
  } catch (const json::exception&) {
    throw answeredElse();
  }
}

void RemoteProbe::refuseToWait() const {
  if (giveUp_ && giveUp_()) throw ProbeError(fmt::format("interrupted while {} was waited for", program_));
}

ProbeError RemoteProbe::answeredElse() const {
  return ProbeError(
      fmt::format("{} answered something else than was asked for; use a build of the same version", program_));
}

namespace {

constexpr auto kNothing = [](const json&) {};
const auto kHashes = [](const json& reply) { return reply.at("hashes").get<std::vector<uint64_t>>(); };

}  // namespace

void RemoteProbe::restart() {
  ask({{"do", "restart"}}, kNothing);
}
void RemoteProbe::keep() {
  ask({{"do", "keep"}}, kNothing);
}
void RemoteProbe::goBack() {
  ask({{"do", "goBack"}}, kNothing);
}
std::vector<uint64_t> RemoteProbe::play(uint32_t ticks) {
  std::vector<uint64_t> hashes = ask({{"do", "play"}, {"ticks", ticks}}, kHashes);
  if (hashes.size() != ticks) throw answeredElse();
  return hashes;
}
std::vector<StageHashes> RemoteProbe::playByStages() {
  return ask({{"do", "playByStages"}}, [](const json& reply) { return stagesFrom(reply.at("stages")); });
}
std::vector<uint64_t> RemoteProbe::blocks(const std::string& stage, const std::string& field) {
  return ask({{"do", "blocks"}, {"stage", stage}, {"field", field}}, kHashes);
}
std::vector<uint64_t> RemoteProbe::values(const std::string& stage, const std::string& field, uint32_t block) {
  return ask({{"do", "values"}, {"stage", stage}, {"field", field}, {"block", block}},
             [](const json& reply) { return reply.at("values").get<std::vector<uint64_t>>(); });
}
FieldValue RemoteProbe::global(const std::string& stage, const std::string& field) {
  return ask({{"do", "global"}, {"stage", stage}, {"field", field}},
             [](const json& reply) { return valueFrom(reply.at("value")); });
}
std::vector<FieldValue> RemoteProbe::entity(const std::string& stage, uint32_t id) {
  return ask({{"do", "entity"}, {"stage", stage}, {"id", id}}, [](const json& reply) {
    std::vector<FieldValue> values;
    for (const json& value : reply.at("values")) values.push_back(valueFrom(value));
    return values;
  });
}
std::vector<NearEntity> RemoteProbe::around(const std::string& stage, uint32_t id, uint32_t count) {
  return ask({{"do", "around"}, {"stage", stage}, {"id", id}, {"count", count}},
             [](const json& reply) { return nearFrom(reply.at("near")); });
}

}  // namespace gw

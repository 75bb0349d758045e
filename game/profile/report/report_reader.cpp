// Reads report.json again. Every refusal names the file and the place in it.
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "game/profile/report/report_json.h"
#include "host/platform/atomic_file.h"

namespace gw::profile {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw FileError(
      fmt::format("{} cannot be read as a report: {}; give the report.json of another session, or profile "
                  "again",
                  file.string(), why));
}

// A key as a sentence may hold it: a user's own may have anything in it.
std::string shown(std::string key) {
  for (char& c : key) {
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  }
  return key;
}

// A value of the file, and where it stands: "cases[0].enemies".
class Value {
 public:
  Value(const fs::path& file, const Json& json, std::string place = "")
      : file_(file), json_(json), place_(std::move(place)) {}

  Value operator[](const char* key) const {
    if (!json_.is_object()) notA("an object");
    const std::string place = place_.empty() ? key : place_ + "." + key;
    const auto child = json_.find(key);
    if (child == json_.end()) refuse(file_, place + " is missing");
    return {file_, *child, place};
  }

  bool has(const char* key) const { return json_.is_object() && json_.contains(key); }

  std::string text() const {
    if (!json_.is_string()) notA("a text");
    return json_.get<std::string>();
  }
  bool truth() const {
    if (!json_.is_boolean()) notA("true or false");
    return json_.get<bool>();
  }
  double number() const {
    if (json_.is_null()) return kUnknown;
    if (!json_.is_number()) notA("a number or null");
    return json_.get<double>();
  }
  template <class Whole>
  Whole whole() const {
    if (!json_.is_number_unsigned() || json_.get<uint64_t>() > std::numeric_limits<Whole>::max()) {
      notA("a whole number in its range");
    }
    return json_.get<Whole>();
  }
  bool isNull() const { return json_.is_null(); }

  template <class Read>
  auto list(const Read& read) const {
    if (!json_.is_array()) notA("a list");
    std::vector<decltype(read(*this))> items;
    items.reserve(json_.size());
    for (size_t i = 0; i < json_.size(); ++i) {
      items.push_back(read(Value(file_, json_[i], place_ + "[" + std::to_string(i) + "]")));
    }
    return items;
  }
  template <class Map, class Read>
  Map map(const Read& read) const {
    if (!json_.is_object()) notA("an object");
    Map items;
    for (const auto& [key, item] : json_.items()) items[key] = read(Value(file_, item, place_ + "." + shown(key)));
    return items;
  }

 private:
  [[noreturn]] void notA(const char* what) const {
    refuse(file_, (place_.empty() ? "its content" : place_) + " is not " + what);
  }

  const fs::path& file_;
  const Json& json_;
  std::string place_;
};

std::string textOf(const Value& json) {
  return json.text();
}
double number(const Value& json) {
  return json.number();
}

Estimate estimate(const Value& json) {
  return {json["value"].number(), json["low"].number(), json["high"].number()};
}

ProcessorState processors(const Value& json) {
  ProcessorState processors;
  processors.allowed = json["allowed"].text();
  processors.quota = json["quota"].number();
  processors.throttled_s = json["throttled_s"].number();
  processors.governor = json["governor"].text();
  processors.turbo = json["turbo"].text();
  processors.clockRange = json["clockRange"].text();
  return processors;
}

Machine machine(const Value& json) {
  Machine machine;
  for (auto [key, member] : {std::pair{"cpu", &Machine::cpu},
                             {"cores", &Machine::cores},
                             {"gpu", &Machine::gpu},
                             {"driver", &Machine::driver},
                             {"renderer", &Machine::renderer},
                             {"compiler", &Machine::compiler},
                             {"flags", &Machine::flags},
                             {"commit", &Machine::commit},
                             {"system", &Machine::system}}) {
    machine.*member = json[key].text();
  }
  for (auto [key, member] : {std::pair{"loadBefore", &Machine::loadBefore},
                             {"loadAfter", &Machine::loadAfter},
                             {"gpuClock_MHz", &Machine::gpuClock_MHz},
                             {"gpuPower_W", &Machine::gpuPower_W},
                             {"gpuTemperature_C", &Machine::gpuTemperature_C}}) {
    machine.*member = json[key].number();
  }
  if (json.has("processors")) machine.processors = processors(json["processors"]);
  return machine;
}

Setup setup(const Value& json) {
  Setup setup;
  for (auto [key, member] : {std::pair{"scene", &Setup::scene},
                             {"about", &Setup::about},
                             {"mode", &Setup::mode},
                             {"device", &Setup::device},
                             {"drawn", &Setup::drawn},
                             {"pacing", &Setup::pacing}}) {
    setup.*member = json[key].text();
  }
  setup.ticks = json["ticks"].whole<uint32_t>();
  setup.warmUp = json["warmUp_ticks"].whole<uint32_t>();
  setup.runs = json["runs"].whole<uint32_t>();
  setup.interrupted = json["interrupted"].truth();
  return setup;
}

Second second(const Value& json) {
  return {json["time_s"].number(), estimate(json["fps"]), json["live"].number(), json["stages_ms"].list(number)};
}

Contender contender(const Value& json) {
  Contender contender;
  contender.name = json["name"].text();
  contender.about = json["about"].text();
  contender.shadow = json["shadow"].truth();
  contender.hash = json["hash"].text();
  contender.runs = json["runs"].list([](const Value& run) { return run.map<MetricValues>(number); });
  contender.overall = json["overall"].map<std::map<std::string, Estimate>>(estimate);
  contender.stages = json["stages"].list(textOf);
  contender.stages_ms = json["stages_ms"].list(number);
  contender.seconds = json["seconds"].list(second);
  contender.histogram = json["histogram"].list([](const Value& bin) {
    return Bin{bin["from_ms"].number(), bin["to_ms"].number(), bin["frames"].whole<uint64_t>()};
  });
  contender.percentiles = json["percentiles"].list([](const Value& point) {
    return CurvePoint{point["percent"].number(), point["frame_ms"].number()};
  });
  contender.tickOverLive = json["tickOverLive"].list([](const Value& point) {
    return CurvePoint{point["live"].number(), point["tick_ms"].number()};
  });
  return contender;
}

Case oneCase(const Value& json) {
  return {json["enemies"].whole<uint32_t>(), json["contenders"].list(contender),
          json["speedUps"].list([](const Value& speedUp) {
            return SpeedUp{speedUp["contender"].text(), estimate(speedUp["upkeepAndGathering"]),
                           estimate(speedUp["tick"]), estimate(speedUp["frame"])};
          })};
}

Growth growth(const Value& json) {
  Growth growth;
  growth.contender = json["contender"].text();
  growth.why = json["why"].text();
  const Value fit = json["fit"];
  if (!fit.isNull()) growth.fit = {fit["factor_ms"].number(), fit["exponent"].number(), fit["r2"].number()};
  return growth;
}

std::string contentOf(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) refuse(path, "it is not there");
  if (!fs::is_regular_file(status)) refuse(path, "it is not a plain file");
  std::ifstream file(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(file), {}};
  if (!file) refuse(path, "the system does not let it be read");
  return content;
}

}  // namespace

Report readReport(const fs::path& path) {
  return reportIn(contentOf(path), path);
}

Report reportIn(const std::string& text, const fs::path& path) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) refuse(path, "it is not JSON, or was cut short");
  const Value root(path, json);
  const auto version = root["gpuwarsProfile"].whole<uint32_t>();
  if (version != kReportVersion) {
    refuse(path, fmt::format("it is of version {}, and this program knows version {}", version, kReportVersion));
  }
  Report report;
  report.machine = machine(root["machine"]);
  report.setup = setup(root["setup"]);
  report.cases = root["cases"].list(oneCase);
  report.growth = root["growth"].list(growth);
  report.stageTimersCost = root["stageTimersCost"].number();
  report.warnings = root["warnings"].list(textOf);
  return report;
}

}  // namespace gw::profile

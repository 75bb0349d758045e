#include "tests/game/profile/report/sample_report.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <random>

namespace gw::profile::test {

namespace {

constexpr const char* kStages[] = {"autopilot", "logic",   "spawn",  "maintain", "think",
                                   "integrate", "collide", "settle", "hash",     "particles"};
constexpr double kShares[] = {0.01, 0.03, 0.02, 0.17, 0.38, 0.08, 0.21, 0.04, 0.05, 0.01};
constexpr int kSeconds = 60, kRuns = 10;

struct Kind {
  const char* name;
  const char* about;
  double factor, exponent, search;  // ms of a tick at one enemy; share of thinking against the first's
  bool shadow;
};
constexpr Kind kKinds[] = {
    {"ngrid", "NGrid, exact gather, frozen rows", 0.00021, 1.03, 1, false},
    {"grid-hashed", "uniform grid, hashed cells, sorted each tick", 0.00032, 1.06, 2.1, false},
    {"brute", "every pair", 0.0000011, 1.95, 9, false},
    {"ngrid-r2", "NGrid, radius 2", 0.0002, 1.0, 0.6, true},
};

class Noise {
 public:
  explicit Noise(uint32_t seed) : random_(seed) {}
  double around(double value, double share) { return value * (1 + share * normal_(random_)); }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

Estimate around(double value, double share) {
  return {value, value * (1 - share), value * (1 + share)};
}

double liveAt(uint32_t enemies, double time_s) {
  return std::round(enemies * (1 - 0.12 * std::exp(-time_s / 6)) - enemies * 0.03 * (1 + std::sin(time_s / 7)) / 2);
}

void addSeconds(Contender& to, const Kind& kind, uint32_t enemies, Noise& noise) {
  for (int i = 0; i < kSeconds; ++i) {
    Second second{i + 0.5, {}, liveAt(enemies, i), {}};
    const double tick_ms = noise.around(kind.factor * std::pow(second.live, kind.exponent), 0.03);
    second.fps = around(1000 / (tick_ms + 0.6), 0.06);
    for (size_t stage = 0; stage < std::size(kStages); ++stage) {
      const double of =
          kShares[stage] * (stage == 4 ? kind.search : 1) * (stage == 6 ? 1 + 0.4 * std::sin(i / 5.0) : 1);
      second.stages_ms.push_back(noise.around(tick_ms * of, 0.04));
    }
    to.seconds.push_back(second);
  }
}

void addFrames(Contender& to, double frame_ms) {
  const double step = std::pow(10, 0.02);
  double from = frame_ms * 0.6;
  for (int i = 0; i < 60; ++i, from *= step) {
    const double distance = std::log(from / frame_ms) * 7, tail = std::log(from / frame_ms / 2.4) * 9;
    const double frames = 3000 * std::exp(-distance * distance) + 60 * std::exp(-tail * tail);
    to.histogram.push_back({from, from * step, uint64_t(frames)});
  }
  for (const double percent : {0., 1., 5., 10., 25., 50., 75., 90., 95., 98., 99., 99.5, 99.9, 99.99, 100.}) {
    const double nines = percent >= 100 ? 4.3 : -std::log10(1 - percent / 100);
    to.percentiles.push_back({percent, frame_ms * (0.75 + 0.3 * nines + 0.12 * nines * nines * nines / 4)});
  }
}

Contender contender(const Kind& kind, uint32_t enemies, Noise& noise) {
  Contender made;
  made.name = kind.name;
  made.about = kind.about;
  made.shadow = kind.shadow;
  made.hash = kind.shadow ? "" : "5d3c1f0a99e2b704";
  const double tick_ms = kind.factor * std::pow(enemies, kind.exponent), frame_ms = tick_ms + 0.6;
  for (int run = 0; run < kRuns; ++run) {
    MetricValues values;
    for (const Metric& metric : metrics()) {
      if (kind.shadow && std::string_view(metric.name).find("gathering") == std::string_view::npos) continue;
      const bool live = std::string_view(metric.name).starts_with("liveEntities");
      values[metric.name] = live ? liveAt(enemies, 0) + run
                                 : noise.around(metric.better == Better::higher ? 1000 / tick_ms : frame_ms, 0.02);
    }
    made.runs.push_back(values);
  }
  for (const auto& [name, value] : made.runs[0]) made.overall[name] = around(value, 0.011);
  if (kind.shadow) return made;
  for (size_t stage = 0; stage < std::size(kStages); ++stage) {
    made.stages.emplace_back(kStages[stage]);
    made.stages_ms.push_back(tick_ms * kShares[stage] * (stage == 4 ? kind.search : 1));
  }
  addSeconds(made, kind, enemies, noise);
  addFrames(made, frame_ms);
  for (double live = enemies * 0.55; live < enemies; live *= 1.12) {
    made.tickOverLive.push_back({live, noise.around(kind.factor * std::pow(live, kind.exponent), 0.05)});
  }
  return made;
}

}  // namespace

Report sampleReport() {
  Noise noise(1);
  Report report;
  report.machine = {"AMD EPYC 7B13",
                    "2 of 2",
                    "NVIDIA H200",
                    "580.65",
                    "llvmpipe (LLVM 15.0.6, 256 bits)",
                    "GCC 12.2.0",
                    "-O3 -DNDEBUG",
                    "0123abc",
                    "Debian GNU/Linux 12",
                    0.31,
                    1.92,
                    1980,
                    214.5,
                    46,
                    ProcessorState{"0-1", 1.5, 0, "performance", "off", "2400 MHz"}};
  report.setup = {"swarm",
                  "Up to 16,384 enemies hunt the ship, which an expert bot steers.",
                  "swarm",
                  "cpu, 2 threads",
                  "offscreen 1280x720",
                  "a tick a frame",
                  3600,
                  120,
                  kRuns,
                  false};
  for (const uint32_t enemies : {1024u, 4096u, 16384u}) {
    Case of{enemies, {}, {}};
    for (const Kind& kind : kKinds) of.contenders.push_back(contender(kind, enemies, noise));
    of.speedUps = {
        {"grid-hashed", around(2.31, 0.03), around(1.97, 0.02), around(1.42, 0.025)},
        {"brute", around(enemies / 900.0, 0.02), around(enemies / 1200.0, 0.02), around(enemies / 1900.0, 0.03)},
        {"ngrid-r2", around(0.82, 0.04), {kUnknown, kUnknown, kUnknown}, {kUnknown, kUnknown, kUnknown}}};
    report.cases.push_back(std::move(of));
  }
  for (const Kind& kind : kKinds) {
    Growth growth{kind.name, {}, ""};
    if (kind.shadow) {
      growth.why = "no tick of it was measured";
    } else {
      growth.fit = PowerFit{kind.factor, kind.exponent, 0.9971};
    }
    report.growth.push_back(growth);
  }
  report.stageTimersCost = 0.013;
  report.warnings = {"The load of the machine was 1.9 after the session, so other programs took time from it."};
  return report;
}

Report hostileReport() {
  const std::string name = "<script>alert(\"&'\")</script>\n\x01\xff\xed\xa0\x80]]>-->";
  Report report;
  report.machine.cpu = name;
  report.setup.scene = "</title></style>" + name;
  report.setup.about = name;
  report.warnings = {name};
  Contender odd;
  odd.name = name;
  odd.about = name;
  odd.hash = name;
  odd.runs = {{{name, 1.0}, {metrics()[0].name, kUnknown}}};
  odd.overall = {{name, {1, 2, 3}}, {metrics()[0].name, {INFINITY, 0, 0}}};
  odd.stages = {name, "b"};
  odd.stages_ms = {kUnknown};
  odd.seconds = {{1, {kUnknown, kUnknown, kUnknown}, 1, {}}, {2, {5, kUnknown, INFINITY}, kUnknown, {1, 2, 3, 4}}};
  odd.histogram = {{0, 1, 5}, {-1, kUnknown, 7}};
  odd.percentiles = {{kUnknown, 1}, {50, 0}, {99, 1e300}, {200, 5}, {-4, 3}};
  odd.tickOverLive = {{0, 0}, {1, 5e-324}, {-1, kUnknown}, {5, 1e-3}};
  report.cases = {
      {0, {}, {}}, {1, {odd, odd}, {{name, {1, 0, INFINITY}, {-3, -5, -1}, {1e200, 1, 1e300}}}}, {1, {}, {}}};
  report.growth = {{name, PowerFit{1e300, 50, kUnknown}, ""}, {"absent", {}, name}};
  return report;
}

namespace {

class Dice {
 public:
  explicit Dice(uint32_t seed) : random_(seed) {}
  uint64_t below(uint64_t end) { return random_() % end; }
  // Any bits at all, so also denormal ones, infinities and NaN.
  double number() {
    const uint64_t bits = random_();
    double value;
    static_assert(sizeof value == sizeof bits);
    std::memcpy(&value, &bits, sizeof value);
    return below(3) == 0 ? double(below(1000)) / 8 : value;
  }
  std::string text() {
    std::string made;
    for (uint64_t i = below(9); i > 0; --i) made += char(' ' + below(95));
    return made;
  }
  Estimate estimate() { return {number(), number(), number()}; }
  template <class Make>
  auto list(const Make& make) {
    std::vector<decltype(make())> items;
    for (uint64_t i = below(4); i > 0; --i) items.push_back(make());
    return items;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace

Report randomReport(uint32_t seed) {
  Dice dice(seed);
  const auto text = [&] { return dice.text(); };
  const auto number = [&] { return dice.number(); };
  const auto point = [&] { return CurvePoint{dice.number(), dice.number()}; };
  Report report;
  report.machine = {text(), text(), text(),   text(),   text(),   text(),   text(),
                    text(), text(), number(), number(), number(), number(), number()};
  if (dice.below(2) == 1) {
    report.machine.processors = ProcessorState{text(), number(), number(), text(), text(), text()};
  }
  report.setup = {
      text(), text(), text(), text(), text(), text(), uint32_t(dice.below(1u << 31) * 2 + 1), 7, 9, dice.below(2) == 1};
  report.cases = dice.list([&] {
    Case of{uint32_t(dice.below(1u << 31)), {}, {}};
    of.contenders = dice.list([&] {
      Contender made{.name = text(),
                     .about = text(),
                     .shadow = dice.below(2) == 1,
                     .hash = text(),
                     .runs = {},
                     .overall = {},
                     .stages = {},
                     .stages_ms = {},
                     .seconds = {},
                     .histogram = {},
                     .percentiles = {},
                     .tickOverLive = {}};
      made.runs = dice.list([&] { return MetricValues{{text(), number()}, {text(), number()}}; });
      made.overall = {{text(), dice.estimate()}, {text(), dice.estimate()}};
      made.stages = dice.list(text);
      made.stages_ms = dice.list(number);
      made.seconds = dice.list([&] { return Second{number(), dice.estimate(), number(), dice.list(number)}; });
      made.histogram = dice.list([&] { return Bin{number(), number(), dice.below(UINT64_MAX)}; });
      made.percentiles = dice.list(point);
      made.tickOverLive = dice.list(point);
      return made;
    });
    of.speedUps = dice.list([&] { return SpeedUp{text(), dice.estimate(), dice.estimate(), dice.estimate()}; });
    return of;
  });
  report.growth = dice.list([&] {
    Growth growth{text(), {}, text()};
    if (dice.below(2) == 1) growth.fit = PowerFit{number(), number(), number()};
    return growth;
  });
  report.stageTimersCost = number();
  report.warnings = dice.list(text);
  return report;
}

}  // namespace gw::profile::test

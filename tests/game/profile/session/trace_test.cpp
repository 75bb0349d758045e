#include "game/profile/session/trace.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace gw::profile {
namespace {

using nlohmann::json;

RunFrames someRun() {
  RunFrames run;
  run.drawn = true;
  run.stages = {"logic", "think"};
  for (uint32_t i = 0; i < 3; ++i) {
    Frame frame;
    frame.tick = i + 1;
    frame.ticks = 1;
    frame.begin_ms = 10.0 * i;
    frame.simulation_ms = 4;
    frame.draw_ms = 2;
    frame.wait_ms = 1;
    frame.live = 77;
    if (i != 1) frame.stages_ms = {1, 2.5f};
    run.frames.push_back(frame);
  }
  return run;
}

std::vector<json> named(const json& trace, const std::string& name) {
  std::vector<json> found;
  for (const json& event : trace.at("traceEvents")) {
    if (event.at("name") == name) found.push_back(event);
  }
  return found;
}

TEST(Trace, IsReadByWhoeverReadsTraceEvents) {
  Trace trace;
  trace.add("a \"quoted\" name", someRun());
  trace.add("another", someRun());
  const json read = json::parse(trace.json());
  EXPECT_EQ(named(read, "process_name").size(), 2u);
  EXPECT_EQ(named(read, "process_name")[0]["args"]["name"], "a \"quoted\" name");
  EXPECT_EQ(named(read, "tick 2").size(), 2u);
  EXPECT_EQ(named(read, "draw").size(), 6u);
  const json tick = named(read, "tick 2")[0];
  EXPECT_EQ(tick["ph"], "X");
  EXPECT_DOUBLE_EQ(tick["ts"].get<double>(), 10000.0);
  EXPECT_DOUBLE_EQ(tick["dur"].get<double>(), 4000.0);
  EXPECT_EQ(tick["args"]["live"], 77);
}

TEST(Trace, LaysStagesOneAfterTheOther) {
  Trace trace;
  trace.add("run", someRun());
  const std::vector<json> think = named(json::parse(trace.json()), "think");
  ASSERT_EQ(think.size(), 2u) << "the second tick was not staged";
  EXPECT_DOUBLE_EQ(think[1]["ts"].get<double>(), 21000.0);
  EXPECT_DOUBLE_EQ(think[1]["dur"].get<double>(), 2500.0);
}

TEST(Trace, KeepsToItsLimitAndMayBeEmpty) {
  Trace trace;
  EXPECT_TRUE(json::parse(trace.json())["traceEvents"].empty());
  RunFrames run = someRun();
  run.frames.resize(Trace::kFrames + 50, run.frames[0]);
  for (size_t i = 0; i < run.frames.size(); ++i) run.frames[i].tick = uint32_t(i + 1);
  trace.add("long", run);
  const json read = json::parse(trace.json());
  EXPECT_EQ(named(read, "draw").size(), Trace::kFrames);
}

}  // namespace
}  // namespace gw::profile

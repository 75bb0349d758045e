// The finder names the very tick, stage, entity and field in which one side was damaged by a single bit.
#include "game/desync/desync_finder.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

#include "game/desync/desync_text.h"
#include "game/desync/local_probe.h"
#include "game/desync/probe_protocol.h"
#include "game/tables/tables.h"
#include "tests/game/desync/damaged_simulation.h"

namespace gw::test {
namespace {

constexpr uint32_t kTicks = 150;

SimulationConfig config() {
  SimulationConfig config;
  config.rules = loadRules(readRuleTexts(GW_ASSETS_DIR));
  config.enemies = 200;
  config.mode = Mode::swarm;  // all are there from the first tick on
  config.threads = 1;
  return config;
}

std::vector<InputRecord> inputs() {
  std::vector<InputRecord> inputs;
  for (uint32_t t = 0; t < kTicks; ++t) inputs.push_back({int16_t(t * 400), 0, uint16_t(t * 700), kButtonFire});
  return inputs;
}

Probe& intact(std::unique_ptr<Probe>& probe) {
  probe = std::make_unique<LocalProbe>([] { return cpu::makeSimulation(config()); }, inputs());
  return *probe;
}

LocalProbe damaged(const DamageAt& at) {
  return {[at] { return std::make_unique<DamagedSimulation>(config(), at); }, inputs()};
}

Lockstep compare(Probe& own, Probe& reference) {
  return playInLockstep(own, reference, kTicks, [](uint32_t) { return true; });
}

constexpr const char* kStages[] = {"think", "integrate", "collide", "settle"};

// A field of an entity, and the first of these stages after which nothing in the tick writes it any more: what is
// written over has not been damaged.
struct Place {
  const char* field;
  uint32_t since;
};
constexpr Place kPlaces[] = {
    {"velocity_x", 2}, {"velocity_y", 2}, {"previous_x", 1},  {"previous_y", 1},  {"force_x", 0},
    {"force_y", 0},    {"energy", 2},     {"direction_x", 1}, {"direction_y", 1}, {"mass", 0},
    {"push_x", 2},     {"push_y", 2},     {"x", 3},           {"y", 3},           {"state", 3},
    {"timer", 2},      {"cooldown", 2},   {"flags", 2},       {"birth_tick", 0},  {"target", 0},
};

// Shots and bits may vanish until collide is done, and with them what was damaged.
bool stays(uint64_t type, uint32_t stage) {
  return stage < 2 ? type < kMaxEnemyTypes : type != kTypeNone;
}

// The processor's memory is read where it lies.
uint32_t cellOf(const std::vector<BytesOfBuffer>& bytes, uint32_t id) {
  for (const BytesOfBuffer& part : bytes) {
    if (part.buffer != "cellOf") continue;
    uint32_t cell;
    std::memcpy(&cell, part.d_bytes + size_t(id) * part.stride, sizeof cell);
    return cell;
  }
  throw std::logic_error("there is no cellOf");
}

TEST(desync_finder, names_tick_stage_entity_and_field_of_a_hundred_flipped_bits) {
  std::unique_ptr<Probe> reference;
  std::mt19937 dice(11);
  uint32_t placed = 0;
  for (uint32_t n = 0; n < 100; ++n) {
    const Place& place = kPlaces[n % std::size(kPlaces)];
    const uint32_t tick = n == 0 ? kTicks : n == 1 ? 1 : 1 + uint32_t(dice() % kTicks);  // the last and the first too
    const uint32_t stageNumber = place.since + uint32_t(dice() % (std::size(kStages) - place.since));
    const std::string stage = kStages[stageNumber];
    const uint32_t bit = uint32_t(dice() % 32), chance = uint32_t(dice());
    uint32_t id = 0;
    LocalProbe own = damaged({tick, stage, [&](Inspection& inspection) {
                                const StageState now = inspection.stateAfter(stage, nullptr);
                                const std::vector<uint64_t>& types = *now.entities[0].values;
                                for (id = chance % types.size(); !stays(types[id], stageNumber);)
                                  id = (id + 1) % types.size();
                                const std::vector<BytesOfBuffer> bytes = inspection.bytes();
                                for (const BytesOfBuffer& part : bytes) {
                                  if (part.part != place.field) continue;
                                  inspection.flip(part, part.byCell ? cellOf(bytes, id) : id, bit);
                                }
                              }});
    const Lockstep lockstep = compare(own, intact(reference));
    ASSERT_TRUE(lockstep.desync) << place.field << " of " << id << ", tick " << tick << ", after " << stage;
    const Desync& found = *lockstep.desync;
    EXPECT_EQ(found.tick, tick);
    EXPECT_EQ(lockstep.hashes.size(), tick);
    EXPECT_EQ(found.stage, stage);
    EXPECT_EQ(found.field, place.field);
    EXPECT_EQ(found.id, id);
    EXPECT_EQ(found.fields, std::vector<std::string>{place.field});
    EXPECT_EQ(found.entities, 1u);
    EXPECT_FALSE(found.fromStart);
    EXPECT_EQ(found.values[0].bits ^ found.values[1].bits, uint64_t(1) << bit);
    placed += found.tick == tick && found.stage == stage && found.field == place.field && found.id == id;
  }
  std::printf("%u of 100 flipped bits placed by tick, stage, entity and field\n", placed);
}

TEST(desync_finder, names_a_global) {
  std::unique_ptr<Probe> reference;
  LocalProbe own = damaged({77, "logic", [](Inspection& inspection) {
                              for (const BytesOfBuffer& part : inspection.bytes()) {
                                if (part.buffer == "globals") inspection.flip(part, 0, 64 + 5);  // of the score
                              }
                            }});
  const Lockstep lockstep = compare(own, intact(reference));
  ASSERT_TRUE(lockstep.desync);
  EXPECT_EQ(lockstep.desync->tick, 77u);
  EXPECT_EQ(lockstep.desync->stage, "logic");
  EXPECT_EQ(lockstep.desync->field, "score");
  EXPECT_FALSE(lockstep.desync->id);
  EXPECT_EQ(lockstep.desync->values[0].bits ^ lockstep.desync->values[1].bits, 32u);
}

// Cells that name another id, tables that are others: values are equal, the hash tells all the same.
TEST(desync_finder, says_that_only_the_hashes_differ) {
  std::unique_ptr<Probe> reference;
  LocalProbe own = damaged({20, "settle", [](Inspection& inspection) {
                              for (const BytesOfBuffer& part : inspection.bytes()) {
                                if (part.buffer == "scratch" && part.part == "hashes") inspection.flip(part, 0, 3);
                              }
                            }});
  const Lockstep lockstep = compare(own, intact(reference));
  ASSERT_TRUE(lockstep.desync);
  EXPECT_EQ(lockstep.desync->tick, 20u);
  EXPECT_EQ(lockstep.desync->stage, "hash");
  EXPECT_EQ(lockstep.desync->field, "");
}

// A side that breaks off when it is asked where: that the two part is known all the same.
TEST(desync_finder, a_desync_that_cannot_be_placed_is_one) {
  struct Breaking : Probe {
    Probe& of;
    explicit Breaking(Probe& of) : of(of) {}
    std::string name() const override { return of.name(); }
    void restart() override { of.restart(); }
    std::vector<uint64_t> play(uint32_t ticks) override { return of.play(ticks); }
    void keep() override { of.keep(); }
    void goBack() override { of.goBack(); }
    std::vector<StageHashes> playByStages() override { throw std::runtime_error("the reference ended."); }
    std::vector<uint64_t> blocks(const std::string&, const std::string&) override { return {}; }
    std::vector<uint64_t> values(const std::string&, const std::string&, uint32_t) override { return {}; }
    FieldValue global(const std::string&, const std::string&) override { return {}; }
    std::vector<FieldValue> entity(const std::string&, uint32_t) override { return {}; }
    std::vector<NearEntity> around(const std::string&, uint32_t, uint32_t) override { return {}; }
  };
  LocalProbe own = damaged({77, "logic", [](Inspection& inspection) {
                              for (const BytesOfBuffer& part : inspection.bytes()) {
                                if (part.buffer == "globals") inspection.flip(part, 0, 69);
                              }
                            }});
  std::unique_ptr<Probe> reference;
  Breaking breaking(intact(reference));
  const Lockstep lockstep = compare(own, breaking);
  ASSERT_TRUE(lockstep.desync);
  EXPECT_EQ(lockstep.desync->tick, 77u);
  EXPECT_NE(lockstep.desync->hashes[0], lockstep.desync->hashes[1]);
  EXPECT_EQ(lockstep.desync->unplaced, "the reference ended.");
  EXPECT_EQ(lockstep.desync->stage, "");
  const Rules rules = config().rules;
  const DesyncNames names{"here", "there", rules, 2};
  EXPECT_NE(desyncText(*lockstep.desync, names).find("Where could not be found out: the reference ended."),
            std::string::npos);
  EXPECT_EQ(desyncJson(*lockstep.desync, names)["unplaced"], "the reference ended.");
}

// What happens once only, as a race does, cannot be placed, and is not said to be.
TEST(desync_finder, admits_what_does_not_happen_again) {
  std::unique_ptr<Probe> reference;
  auto happened = std::make_shared<bool>(false);
  LocalProbe own = damaged({90, "settle", [happened](Inspection& inspection) {
                              if (*happened) return;
                              *happened = true;
                              for (const BytesOfBuffer& part : inspection.bytes()) {
                                if (part.buffer == "globals") inspection.flip(part, 0, 70);
                              }
                            }});
  const Lockstep lockstep = compare(own, intact(reference));
  ASSERT_TRUE(lockstep.desync);
  EXPECT_EQ(lockstep.desync->tick, 90u);
  EXPECT_EQ(lockstep.desync->stage, "");
}

TEST(desync_finder, finds_nothing_where_nothing_is) {
  std::unique_ptr<Probe> reference;
  LocalProbe own{[] {
                   SimulationConfig other = config();
                   other.threads = 3;
                   other.broadPhase = BroadPhase::grid;
                   other.order = VisitOrder::shuffled;
                   return cpu::makeSimulation(other);
                 },
                 inputs()};
  const Lockstep lockstep = compare(own, intact(reference));
  EXPECT_FALSE(lockstep.desync);
  EXPECT_EQ(lockstep.hashes.size(), kTicks);
}

TEST(desync_finder, ends_when_it_is_told_to) {
  std::unique_ptr<Probe> a, b;
  const Lockstep lockstep = playInLockstep(intact(a), intact(b), kTicks, [](uint32_t ticks) { return ticks < 60; });
  EXPECT_TRUE(lockstep.interrupted);
  EXPECT_EQ(lockstep.hashes.size(), 60u);
}

// Stages share what they leave unchanged, and say what they change.
TEST(desync_probe, a_tick_by_stages_has_the_hash_of_a_tick) {
  std::unique_ptr<Probe> whole, staged;
  const uint64_t expected = intact(whole).play(40).back();
  intact(staged).play(39);
  const std::vector<StageHashes> stages = staged->playByStages();
  ASSERT_EQ(stages.size(), 9u);
  EXPECT_EQ(stages.front().stage, "autopilot");
  EXPECT_EQ(stages.back().stage, "hash");
  EXPECT_EQ(staged->play(1), whole->play(1));
  EXPECT_NE(expected, 0u);
}

TEST(desync_protocol, what_is_said_is_understood) {
  std::unique_ptr<Probe> a, b;
  intact(a).play(30);
  intact(b);
  std::vector<std::string> questions{R"({"do":"play","ticks":30})",
                                     R"({"do":"keep"})",
                                     R"({"do":"playByStages"})",
                                     R"({"do":"entity","stage":"think","id":3})",
                                     R"({"do":"around","stage":"think","id":3,"count":4})",
                                     R"({"do":"values","stage":"think","field":"x","block":0})",
                                     R"({"do":"blocks","stage":"think","field":"x"})",
                                     R"({"do":"global","stage":"logic","field":"score"})",
                                     R"({"do":"goBack"})",
                                     R"({"do":"play","ticks":1})",
                                     R"({"do":"dance"})",
                                     "no json",
                                     R"({"do":"values","stage":"think","field":"x","block":9})"};
  std::vector<nlohmann::json> answers;
  size_t asked = 0;
  serveProbe(
      *b,
      [&](std::string& line) {
        if (asked == questions.size()) return false;
        line = questions[asked++];
        return true;
      },
      [&](const std::string& line) { answers.push_back(nlohmann::json::parse(line)); });
  ASSERT_EQ(answers.size(), questions.size() + 1);
  EXPECT_EQ(answers[0]["gpuwarsProbe"], 1);
  a->keep();
  const std::vector<StageHashes> stages = a->playByStages();
  const std::vector<StageHashes> told = stagesFrom(answers[3]["stages"]);
  ASSERT_EQ(told.size(), stages.size());
  for (size_t s = 0; s < told.size(); ++s) {
    EXPECT_EQ(told[s].entities, stages[s].entities);
    EXPECT_EQ(told[s].globals, stages[s].globals);
  }
  EXPECT_EQ(valueFrom(answers[4]["values"][0]), a->entity("think", 3)[0]);
  EXPECT_EQ(nearFrom(answers[5]["near"]), a->around("think", 3, 4));
  EXPECT_EQ(answers[6]["values"].get<std::vector<uint64_t>>(), a->values("think", "x", 0));
  EXPECT_EQ(answers[7]["hashes"].get<std::vector<uint64_t>>(), a->blocks("think", "x"));
  EXPECT_EQ(valueFrom(answers[8]["value"]), a->global("logic", "score"));
  a->goBack();
  EXPECT_EQ(answers[10]["hashes"].get<std::vector<uint64_t>>(), a->play(1));
  for (size_t bad : {11, 12, 13}) EXPECT_TRUE(answers[bad].contains("error")) << bad;
}

TEST(desync_text, says_where_in_words_and_as_json) {
  const Rules rules = config().rules;
  Desync desync{.tick = 312, .hashes = {1, 2}, .stage = "think", .field = "force_x"};
  desync.id = 7;
  desync.fields = {"force_x", "energy"};
  desync.entities = 1;
  desync.values = {FieldValue{"force_x", ValueKind::real, 0x3f800000},
                   FieldValue{"force_x", ValueKind::real, 0x3fa00000}};
  desync.entity[0] = {{"type", ValueKind::whole, 0}, desync.values[0]};
  desync.entity[1] = {{"type", ValueKind::whole, 0}, desync.values[1]};
  desync.around[0] = desync.around[1] = {{9, 3, 0.5f}};
  const DesyncNames names{"here", "there", rules, 2};
  const std::string text = desyncText(desync, names);
  for (const char* part : {"tick          312", "stage         think", "7 (triangle)", "1 (3f800000) here",
                           "1.25 (3fa00000) in the reference", "the reference agrees", "differing     force_x, energy",
                           "9 vertex at 0.500 m"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  const nlohmann::ordered_json json = desyncJson(desync, names);
  EXPECT_EQ(json["stage"], "think");
  EXPECT_EQ(json["entity"], 7);
  EXPECT_EQ(json["values"]["own"]["number"], 1.0);
  EXPECT_EQ(json["values"]["reference"]["bits"], "3fa00000");
  desync.stage.clear();
  EXPECT_NE(desyncText(desync, names).find("no state"), std::string::npos);
  EXPECT_EQ(desyncJson(desync, names)["partsAgain"], false);
}

}  // namespace
}  // namespace gw::test

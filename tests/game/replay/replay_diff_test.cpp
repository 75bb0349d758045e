// Where two runs part, for each thing in which they can.
#include "game/replay/replay_diff.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/game/replay/replay_samples.h"

namespace gw::test {
namespace {

ReplayDiff against(void (*change)(Replay&)) {
  Replay other = longerReplay();
  change(other);
  return diffReplays(longerReplay(), other);
}

TEST(ReplayDiff, EqualRunsAreTheSame) {
  const ReplayDiff diff = against([](Replay&) {});
  EXPECT_TRUE(diff.same());
  EXPECT_EQ(diff.ticks_a, 150u);
}

TEST(ReplayDiff, TheCommandLineAndNamesOfTablesAreForPeople) {
  EXPECT_TRUE(against([](Replay& r) { r.header.options = "--threads 1", r.rules.game.name = "elsewhere"; }).same());
}

TEST(ReplayDiff, NamesEachFieldOfTheHeader) {
  const ReplayDiff diff = against([](Replay& r) {
    r.header = {1, Mode::swarm, 7, Autopilot::none, kSimulationVersion + 1, "", Gather::exact, Sort::bitonic};
  });
  ASSERT_EQ(diff.header.size(), 7u);
  const char* names[] = {"simulation version", "seed", "mode", "enemies", "autopilot", "gather", "sort"};
  for (size_t i = 0; i < 7; ++i) EXPECT_EQ(diff.header[i].name, names[i]);
  EXPECT_EQ(diff.header[2].a, "arcade");
  EXPECT_EQ(diff.header[2].b, "swarm");
  EXPECT_EQ(diff.header[3].a, "8192");
  EXPECT_EQ(diff.header[4].b, "none");
  EXPECT_EQ(diff.header[5].a, "fixed");
  EXPECT_EQ(diff.header[6].a, "odd-even");
  EXPECT_FALSE(diff.same());
}

TEST(ReplayDiff, NamesTheFirstLineOfATableThatDiffers) {
  const auto first = [](const char* a, const char* b) {
    Replay one = sampleReplay(), other = sampleReplay();
    one.rules.waves.text = a;
    other.rules.waves.text = b;
    const ReplayDiff diff = diffReplays(one, other);
    EXPECT_EQ(diff.tables.size(), 1u);
    EXPECT_FALSE(diff.same());
    EXPECT_EQ(diff.tables[0].file, "waves.toml");
    return std::to_string(diff.tables[0].line) + ":" + diff.tables[0].a + "|" + diff.tables[0].b;
  };
  EXPECT_EQ(first("a\nb\nc\n", "a\nx\nc\n"), "2:b|x");
  EXPECT_EQ(first("a\n", "a\nb\n"), "2:|b");
  EXPECT_EQ(first("", "a"), "1:|a");
  EXPECT_EQ(first("a\n\nb", "a\nb"), "2:|b");
  EXPECT_EQ(first("a\nb", "a\nb\n"), "2:b|b");  // only how the line ends
}

TEST(ReplayDiff, FindsTheFirstInputAndHash) {
  const ReplayDiff diff = against([](Replay& r) {
    r.inputs[9].aim ^= 1;
    r.inputs[80].aim ^= 1;
    r.hashes[61] ^= 1;
    r.hashes[130] ^= 1;
    r.fieldHashes[0][0] ^= 1;  // after tick 60, before the hashes differ
    r.fieldHashes[1][uint32_t(HashField::velocity)] ^= 1;
    r.fieldHashes[1][uint32_t(HashField::globals)] ^= 1;
  });
  ASSERT_TRUE(diff.input && diff.hash && diff.fields);
  EXPECT_EQ(diff.input->tick, 10u);
  EXPECT_EQ(diff.input->a.aim ^ diff.input->b.aim, 1);
  EXPECT_EQ(diff.hash->tick, 62u);
  EXPECT_EQ(diff.hash->a ^ diff.hash->b, 1u);
  EXPECT_EQ(diff.fields->tick, 120u);
  EXPECT_EQ(diff.fields->fields, (std::vector<uint32_t>{uint32_t(HashField::velocity), uint32_t(HashField::globals)}));
}

TEST(ReplayDiff, FieldsAreThoseAtOrAfterTheFirstHash) {
  EXPECT_EQ(against([](Replay& r) { r.hashes[0] ^= 1; }).fields->tick, 60u);
  EXPECT_EQ(against([](Replay& r) { r.hashes[59] ^= 1; }).fields->tick, 60u);
  EXPECT_EQ(against([](Replay& r) { r.hashes[60] ^= 1; }).fields->tick, 120u);
  EXPECT_TRUE(against([](Replay& r) { r.hashes[119] ^= 1; }).fields->fields.empty());
  EXPECT_FALSE(against([](Replay& r) { r.hashes[120] ^= 1; }).fields) << "none are stored after it";
  EXPECT_FALSE(against([](Replay& r) { r.hashes[0] ^= 1, r.fieldHashes.clear(); }).fields);
}

TEST(ReplayDiff, AShorterRunIsAnother) {
  const ReplayDiff diff = against([](Replay& r) { r.inputs.pop_back(), r.hashes.pop_back(); });
  EXPECT_FALSE(diff.same());
  EXPECT_FALSE(diff.input || diff.hash);
  EXPECT_EQ(diff.ticks_b, 149u);
}

TEST(ReplayDiff, ComparesResultsWhereBothAreKnown) {
  const ReplayDiff diff = against([](Replay& r) { r.result.score = 9, r.result.over = false; });
  ASSERT_EQ(diff.result.size(), 2u);
  EXPECT_EQ(diff.result[0].name, "score");
  EXPECT_EQ(diff.result[0].a, "123456789012345");
  EXPECT_EQ(diff.result[1].b, "no");
  const ReplayDiff partial = against([](Replay& r) { r.result = {}, r.whole = false; });
  EXPECT_TRUE(partial.result.empty());
  EXPECT_FALSE(partial.same()) << "how it went on is unknown";
}

RC_GTEST_PROP(ReplayDiff, IsTheSameSeenFromTheOtherSide, ()) {
  Replay a = longerReplay(), b = longerReplay();
  for (Replay* replay : {&a, &b}) {
    replay->hashes.at(*rc::gen::inRange<size_t>(0, 150)) ^= *rc::gen::inRange<uint64_t>(0, 2);
    replay->inputs.at(*rc::gen::inRange<size_t>(0, 150)).aim ^= uint16_t(*rc::gen::inRange<int>(0, 2));
    replay->rules.game.text = *rc::gen::container<std::string>(rc::gen::element('a', '\n'));
  }
  const ReplayDiff there = diffReplays(a, b), back = diffReplays(b, a);
  RC_ASSERT(there.same() == back.same());
  RC_ASSERT(there.same() == (a.hashes == b.hashes && a.inputs == b.inputs && a.rules.game.text == b.rules.game.text));
  RC_ASSERT(there.tables.size() == back.tables.size());
  if (!there.tables.empty()) RC_ASSERT(there.tables[0].line == back.tables[0].line);
  RC_ASSERT(there.hash.has_value() == back.hash.has_value());
  if (there.hash) RC_ASSERT(there.hash->tick == back.hash->tick && there.hash->a == back.hash->b);
}

}  // namespace
}  // namespace gw::test

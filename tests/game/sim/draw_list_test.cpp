// The draw list: what is in view, danger on top, within what the target holds.
#include "game/sim/draw/draw_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "game/sim/draw/row_colour.h"
#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

class draw_list : public ::testing::Test {
 protected:
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();
  cpu::DrawList list{fixture.queue(), fixture.limits().capacity};
  const DrawView everything{96.0f, 54.0f, 96.0f, 54.0f};
  DrawArraysCommand command{};

  draw_list() { world.globals.tick = kLateTick; }

  std::vector<SpriteVertex> run(const DrawView& window, uint32_t capacity = 20000) {
    fixture.put(world);
    SpriteVertex untouched{};
    untouched.size_m = -1.0f;
    std::vector<SpriteVertex> vertices(capacity + 1, untouched);
    list.run(fixture.queue(), fixture.view(), window, {vertices.data(), capacity, &command});
    EXPECT_LE(command.instanceCount, capacity);
    EXPECT_EQ(command.vertexCount, 4u);
    EXPECT_EQ(command.firstVertex, 0u);
    EXPECT_EQ(command.baseInstance, 0u);
    for (size_t i = 0; i < vertices.size(); ++i) {
      EXPECT_EQ(vertices[i].size_m > 0.0f, i < command.instanceCount) << i;
    }
    vertices.resize(command.instanceCount);
    return vertices;
  }

  // An announced enemy is drawn larger than it is.
  static constexpr float past_m = 3.2f * 1.2f;

  // Who should be drawn, from the bottom up, as places: all places in a scene differ.
  std::vector<std::pair<float, float>> wanted(const DrawView& window) const {
    std::vector<std::vector<std::pair<float, float>>> layers(4);
    for (const naive::Entity& e : world.entities) {
      if (std::fabs(e.x - window.centre_x) > window.halfWidth_m + past_m) continue;
      if (std::fabs(e.y - window.centre_y) > window.halfHeight_m + past_m) continue;
      if (world.isEnemy(e) && e.state == uint32_t(State::dead)) continue;
      layers[e.type == kTypeBit ? 0 : e.type == kTypeShot ? 1 : world.isAnnounced(e) ? 2 : 3].push_back({e.x, e.y});
    }
    std::vector<std::pair<float, float>> order;
    for (const auto& layer : layers) order.insert(order.end(), layer.begin(), layer.end());
    order.push_back({world.globals.ship.x, world.globals.ship.y});
    return order;
  }
  static std::vector<std::pair<float, float>> places(const std::vector<SpriteVertex>& sprites) {
    std::vector<std::pair<float, float>> found;
    for (const SpriteVertex& s : sprites) found.push_back({s.x, s.y});
    return found;
  }
};

TEST_F(draw_list, is_by_layer_and_id_and_ends_with_the_ship) {
  Dice dice(1);
  addCrowd(world, 250, 400, 3000, 60.0f, dice);  // ids over several blocks
  EXPECT_EQ(places(run(everything)), wanted(everything));
}

TEST_F(draw_list, leaves_out_what_is_out_of_view) {
  Dice dice(2);
  addCrowd(world, 250, 200, 200, 60.0f, dice);
  const DrawView window{80.0f, 60.0f, 15.0f, 9.0f};
  const auto is = places(run(window));
  EXPECT_EQ(is, wanted(window));
  EXPECT_GT(is.size(), 10u);
  EXPECT_LT(is.size(), 200u);
  world.entities.clear();
  EXPECT_EQ(run({10.0f, 10.0f, 1.0f, 1.0f}).size(), 1u);  // the ship is always there
}

TEST_F(draw_list, drops_the_bottom_when_the_target_is_too_small) {
  Dice dice(3);
  addCrowd(world, 200, 100, 1500, 50.0f, dice);
  const auto all = wanted(everything);
  for (const uint32_t capacity : {uint32_t(all.size()), uint32_t(all.size()) - 1, 700u, 120u, 1u, 0u}) {
    SCOPED_TRACE(capacity);
    EXPECT_EQ(places(run(everything, capacity)),
              std::vector(all.end() - std::min<size_t>(capacity, all.size()), all.end()));
  }
}

TEST_F(draw_list, says_how_an_enemy_looks) {
  EntityRecord& hexagon = world.add(enemyAt(rules, 0, 2, 40.0f, 41.0f));
  hexagon.previous_x = 39.5f;
  hexagon.velocity_y = 3.0f;
  hexagon.energy = 8.0f;
  hexagon.flags = kFlagHit;
  EntityRecord& quad = world.add(enemyAt(rules, 1, 1, 50.0f, 41.0f));
  quad.velocity_y = 3.0f;
  quad.birthTick = kLateTick - 20;
  const auto sprites = run(everything);
  ASSERT_EQ(sprites.size(), 3u);
  const SpriteVertex &q = sprites[0], &h = sprites[1];
  EXPECT_EQ(h.previous_x, 39.5f);
  EXPECT_NEAR(h.angle_rad, 1.5707963f, 1e-6f);
  EXPECT_EQ(h.size_m, 1.2f);
  EXPECT_EQ(h.colour, rules.enemies[2].colour);
  EXPECT_EQ(h.shapeFlags, uint32_t(Shape::hexagon) | uint32_t(kSpriteDamaged) << 8 | 127u << 16 | 255u << 24);
  EXPECT_EQ(q.angle_rad, 0.0f);  // a rectangle is drawn as it hits
  EXPECT_EQ(q.shapeFlags, uint32_t(Shape::square) | uint32_t(kSpriteAnnounced) << 8 | 255u << 16 | 20u << 24);
}

TEST_F(draw_list, colours_by_rows_on_demand_and_changes_nothing_else) {
  Dice dice(4);
  addCrowd(world, 250, 100, 100, 50.0f, dice);
  const auto plain = run(everything);
  DrawView byRows = everything;
  byRows.colouring = Colouring::rows;
  auto coloured = run(byRows);
  ASSERT_EQ(coloured.size(), plain.size());
  EXPECT_EQ(coloured.back().colour, plain.back().colour);  // the ship stands in no cell
  const auto cells = fixture.state().cells[0].download();
  const uint32_t columns = fixture.view().near.ngrid.columns;
  std::set<uint32_t> colours;
  for (size_t i = 0; i + 1 < plain.size(); ++i) {
    const auto cell =
        std::find_if(cells.begin(), cells.end(), [&](const Cell& c) { return c.x == plain[i].x && c.y == plain[i].y; });
    ASSERT_NE(cell, cells.end());
    const uint32_t colour = cpu::rowColour(uint32_t(cell - cells.begin()) / columns);
    EXPECT_EQ(coloured[i].colour, colour);
    colours.insert(colour);
    coloured[i].colour = plain[i].colour;
    EXPECT_EQ(std::memcmp(&coloured[i], &plain[i], sizeof plain[i]), 0);
  }
  EXPECT_GT(colours.size(), 1u);
}

TEST_F(draw_list, colours_by_rows_of_bins_where_the_grid_has_no_rows) {
  SimulationConfig config = stageConfig();
  for (const BroadPhase broadPhase : {BroadPhase::grid, BroadPhase::gridHashed, BroadPhase::bruteForce}) {
    config.broadPhase = broadPhase;
    StageFixture other(config);
    world.entities.clear();
    world.add(enemyAt(rules, 0, 2, 40.0f, 3.9f));
    world.add(enemyAt(rules, 1, 2, 90.0f, 4.1f));
    world.add(enemyAt(rules, 2, 2, 10.0f, 7.9f));
    other.put(world);
    std::vector<SpriteVertex> vertices(4);
    list.run(other.queue(), other.view(), {96.0f, 54.0f, 96.0f, 54.0f, Colouring::rows},
             {vertices.data(), 4, &command});
    EXPECT_EQ(vertices[0].colour, cpu::rowColour(0));
    EXPECT_EQ(vertices[1].colour, cpu::rowColour(1));
    EXPECT_EQ(vertices[2].colour, cpu::rowColour(1));
  }
}

TEST_F(draw_list, says_how_shots_bits_and_the_ship_look) {
  world.add(shotAt(rules, 0, 40.0f, 40.0f, 0.7f));
  world.add(bitAt(rules, 1, 50.0f, 40.0f)).timer = 180;
  world.globals.ship.untouchable_ticks = 5;
  world.globals.ship.aim_rad = 0.25f;
  const auto sprites = run(everything);
  ASSERT_EQ(sprites.size(), 3u);
  EXPECT_EQ(sprites[0].shapeFlags & 0xFFu, uint32_t(Shape::bit));
  EXPECT_EQ(sprites[0].shapeFlags >> 16 & 0xFFu, 127u);  // half of its life
  EXPECT_EQ(sprites[1].shapeFlags & 0xFFu, uint32_t(Shape::shot));
  EXPECT_NEAR(sprites[1].angle_rad, 0.7f, 1e-5f);
  EXPECT_EQ(sprites[2].shapeFlags & 0xFFFFu, uint32_t(Shape::ship) | uint32_t(kSpriteUntouchable) << 8);
  EXPECT_EQ(sprites[2].angle_rad, 0.25f);
}

}  // namespace
}  // namespace gw::test

#include "game/sim/draw/draw_list.h"
#include "game/sim/draw/row_colour.h"
#include "game/sim/entity_flags.h"
#include "gpu/math/exact_math.h"

namespace gw::GW_DEVICE {
namespace {

constexpr uint32_t kLayers = 4, kBlock = 1024, kNoLayer = kLayers;
constexpr float kLargestSprite = 3.2f;  // an announced enemy's outline, in half extents, with its glow

// One item: one id. 1 << (16 * layer) when it shows, so that one sum counts all layers of a block.
struct FindLayers {
  uint64_t* layerBits;
  View v;
  DrawView window;

  GW_BODY void operator()(uint32_t id) const {
    const uint32_t layer = layerOf(id);
    layerBits[id] = layer == kNoLayer ? 0ull : 1ull << (16 * layer);
  }

 private:
  GW_BODY uint32_t layerOf(uint32_t id) const {
    const Cell cell = v.cells[v.cellOf[id]];
    if (cell.type == kTypeNone) return kNoLayer;
    const float past_m = larger(1.0f, kLargestSprite * v.tables->limits.largestReach_m);
    if (magnitude(cell.x - window.centre_x) > window.halfWidth_m + past_m ||
        magnitude(cell.y - window.centre_y) > window.halfHeight_m + past_m) {
      return kNoLayer;
    }
    if (cell.type == kTypeBit) return 0;
    if (cell.type == kTypeShot) return 1;
    if (v.state[id].x == uint32_t(State::dead)) return kNoLayer;
    return v.master->tick - v.birthTick[id] < v.tables->rules.world.announced_ticks ? 2 : 3;
  }
};

// One item: one block of ids. Prefix sums within the block, and the block's counts by layer.
struct CountBlocks {
  uint64_t* within;
  uint32_t* blockFirst;
  const uint64_t* layerBits;
  uint32_t capacity, blocks;

  GW_BODY void operator()(uint32_t block) const {
    uint64_t sum = 0;
    for (uint32_t id = block * kBlock; id < (block + 1) * kBlock && id < capacity; ++id) {
      within[id] = sum;
      sum += layerBits[id];
    }
    for (uint32_t layer = 0; layer < kLayers; ++layer) {
      blockFirst[layer * blocks + block] = uint32_t(sum >> (16 * layer)) & 0xFFFFu;
    }
  }
};

// One item in all: where each layer's share of each block begins, and how many sprites there are.
struct PlaceBlocks {
  uint32_t* blockFirst;  // one more at the end: how many sprites are left out at the bottom
  DrawTarget target;
  uint32_t blocks;

  GW_BODY void operator()(uint32_t) const {
    uint32_t sum = 0;
    for (uint32_t b = 0; b < kLayers * blocks; ++b) {
      const uint32_t own = blockFirst[b];
      blockFirst[b] = sum;
      sum += own;
    }
    const uint32_t sprites = sum + 1;  // and the ship
    const uint32_t left = sprites > target.vertexCapacity ? sprites - target.vertexCapacity : 0;
    blockFirst[kLayers * blocks] = left;
    blockFirst[kLayers * blocks + 1] = sum;
    *target.command = {4, sprites - left, 0, 0};
  }
};

// One item: one id, or the ship at the end.
struct WriteSprites {
  DrawTarget target;
  const uint64_t* layerBits;
  const uint64_t* within;
  const uint32_t* blockFirst;
  View v;
  uint32_t blocks;
  Colouring colouring;

  GW_BODY void operator()(uint32_t id) const {
    const uint32_t left = blockFirst[kLayers * blocks];
    if (id == v.capacity) {
      if (target.vertexCapacity > 0) target.vertices[blockFirst[kLayers * blocks + 1] - left] = ship();
      return;
    }
    const uint64_t bit = layerBits[id];
    if (bit == 0) return;
    uint32_t layer = 0;
    while (bit >> (16 * layer) != 1ull) ++layer;
    const uint32_t rank = uint32_t(within[id] >> (16 * layer)) & 0xFFFFu;
    const uint32_t place = blockFirst[layer * blocks + id / kBlock] + rank;
    if (place >= left) target.vertices[place - left] = sprite(id);
  }

 private:
  GW_BODY static uint32_t packed(Shape shape, uint32_t flags, float energyShare, uint32_t age_ticks) {
    const uint32_t energy = uint32_t(clamp(energyShare, 0.0f, 1.0f) * 255.0f);
    return uint32_t(shape) | flags << 8 | energy << 16 | smaller(age_ticks, 255u) << 24;
  }

  GW_BODY SpriteVertex sprite(uint32_t id) const {
    const uint32_t place = v.cellOf[id];
    const Cell cell = v.cells[place];
    const Float4 motion = v.velocityPrevious[id];
    const uint32_t age = v.master->tick - v.birthTick[id];
    SpriteVertex out{};
    out.x = cell.x;
    out.y = cell.y;
    out.previous_x = motion.z;
    out.previous_y = motion.w;
    if (isEnemy(cell.type)) {
      const EnemyRules& rules = v.tables->rules.enemies[cell.type];
      const Uint4 state = v.state[id];
      const Float4 direction = v.directionMass[id];
      uint32_t flags = state.w & kFlagHit || state.x == uint32_t(State::checkingEnergy) ? kSpriteDamaged : 0u;
      if (age < v.tables->rules.world.announced_ticks) flags |= kSpriteAnnounced;
      // A rectangle is axis-aligned: what is drawn is what hits.
      const bool turns = rules.bounds == Bounds::circle;
      const bool moves = motion.x * motion.x + motion.y * motion.y > 0.01f;
      out.angle_rad = !turns ? 0.0f : moves ? arcTangent2(motion.y, motion.x) : arcTangent2(direction.y, direction.x);
      out.size_m = rules.halfWidth_m;
      out.shapeFlags = packed(rules.shape, flags, v.forceEnergy[id].w / rules.energy, age);
      out.colour = rules.colour;
    } else if (cell.type == kTypeShot) {
      out.angle_rad = arcTangent2(motion.y, motion.x);
      out.size_m = v.tables->rules.shot.radius_m;
      out.shapeFlags = packed(Shape::shot, 0, 1.0f, age);
      out.colour = 0xFFF3B0;
    } else {
      const uint32_t life = v.state[id].y;
      out.angle_rad = float(age) * 0.1f;
      out.size_m = 0.22f;
      out.shapeFlags = packed(Shape::bit, 0, float(life) / float(v.tables->rules.bit.life_ticks), age);
      out.colour = 0x7CFFCB;
    }
    if (colouring == Colouring::rows) out.colour = rowColour(rowOf(v.near, place, cell.y));
    return out;
  }

  GW_BODY SpriteVertex ship() const {
    const Master& m = *v.master;
    SpriteVertex out{};
    out.x = m.ship.x;
    out.y = m.ship.y;
    out.previous_x = m.ship.previous_x;
    out.previous_y = m.ship.previous_y;
    out.angle_rad = m.ship.aim_rad;
    out.size_m = v.tables->rules.ship.radius_m * 1.6f;  // the hull is drawn larger than what can be hit
    out.shapeFlags =
        packed(Shape::ship, m.ship.untouchable_ticks > 0 ? uint32_t(kSpriteUntouchable) : 0u, 1.0f, m.tick);
    out.colour = 0xE8F6FF;
    return out;
  }
};

}  // namespace

DrawList::DrawList(Queue& queue, uint32_t capacity)
    : capacity_(capacity),
      layerBits_(queue, capacity),
      within_(queue, capacity),
      blockFirst_(queue, kLayers * ((capacity + kBlock - 1) / kBlock) + 2) {}

void DrawList::run(Queue& queue, const View& view, const DrawView& window, const DrawTarget& target) {
  const uint32_t blocks = (capacity_ + kBlock - 1) / kBlock;
  forEach(queue, Count{capacity_}, FindLayers{layerBits_.data(), view, window});
  forEach(queue, Count{blocks}, CountBlocks{within_.data(), blockFirst_.data(), layerBits_.data(), capacity_, blocks});
  forEach(queue, Count{1}, PlaceBlocks{blockFirst_.data(), target, blocks});
  forEach(queue, Count{capacity_ + 1},
          WriteSprites{target, layerBits_.data(), within_.data(), blockFirst_.data(), view, blocks, window.colouring});
}

}  // namespace gw::GW_DEVICE

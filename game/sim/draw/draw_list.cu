#include "game/sim/draw/draw_list.h"
#include "game/sim/draw/row_colour.h"
#include "game/sim/entity_flags.h"
#include "gpu/math/exact_math.h"

namespace gw::GW_DEVICE {
namespace {

constexpr uint32_t kLayers = DrawList::kLayers, kNoLayer = kLayers;
constexpr float kLargestSprite = 1.2f + kAnnouncedScale;  // an outline that closes in, in half extents, with its glow

// The layer in which an id is drawn, or kNoLayer.
struct LayerOf {
  View v;
  DrawView window;

  GW_BODY uint32_t operator()(uint32_t id) const {
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
    return isAnnounced(v, id) ? 2 : 3;
  }
};

// Of one id: 1 in the half of its layer, when that is one of these two.
struct CountTwoLayers {
  LayerOf layerOf;
  uint32_t lower;

  GW_BODY uint64_t operator()(uint32_t id) const {
    const uint32_t layer = layerOf(id);
    return layer == lower ? 1ull : layer == lower + 1 ? 1ull << 32 : 0ull;
  }
};

// How many sprites of a layer there are before an id, and in all.
struct LayerCounts {
  ScanView twoLayers[kLayers / 2];

  GW_MEMBER uint32_t before(uint32_t layer, uint32_t id) const {
    return uint32_t(twoLayers[layer / 2].before(id) >> 32 * (layer % 2));
  }
  GW_MEMBER uint32_t total(uint32_t layer) const { return uint32_t(twoLayers[layer / 2].total() >> 32 * (layer % 2)); }
};

// One item: one id, or the ship at the end, which also writes the command.
struct WriteSprites {
  DrawTarget target;
  LayerOf layerOf;
  LayerCounts counts;
  View v;
  Colouring colouring;

  GW_BODY void operator()(uint32_t id) const {
    const uint32_t layer = id == v.capacity ? kLayers : layerOf(id);
    if (layer == kNoLayer && id != v.capacity) return;
    uint32_t below = 0, entities = 0;
    for (uint32_t l = 0; l < kLayers; ++l) {
      const uint32_t total = counts.total(l);
      if (l < layer) below += total;
      entities += total;
    }
    const uint32_t sprites = entities + 1;                                                           // and the ship
    const uint32_t leftOut = sprites > target.vertexCapacity ? sprites - target.vertexCapacity : 0;  // at the bottom
    if (id == v.capacity) {
      *target.command = {4, sprites - leftOut, 0, 0};
      if (target.vertexCapacity > 0) target.vertices[entities - leftOut] = ship();
      return;
    }
    const uint32_t place = below + counts.before(layer, id);
    if (place >= leftOut) target.vertices[place - leftOut] = sprite(id);
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
    const uint32_t age = v.globals->tick - v.birthTick[id];
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
      out.colour = kShotColour;
    } else {
      const uint32_t life = v.state[id].y;
      out.angle_rad = float(age) * 0.1f;
      out.size_m = kBitSize_m;
      out.shapeFlags = packed(Shape::bit, 0, float(life) / float(v.tables->rules.bit.life_ticks), age);
      out.colour = kBitColour;
    }
    if (colouring == Colouring::rows) out.colour = rowColour(rowOf(v.near, place, cell.y));
    return out;
  }

  GW_BODY SpriteVertex ship() const {
    const GameGlobals& m = *v.globals;
    SpriteVertex out{};
    out.x = m.ship.x;
    out.y = m.ship.y;
    out.previous_x = m.ship.previous_x;
    out.previous_y = m.ship.previous_y;
    out.angle_rad = m.ship.aim_rad;
    out.size_m = v.tables->rules.ship.radius_m * kShipScale;
    out.shapeFlags =
        packed(Shape::ship, m.ship.untouchable_ticks > 0 ? uint32_t(kSpriteUntouchable) : 0u, 1.0f, m.tick);
    out.colour = kShipColour;
    return out;
  }
};

}  // namespace

DrawList::DrawList(Queue& queue, uint32_t capacity) : capacity_(capacity) {
  for (Scan& scan : twoLayers_) scan = Scan(queue, capacity);
}

void DrawList::run(Queue& queue, const View& view, const DrawView& window, const DrawTarget& target) {
  const LayerOf layerOf{view, window};
  LayerCounts counts;
  for (uint32_t pair = 0; pair < kLayers / 2; ++pair) {
    twoLayers_[pair].run(queue, CountTwoLayers{layerOf, 2 * pair});
    counts.twoLayers[pair] = twoLayers_[pair].view();
  }
  forEach(queue, Count{capacity_ + 1}, WriteSprites{target, layerOf, counts, view, window.colouring});
}

}  // namespace gw::GW_DEVICE

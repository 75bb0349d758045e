// Every byte of device memory, and what comes of damage to it. Whoever adds a buffer or a member says so here, or it
// does not compile; tests/game/sim/damage_test.cpp turns over bits of all of them and looks whether it is true.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "game/sim/debug/state_columns.h"

namespace gw::GW_DEVICE {
namespace {

struct Part {
  const char* name;
  uint32_t bytes;
  Standing standing = Standing::hashed;
  const char* why = "";
};

template <size_t kCount>
constexpr size_t bytesOf(const Part (&parts)[kCount]) {
  size_t sum = 0;
  for (const Part& part : parts) sum += part.bytes;
  return sum;
}

constexpr const char* kOtherSide = "the next tick writes it before it reads it: the two sides take turns";
constexpr const char* kZero = "always 0, and nobody reads it";
constexpr const char* kWithinTick = "what the passes of one tick tell each other; each tick begins it anew";

constexpr Part kMaster[] = {{"all", sizeof(Master)}};
constexpr Part kTables[] = {{"all", sizeof(Tables)}};
constexpr Part kScratch[] = {
    {"before the hashes", offsetof(TickScratch, fieldHashes), Standing::rewritten, kWithinTick},
    {"hashes", sizeof(TickScratch::fieldHashes)},
    {"after the hashes",
     uint32_t(sizeof(TickScratch) - offsetof(TickScratch, fieldHashes) - sizeof(TickScratch::fieldHashes)),
     Standing::rewritten, kWithinTick}};
constexpr Part kReport[] = {{"all", sizeof(TickReport), Standing::rewritten, "made anew in each tick"}};
constexpr Part kCells[] = {{"place", 8}, {"id", 4}, {"type", 4}};
constexpr Part kCellsBefore[] = {
    {"all", sizeof(Cell), Standing::rewritten,
     "the start of the last tick, which only bots look at; what they did is recorded, and integrate writes it"}};
constexpr Part kCellOf[] = {{"all", sizeof(uint32_t)}};
constexpr Part kForceEnergy[] = {
    {"force", 8, Standing::ofLiving}, {"third", 4, Standing::unread, kZero}, {"energy", 4, Standing::ofLiving}};
constexpr Part kForceEnergyBefore[] = {{"all", sizeof(Float4), Standing::rewritten, kOtherSide}};
constexpr Part kDirectionMass[] = {
    {"direction", 8, Standing::ofLiving}, {"mass", 4, Standing::ofLiving}, {"fourth", 4, Standing::unread, kZero}};
constexpr Part kDirectionMassBefore[] = {{"all", sizeof(Float4), Standing::rewritten, kOtherSide}};
constexpr Part kMotion[] = {{"velocity", 8, Standing::ofLiving}, {"place before", 8, Standing::ofLiving}};
constexpr Part kState[] = {{"state", 4, Standing::ofLiving},
                           {"timer", 4, Standing::ofLiving},
                           {"cooldown", 4, Standing::ofLiving},
                           {"flags", 4, Standing::ofLiving}};
constexpr Part kPush[] = {{"all", sizeof(Float2), Standing::ofLiving}};
constexpr Part kBirthTick[] = {{"all", sizeof(uint32_t), Standing::ofLiving}};
constexpr Part kTarget[] = {{"all", sizeof(uint32_t), Standing::ofLiving}};
constexpr Part kWord[] = {{"all", sizeof(uint32_t), Standing::rewritten, kWithinTick}};
constexpr Part kChoiceTime[] = {{"all", sizeof(float), Standing::rewritten, kWithinTick}};
constexpr Part kPushSum[] = {{"all", 3 * sizeof(uint64_t), Standing::rewritten, kWithinTick}};
constexpr Part kThreat[] = {{"all", sizeof(uint64_t), Standing::rewritten, kWithinTick}};

// Adds the parts of one buffer, which fill its elements.
class Listing {
 public:
  template <class T, size_t kCount>
  void add(const char* name, const Buffer<T>& buffer, const Part (&parts)[kCount], bool byCell = false,
           uint32_t perElement = 1) {
    if (bytesOf(parts) != sizeof(T) * perElement)
      throw std::logic_error(std::string(name) + ": its parts do not fill it");
    uint8_t* d_bytes = reinterpret_cast<uint8_t*>(buffer.data());
    const uint32_t stride = uint32_t(sizeof(T)) * perElement;
    for (const Part& part : parts) {
      list.push_back({name, part.name, part.standing, part.why, d_bytes, part.bytes, stride,
                      uint32_t(buffer.size()) / perElement, byCell});
      d_bytes += part.bytes;
    }
  }

  std::vector<BytesOfBuffer> list;
};

#define GW_FILLS(parts, T) static_assert(bytesOf(parts) == sizeof(T))
GW_FILLS(kMaster, Master);
GW_FILLS(kTables, Tables);
GW_FILLS(kScratch, TickScratch);
GW_FILLS(kReport, TickReport);
GW_FILLS(kCells, Cell);
GW_FILLS(kCellsBefore, Cell);
GW_FILLS(kCellOf, uint32_t);
GW_FILLS(kForceEnergy, Float4);
GW_FILLS(kForceEnergyBefore, Float4);
GW_FILLS(kDirectionMass, Float4);
GW_FILLS(kDirectionMassBefore, Float4);
GW_FILLS(kMotion, Float4);
GW_FILLS(kState, Uint4);
GW_FILLS(kPush, Float2);
GW_FILLS(kBirthTick, uint32_t);
GW_FILLS(kTarget, uint32_t);
GW_FILLS(kWord, uint32_t);
GW_FILLS(kChoiceTime, float);
GW_FILLS(kPushSum, uint64_t[3]);
GW_FILLS(kThreat, uint64_t);
#undef GW_FILLS

// GameState has these buffers and what is derived from them, and nothing else: a new one changes its size.
constexpr size_t kBuffers = 23;
struct Known {
  Buffer<uint32_t> buffers[kBuffers];
  Limits limits;
  Neighbourhood neighbourhood;
  Scan birthScan;
};
static_assert(sizeof(GameState) == sizeof(Known), "list the new buffer in bytesOf(), then count it here");

}  // namespace

#if GW_ON_CUDA
namespace {
void addDerived(Queue&, Listing&) {}  // whose allocations nobody lists
}  // namespace
#else
namespace {

// All that is neither named nor state: what finds neighbours, ranks births, counts and draws.
void addDerived(Queue& queue, Listing& all) {
  const size_t named = all.list.size();
  uint32_t number = 0;
  for (const GuardedMemory::Range& range : queue.memory.ranges()) {
    uint8_t* d_bytes = static_cast<uint8_t*>(range.start);
    const bool known = std::any_of(
        all.list.begin(), all.list.begin() + ptrdiff_t(named),
        [&](const BytesOfBuffer& part) { return part.d_bytes >= d_bytes && part.d_bytes < d_bytes + range.bytes; });
    if (known) continue;
    all.list.push_back({"derived " + std::to_string(++number), "all", Standing::costOnly,
                        "made anew from the state before it is read, or only chooses how much work is done", d_bytes, 1,
                        1, uint32_t(range.bytes)});
  }
}

}  // namespace
#endif

std::vector<BytesOfBuffer> bytesOf(Queue& queue, const GameState& state, const View& v) {
  Listing all;
  all.add("master", state.master, kMaster);
  all.add("tables", state.tables, kTables);
  all.add("scratch", state.scratch, kScratch);
  all.add("report", state.report, kReport);
  all.add("cells", sideOf(state.cells, v.moved), kCells, true);
  all.add("cells before", sideOf(state.cells, v.cells), kCellsBefore, true);
  all.add("cellOf", state.cellOf, kCellOf);
  all.add("forceEnergy", sideOf(state.forceEnergy, v.nextForceEnergy), kForceEnergy);
  all.add("forceEnergy before", sideOf(state.forceEnergy, v.forceEnergy), kForceEnergyBefore);
  all.add("directionMass", sideOf(state.directionMass, v.nextDirectionMass), kDirectionMass);
  all.add("directionMass before", sideOf(state.directionMass, v.directionMass), kDirectionMassBefore);
  all.add("velocityPrevious", state.velocityPrevious, kMotion);
  all.add("state", state.state, kState);
  all.add("push", state.push, kPush);
  all.add("birthTick", state.birthTick, kBirthTick);
  all.add("target", state.target, kTarget);
  all.add("choice", state.choice, kWord);
  all.add("choiceTime", state.choiceTime, kChoiceTime);
  all.add("chosenBy", state.chosenBy, kWord);
  all.add("spent", state.spent, kWord);
  all.add("event", state.event, kWord);
  all.add("pushSum", state.pushSum, kPushSum, false, 3);
  all.add("threat", state.threat, kThreat);
  addDerived(queue, all);
  return all.list;
}

}  // namespace gw::GW_DEVICE

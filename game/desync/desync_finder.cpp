#include "game/desync/desync_finder.h"

#include <algorithm>
#include <exception>

namespace gw {
namespace {

constexpr uint32_t kStride_ticks = 60;
constexpr uint32_t kNeighbours = 6;

// Fields that both sides know and of which the hashes differ.
std::vector<std::string> differing(const std::vector<FieldHash>& own, const std::vector<FieldHash>& reference) {
  std::vector<std::string> fields;
  for (const FieldHash& field : own) {
    const auto other =
        std::find_if(reference.begin(), reference.end(), [&](const FieldHash& f) { return f.field == field.field; });
    if (other != reference.end() && other->hash != field.hash) fields.push_back(field.field);
  }
  return fields;
}

class Finder {
 public:
  Finder(Probe& own, Probe& reference, Desync& desync) : own_(own), reference_(reference), desync_(desync) {}

  // Whether the two parted again in that tick, from where both were set back to `equalTicks`.
  bool find(uint32_t equalTicks) {
    const uint32_t before = desync_.tick - 1 - equalTicks;
    if (own_.play(before) != reference_.play(before)) return false;
    const std::vector<StageHashes> own = own_.playByStages(), reference = reference_.playByStages();
    for (const StageHashes& stage : own) {
      const auto other = std::find_if(reference.begin(), reference.end(),
                                      [&](const StageHashes& s) { return s.stage == stage.stage; });
      if (other == reference.end()) continue;  // another build's list of stages
      const auto globals = differing(stage.globals, other->globals);
      const auto entities = differing(stage.entities, other->entities);
      if (globals.empty() && entities.empty()) continue;
      desync_.stage = stage.stage;
      desync_.fields = entities;
      desync_.fields.insert(desync_.fields.end(), globals.begin(), globals.end());
      entities.empty() ? findGlobal(globals.front()) : findEntity(entities.front());
      return true;
    }
    return false;
  }

 private:
  void findGlobal(const std::string& field) {
    desync_.field = field;
    desync_.values = {own_.global(desync_.stage, field), reference_.global(desync_.stage, field)};
  }

  void findEntity(const std::string& field) {
    const std::string& stage = desync_.stage;
    desync_.field = field;
    const std::vector<uint64_t> own = own_.blocks(stage, field), reference = reference_.blocks(stage, field);
    for (uint32_t block = 0; block < std::min(own.size(), reference.size()); ++block) {
      if (own[block] == reference[block]) continue;
      const std::vector<uint64_t> a = own_.values(stage, field, block), b = reference_.values(stage, field, block);
      for (uint32_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (a[i] == b[i]) continue;
        if (!desync_.id) desync_.id = block * kBlockIds + i;
        ++desync_.entities;
      }
    }
    if (!desync_.id) return;
    Probe* sides[] = {&own_, &reference_};
    for (size_t side = 0; side < 2; ++side) {
      desync_.entity[side] = sides[side]->entity(stage, *desync_.id);
      desync_.around[side] = sides[side]->around(stage, *desync_.id, kNeighbours);
      for (const FieldValue& value : desync_.entity[side]) {
        if (value.field == field) desync_.values[side] = value;
      }
    }
  }

  Probe& own_;
  Probe& reference_;
  Desync& desync_;
};

// Values that are equal after every stage while the tick's hashes are not.
bool onlyHashesDiffer(Probe& own, Probe& reference, const Desync& desync, uint32_t equalTicks) {
  const uint32_t before = desync.tick - 1 - equalTicks;
  if (own.play(before) != reference.play(before)) return false;
  return own.play(1) != reference.play(1);
}

void findPlace(Probe& own, Probe& reference, Desync& desync, uint32_t equalTicks) {
  const auto back = [&] {
    own.goBack();
    reference.goBack();
  };
  const auto restart = [&] {
    own.restart();
    reference.restart();
  };
  back();
  if (Finder(own, reference, desync).find(equalTicks)) return;
  back();
  if (onlyHashesDiffer(own, reference, desync, equalTicks)) {
    desync.stage = "hash";
    return;
  }
  restart();
  desync.fromStart = Finder(own, reference, desync).find(0);
  if (desync.fromStart) return;
  restart();
  desync.fromStart = onlyHashesDiffer(own, reference, desync, 0);
  if (desync.fromStart) desync.stage = "hash";
}

// That the two part is known, whatever becomes of asking where.
void place(Probe& own, Probe& reference, Desync& desync, uint32_t equalTicks) {
  try {
    findPlace(own, reference, desync, equalTicks);
  } catch (const std::exception& error) {
    const Desync known = desync;
    desync = {};
    desync.tick = known.tick;
    desync.hashes = known.hashes;
    desync.unplaced = error.what();
  }
}

}  // namespace

Lockstep playInLockstep(Probe& own, Probe& reference, uint32_t ticks, const std::function<bool(uint32_t)>& goOn) {
  Lockstep lockstep;
  while (lockstep.hashes.size() < ticks) {
    const uint32_t equal = uint32_t(lockstep.hashes.size());
    if (!goOn(equal)) {
      lockstep.interrupted = true;
      break;
    }
    if (equal > 0) {
      own.keep();
      reference.keep();
    }
    const uint32_t stride = std::min(kStride_ticks, ticks - equal);
    const std::vector<uint64_t> a = own.play(stride), b = reference.play(stride);
    for (uint32_t i = 0; i < stride; ++i) {
      lockstep.hashes.push_back(a.at(i));
      if (a[i] == b.at(i)) continue;
      Desync& desync = lockstep.desync.emplace();
      desync.tick = equal + i + 1;
      desync.hashes = {a[i], b[i]};
      place(own, reference, desync, equal);
      return lockstep;
    }
  }
  return lockstep;
}

}  // namespace gw

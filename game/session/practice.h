// What the player asks for in practice, as bits of the records that the simulation takes. Pure: presses go in, one
// record's bits a tick come out, so that whatever was asked for stands in the replay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "game/sim/input_record.h"

namespace gw {

struct PracticePresses {
  uint32_t number = 0;                       // a number key: chooses the type; 0: none
  int nextType = 0, more = 0;                // steps; more may be negative
  int spawn = 0, clear = 0, slowMotion = 0;  // how often
};

// What one record asks for; none when that is nothing, or what there is not. A held button asks again in every record:
// only its press counts in the game.
struct PracticeRequest {
  uint32_t type, count;
};
std::optional<PracticeRequest> requestIn(const InputRecord& record, uint32_t typeCount);

class Practice {
 public:
  static constexpr double kSlow = 0.25;      // times real time
  static constexpr size_t kMostWaiting = 8;  // requests; a hammered key must not go on for seconds

  explicit Practice(uint32_t typeCount) : typeCount_(typeCount) {}

  void press(const PracticePresses& presses);

  // The bits for the next record. A button must be up in a record before its next press counts, so requests made
  // in one frame spread over several ticks.
  uint16_t takeButtons();

  uint32_t type() const { return type_; }
  uint32_t number() const { return number_; }  // an index into kPracticeCounts
  bool slow() const { return slow_; }
  double speed() const { return slow_ ? kSlow : 1; }

 private:
  uint32_t typeCount_;
  uint32_t type_ = 0, number_ = 3;  // ten of the first
  bool slow_ = false;
  std::deque<uint16_t> waiting_;
  uint16_t last_ = 0;
};

}  // namespace gw

// Records of several ticks in flight: what the host wrote for a tick is what that tick reads, and what a tick wrote is
// what the host reads for it.
#include "gpu/exec/record_ring.h"

#include <gtest/gtest.h>

#include "gpu/exec/buffer.h"

namespace gw::cpu {
namespace {

struct Record {
  uint32_t tick = 0;
  float value = 0.5f;
};

class RecordRingTest : public testing::Test {
 protected:
  static ExecOptions options() {
    ExecOptions options;
    options.threads = 1;
    options.protectMemory = true;  // so that a read past the copies would end the test
    return options;
  }

  Queue queue{options()};
};

TEST_F(RecordRingTest, SlotsBeginAsRecordsDo) {
  RecordRing<Record> ring(queue, 3);
  for (uint32_t s = 0; s < 3; ++s) {
    EXPECT_EQ(ring.host(s).tick, 0u);
    EXPECT_EQ(ring.host(s).value, 0.5f);
  }
}

TEST_F(RecordRingTest, EachTickGetsItsOwnSlotWhicheverIsWrittenLater) {
  RecordRing<Record> in(queue, 4), out(queue, 4);
  Buffer<Record> d_record(queue, 1);
  for (uint32_t tick = 0; tick < 40; tick += 4) {
    for (uint32_t t = tick; t < tick + 4; ++t) in.host(t % 4) = {t, float(t) * 2};
    for (uint32_t t = tick; t < tick + 4; ++t) {
      in.toDevice(t % 4, d_record.data());
      out.toHost(t % 4, d_record.data());
    }
    for (uint32_t t = tick; t < tick + 4; ++t) {
      EXPECT_EQ(out.host(t % 4).tick, t);
      EXPECT_EQ(out.host(t % 4).value, float(t) * 2);
    }
  }
}

TEST_F(RecordRingTest, CopiesOneRecordOnly) {
  RecordRing<Record> ring(queue, 2);
  Buffer<Record> d_records(queue, 3);
  ring.host(0) = {1, 1};
  ring.host(1) = {2, 2};
  ring.toDevice(1, d_records.data() + 1);
  const std::vector<Record> records = d_records.download();
  EXPECT_EQ(records[0].tick, 0u);
  EXPECT_EQ(records[1].tick, 2u);
  EXPECT_EQ(records[2].tick, 0u);
  ring.toHost(0, d_records.data() + 2);
  EXPECT_EQ(ring.host(0).value, 0.0f);
  EXPECT_EQ(ring.host(1).tick, 2u);
}

}  // namespace
}  // namespace gw::cpu

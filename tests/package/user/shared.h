#pragma once

#include <cstdint>

extern "C" {
// xy: two numbers for each point.
uint64_t count_pairs(const float* xy, uint32_t count, float radius);
uint64_t count_pairs_with_kept_queue(const float* xy, uint32_t count, float radius);
void drop_kept_queue();
}

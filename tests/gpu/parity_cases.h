// What must be equal, bit for bit, however it is computed: gpu_test runs each case on the cpu device in every
// order and with several numbers of threads, parity_test on the cpu and on the cuda device.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/gpu/probes.h"

namespace gw::test {

struct ParityCase {
  std::string name;  // as a test's name may be
  std::function<Words(const Probes&, const ExecOptions&)> run;
};

const std::vector<ParityCase>& parityCases();

// The first place where the two differ, in words; nothing when they are equal.
std::optional<std::string> difference(const Words& expected, const Words& actual);

}  // namespace gw::test

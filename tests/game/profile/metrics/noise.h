// Numbers that scatter, the same with every standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace gw::profile::test {

class Noise {
 public:
  explicit Noise(uint64_t seed) : engine_(seed) {}

  // Above 0, up to 1.
  double share() { return (double(engine_() >> 11) + 1) * 0x1p-53; }
  // By Box and Muller.
  double normal(double mean, double deviation) {
    return mean + deviation * std::sqrt(-2 * std::log(share())) * std::cos(2 * M_PI * share());
  }
  std::vector<double> normals(size_t count, double mean, double deviation) {
    std::vector<double> values(count);
    for (double& value : values) value = normal(mean, deviation);
    return values;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace gw::profile::test

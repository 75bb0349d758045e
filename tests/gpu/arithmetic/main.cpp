// gw_arithmetic: + - * / of random pairs and square roots, bit for bit.
//
//   gw_arithmetic --device cuda [--pairs 1000000000 --roots 4294967296]     the cuda device against the cpu device
//   gw_arithmetic --device cpu [...]                                        the cpu device against doubles
//
// Exit status 1 when anything differs; then the first operation that does is named.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "bench/device_option.h"
#include "tests/gpu/arithmetic/comparison.h"

namespace {

using namespace gw;
using namespace gw::test;

bool report(const char* what, uint32_t resultsPerInput, const Comparison& comparison) {
  std::printf("%s: %llu inputs, %llu results compared, %llu blocks of %u inputs differ\n", what,
              static_cast<unsigned long long>(comparison.inputs),
              static_cast<unsigned long long>(comparison.inputs * resultsPerInput),
              static_cast<unsigned long long>(comparison.differingBlocks), kBlockInputs);
  if (!comparison.first.empty()) std::printf("%s: the first difference: %s\n", what, comparison.first.c_str());
  return comparison.differingBlocks == 0;
}

bool run(const std::string& device, uint64_t pairs, uint64_t roots, uint64_t spoilt) {
  Side expected{"the cpu device", cpu::arithmetic()}, actual{"doubles", arithmeticInDoubles()};
#ifdef GW_HAVE_CUDA
  if (bench::takesCuda(device)) actual = {"the cuda device", cuda::arithmetic()};
#else
  bench::takesCuda(device);  // refuses
#endif
  expected.spoilt = spoilt;
  const bool pairsEqual = report("pairs", kResults, compare(expected, actual, Operations::pairs, pairs));
  const bool rootsEqual = report("roots", 1, compare(expected, actual, Operations::roots, roots));
  bench::printKernelsRun();
  return pairsEqual && rootsEqual;
}

}  // namespace

int main(int argc, char** argv) {
  std::string device = "cpu";
  uint64_t pairs = 4'000'000, roots = 4'000'000, spoilt = kNotSpoilt;
  CLI::App app{"Compares float arithmetic bit for bit."};
  bench::addDeviceOption(app, device);
  app.add_option("--pairs", pairs, "+ - * / of so many, at least")->check(CLI::Range(uint64_t(1), uint64_t(1) << 40));
  app.add_option("--roots", roots, "square roots of so many, at least; 4294967296 are all there are")
      ->check(CLI::Range(uint64_t(1), uint64_t(1) << 32));
  app.add_option("--spoil", spoilt, "make a result of this input wrong: to see that it is found");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(device, pairs, roots, spoilt) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

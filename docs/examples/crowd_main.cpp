// Where a crowd stands after its members have stepped away from each other. The hashes are the same on every device
// and with any number of threads.
//   crowd [auto|cpu|cuda] [threads] [together]      threads 0: one per processor; together: all start in one place
#include <gpuwars/device_list.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "crowd.h"

static void print(const char* when, const CrowdReport& report) {
  std::printf("%s  %016llx  nearest other at %.3f to %.3f m, spread %.2f x %.2f m\n", when,
              static_cast<unsigned long long>(report.hash), double(report.closest_m), double(report.loneliest_m),
              double(report.spreadX_m), double(report.spreadY_m));
}

int main(int argc, char** argv) {
  std::string device = argc > 1 ? argv[1] : "auto";
  gw::ExecOptions options;
  if (argc > 2) options.threads = uint32_t(std::atoi(argv[2]));
  const Start start = argc > 3 && std::string(argv[3]) == "together" ? Start::together : Start::scattered;
#ifdef GW_HAVE_CUDA
  if (device == "auto" && gw::listDevices().hasCuda()) device = "cuda";
#endif
  if (device == "auto") device = "cpu";

  auto runCrowd = gw::cpu::runCrowd;
#ifdef GW_HAVE_CUDA
  if (device == "cuda") runCrowd = gw::cuda::runCrowd;
#else
  if (device == "cuda") {
    std::fprintf(stderr, "This program was built without CUDA; run it with cpu.\n");
    return 2;
  }
#endif
  try {
    const CrowdRun run = runCrowd(options, 2000, 200, start);  // agents, steps
    std::printf("2000 agents, 200 steps on %s\n", device.c_str());
    print("before", run.before);
    print("after ", run.after);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

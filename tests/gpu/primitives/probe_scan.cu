#include "gpu/primitives/scan_reduce.h"
#include "gpu/primitives/sort_keys.h"
#include "tests/gpu/probe_parts.h"

namespace gw::GW_DEVICE {
namespace {

// One item: what stands before one item; the one past the end reads the total.
struct ReadScan {
  uint64_t* out;
  ScanView view;
  uint32_t count;
  GW_BODY void operator()(uint32_t i) const { out[i] = i < count ? view.before(i) : view.total(); }
};

test::Words scan(const ExecOptions& options, const test::Words& words) {
  Queue queue(options);
  const uint32_t n = uint32_t(words.size());
  auto in = uploaded(queue, words);
  Buffer<uint64_t> out(queue, n + 1);
  Scan scan(queue, n);
  // Twice: what the first run left behind must not leak into the second.
  scan.run(queue, in.data());
  scan.run(queue, in.data());
  forEach(queue, Count{n + 1}, ReadScan{out.data(), scan.view(), n});
  auto result = out.download();
  return result;
}

uint64_t reduce(const ExecOptions& options, const test::Words& words) {
  Queue queue(options);
  auto in = uploaded(queue, words);
  Buffer<uint64_t> sum(queue, 1);
  Reduce reduce(queue, uint32_t(words.size()));
  reduce.run(queue, in.data(), sum.data());
  const uint64_t result = sum.download()[0];
  return result;
}

// One item: one key.
struct CopyWords {
  uint64_t* out;
  const uint64_t* in;
  GW_BODY void operator()(uint32_t i) const { out[i] = in[i]; }
};

test::Words sortKeys(const ExecOptions& options, const test::Words& keys) {
  Queue queue(options);
  const uint32_t n = uint32_t(keys.size());
  auto in = uploaded(queue, keys);
  Buffer<uint64_t> out(queue, n);
  SortKeys sort(queue, n);
  // The second run sorts what is sorted already, the third the same keys afresh.
  for (int run = 0; run < 3; ++run) {
    if (run != 1) forEach(queue, Count{n}, CopyWords{sort.keys(), in.data()});
    sort.run(queue);
  }
  forEach(queue, Count{n}, CopyWords{out.data(), sort.keys()});
  auto result = out.download();
  return result;
}

}  // namespace

void addScanProbes(test::Probes& probes) {
  probes.scan = scan;
  probes.reduce = reduce;
  probes.sortKeys = sortKeys;
}

}  // namespace gw::GW_DEVICE

#include "gpu/math/exact_math.h"
#include "gpu/math/fixed_sum.h"
#include "gpu/math/philox.h"
#include "gpu/math/state_hash.h"
#include "tests/gpu/probe_parts.h"

namespace gw::GW_DEVICE {
namespace {

// Payloads of NaN differ between processors; that there is one must not.
GW_FN uint32_t canonicalBits(float value) {
  return value != value ? 0x7fc00000u : bitsOf(value);
}

// One item: all functions of one pair.
struct ExactMath {
  static constexpr uint32_t kResults = 7;
  uint32_t* out;
  const Float2* in;
  GW_BODY void operator()(uint32_t i) const {
    const float x = in[i].x, y = in[i].y;
    const Float2 unit = normalised(x, y);
    const float results[kResults] = {sine(x), cosine(x), arcTangent2(y, x), exponential(x), length(x, y),
                                     unit.x,  unit.y};
    for (uint32_t k = 0; k < kResults; ++k) out[i * kResults + k] = canonicalBits(results[k]);
  }
};

std::vector<uint32_t> exactMath(const ExecOptions& options, const std::vector<Float2>& pairs) {
  Queue queue(options);
  auto in = uploaded(queue, pairs);
  Buffer<uint32_t> out(queue, pairs.size() * ExactMath::kResults);
  forEach(queue, Count{uint32_t(pairs.size())}, ExactMath{out.data(), in.data()});
  auto result = out.download();
  return result;
}

// One item: one counter. Named apart from the function that it calls.
struct DrawPhilox {
  Uint4* out;
  const Uint4* counters;
  uint64_t key;
  GW_BODY void operator()(uint32_t i) const { out[i] = philox(key, counters[i]); }
};

std::vector<Uint4> drawPhilox(const ExecOptions& options, uint64_t key, const std::vector<Uint4>& counters) {
  Queue queue(options);
  auto in = uploaded(queue, counters);
  Buffer<Uint4> out(queue, counters.size());
  forEach(queue, Count{uint32_t(counters.size())}, DrawPhilox{out.data(), in.data(), key});
  auto result = out.download();
  return result;
}

struct UnitFloats {
  uint32_t* out;
  const uint32_t* bits;
  GW_BODY void operator()(uint32_t i) const { out[i] = bitsOf(unitFloat(bits[i])); }
};

std::vector<uint32_t> unitFloats(const ExecOptions& options, const std::vector<uint32_t>& bits) {
  Queue queue(options);
  auto in = uploaded(queue, bits);
  Buffer<uint32_t> out(queue, bits.size());
  forEach(queue, Count{uint32_t(bits.size())}, UnitFloats{out.data(), in.data()});
  auto result = out.download();
  return result;
}

// One item: one term.
struct FixedTerms {
  int32_t* out;
  const float* values;
  float scale;
  GW_BODY void operator()(uint32_t i) const { out[i] = fixedTerm(values[i], scale); }
};

std::vector<int32_t> fixedTerms(const ExecOptions& options, const std::vector<float>& values, float scale) {
  Queue queue(options);
  auto in = uploaded(queue, values);
  Buffer<int32_t> out(queue, values.size());
  forEach(queue, Count{uint32_t(values.size())}, FixedTerms{out.data(), in.data(), scale});
  auto result = out.download();
  return result;
}

// One item: one word that stands at (i / 8, i % 8); all hashes are added up as well, at the end.
struct HashWords {
  uint64_t* out;
  uint64_t* sum;
  const uint64_t* words;
  GW_BODY void operator()(uint32_t i) const {
    out[i] = hashWord(i / 8, i % 8, words[i]);
    atomicAddTo64(*sum, out[i]);
  }
};

test::Words hashWords(const ExecOptions& options, const test::Words& words) {
  Queue queue(options);
  auto in = uploaded(queue, words);
  Buffer<uint64_t> out(queue, words.size()), sum(queue, 1);
  forEach(queue, Count{uint32_t(words.size())}, HashWords{out.data(), sum.data(), in.data()});
  test::Words result = out.download();
  result.push_back(sum.download()[0]);
  return result;
}

}  // namespace

void addMathProbes(test::Probes& probes) {
  probes.exactMath = exactMath;
  probes.philox = drawPhilox;
  probes.unitFloats = unitFloats;
  probes.fixedTerms = fixedTerms;
  probes.hashWords = hashWords;
}

}  // namespace gw::GW_DEVICE

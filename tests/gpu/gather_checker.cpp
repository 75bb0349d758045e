#include "tests/gpu/gather_checker.h"

#include <sstream>

#include "tests/naive/gpu_oracles.h"

namespace gw::test {

std::string checkGather(GridShape shape, const std::vector<Cell>& cells, const std::vector<Query>& queries,
                        Method method, const ExecOptions& options) {
  const Gathered gathered = cpu::probes().gather(options, shape, cells, queries, method);
  const size_t wordsPerQuery = (shape.cells() + 31) / 32;
  for (size_t q = 0; q < queries.size(); ++q) {
    std::vector<uint32_t> ids;
    for (uint32_t id = 0; id < shape.cells(); ++id) {
      if (gathered.found[q * wordsPerQuery + id / 32] >> id % 32 & 1u) ids.push_back(id);
    }
    const auto expected = naive::neighbours(cells, queries[q]);
    if (ids == expected && gathered.visits[q] == expected.size() && gathered.tested[q] >= expected.size()) continue;
    std::ostringstream text;
    text << "query " << q << " at (" << queries[q].x << ", " << queries[q].y << ") within " << queries[q].radius << ": "
         << ids.size() << " found, " << gathered.visits[q] << " visits, " << gathered.tested[q] << " tests, "
         << expected.size() << " expected";
    return text.str();
  }
  return "";
}

}  // namespace gw::test

#include "tests/gpu/neighbours/gather_checker.h"

#include <sstream>

#include "tests/reference/gpu_oracles.h"

namespace gw::test {
namespace {

std::ostream& operator<<(std::ostream& out, const Query& query) {
  return out << "(" << query.x << ", " << query.y << ") within " << query.radius;
}
std::ostream& operator<<(std::ostream& out, const Query3& query) {
  return out << "(" << query.x << ", " << query.y << ", " << query.z << ") within " << query.radius;
}

template <class CellT, class QueryT>
std::string judge(const Gathered& gathered, const std::vector<CellT>& cells, const std::vector<QueryT>& queries) {
  const size_t wordsPerQuery = (cells.size() + 31) / 32;
  for (size_t q = 0; q < queries.size(); ++q) {
    std::vector<uint32_t> ids;
    for (uint32_t id = 0; id < cells.size(); ++id) {
      if (gathered.found[q * wordsPerQuery + id / 32] >> id % 32 & 1u) ids.push_back(id);
    }
    const auto expected = naive::neighbours(cells, queries[q]);
    if (ids == expected && gathered.visits[q] == expected.size() && gathered.tested[q] >= expected.size()) continue;
    std::ostringstream text;
    text << "query " << q << " at " << queries[q] << ": " << ids.size() << " found, " << gathered.visits[q]
         << " visits, " << gathered.tested[q] << " tests, " << expected.size() << " expected";
    return text.str();
  }
  return "";
}

}  // namespace

std::string checkGather(GridShape shape, const std::vector<Cell>& cells, const std::vector<Query>& queries,
                        Method method, const ExecOptions& options) {
  return judge(cpu::probes().gather(options, shape, cells, queries, method), cells, queries);
}

std::string checkGather(GridShape shape, const std::vector<Cell3>& cells, const std::vector<Query3>& queries,
                        Method method, const ExecOptions& options) {
  return judge(cpu::probes().gather3(options, shape, cells, queries, method), cells, queries);
}

}  // namespace gw::test

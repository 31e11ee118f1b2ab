// The rows of the robots that are taken out of a run.
#include <string>

#include "controller/scenario/schema_rows.hpp"

namespace mayfly {

void add_twin_rows(std::vector<Key>& rows) {
  const std::string at = "twins[]";
  rows.push_back({.path = "twins",
                  .type = KeyType::kList,
                  .max = 1000,
                  .fallback = "[]",
                  .text =
                      "Which robots are taken out of the run, and when; a simulated twin flies in the place "
                      "of each, until it is put back."});
  rows.push_back({.path = at, .type = KeyType::kMap, .text = "One robot, once."});
  rows.push_back({.path = at + ".robot",
                  .type = KeyType::kName,
                  .required = true,
                  .text = "Which, such as `flies_3`; of a swarm under the governor."});
  rows.push_back({.path = at + ".from",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 1e6,
                  .required = true,
                  .text = "When it is taken out: it holds where it is, and the others keep clear of it."});
  rows.push_back({.path = at + ".until",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 1e6,
                  .fallback_text = "it stays out",
                  .text = "When its twin begins to fly back to it; there it is put back."});
}

}  // namespace mayfly

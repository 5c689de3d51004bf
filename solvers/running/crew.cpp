#include "solvers/running/crew.hpp"

#include <utility>

namespace gcs {

std::vector<std::string> Crew::results(const std::string& task, std::vector<std::string> items,
                                       ItemWork& here, const std::function<bool()>& stopped) {
  std::vector<std::string> results(items.size());
  const std::unique_ptr<ItemWork> all = share(task, here);
  for (std::size_t i = 0; i < items.size(); ++i) all->add({i, std::move(items[i])});
  while (!all->is_idle() && !stopped())
    for (NumberedItem& result : all->advance()) results.at(result.number) = std::move(result.bytes);
  return results;
}

}  // namespace gcs

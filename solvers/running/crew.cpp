#include "solvers/running/crew.hpp"

#include <utility>

namespace gcs {

void Crew::each_result(const std::string& task, std::size_t count,
                       const std::function<std::string(std::size_t)>& item_of, ItemWork& here,
                       const std::function<bool()>& stopped, const std::function<void(NumberedItem)>& take) {
  const std::unique_ptr<ItemWork> all = share(task, here);
  // As many as all members may have, and as many again that wait for them.
  const std::size_t most = 2 * static_cast<std::size_t>(members()) * (all->reserve() + 1);
  std::size_t next = 0, under_way = 0;
  while (true) {
    for (; next < count && under_way < most; ++next, ++under_way) all->add({next, item_of(next)});
    if (all->is_idle() || stopped()) return;
    for (NumberedItem& result : all->advance()) {
      --under_way;
      take(std::move(result));
    }
  }
}

}  // namespace gcs

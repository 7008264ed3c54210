#include "ingest/shared_tables.h"

#include "render/parallel.h"

namespace terrview {

void make_shared_tables(std::vector<Dem>& dems, int threads) {
  const ForEach for_each = [threads](int count, const std::function<void(int index)>& work) {
    parallel_for(count, threads, work);
  };
  for (Dem& dem : dems) {
    if (!dem.ceilings) dem.ceilings = std::make_shared<const HeightCeilings>(*dem.grid, for_each);
    if (!dem.means) dem.means = std::make_shared<const MeanHeights>(*dem.grid, for_each);
  }
}

}  // namespace terrview

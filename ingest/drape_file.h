// A georeferenced picture as a drape.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "ingest/dem.h"
#include "render/drape.h"

namespace terrview {

// Any picture that PictureSource reads, with a geotransform; of it the part that the DEMs need. No
// more than `memory_bytes` (0 = half of the machine's) are taken. Throws InputError, also where the
// picture lies beside the DEMs.
[[nodiscard]] std::shared_ptr<const Drape> read_drape(const std::string& path,
                                                      const std::vector<Dem>& dems,
                                                      std::size_t memory_bytes = 0);

}  // namespace terrview

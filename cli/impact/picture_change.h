// How the picture of a place changes.
#pragma once

#include <cstdint>
#include <map>

#include "render/render.h"

namespace terrview {

struct PictureChange {
  Image mask;  // grey: 255 the project, 128 what else differs, 0 the same
  std::map<std::int32_t, std::int64_t> building_px = {};  // whose middle shows it, by its id
  std::int64_t changed_px = 0;                            // that are not the same, to the byte
  std::int64_t horizon_columns = 0;  // columns that show where sky and ground (or objects) meet
  std::int64_t changed_columns = 0;  // of these, those where they meet at another height
};

// Of two frames of one camera, with their samples; the objects of the project have ids above
// `before` up to `last`. A pixel is the same where 8 bits of sRGB are. Sky and ground meet in the
// highest pixel of a column whose middle shows ground or an object, if that is not the topmost.
[[nodiscard]] PictureChange picture_change(const Frame& without, const Frame& with,
                                           std::int32_t before, std::int32_t last);

}  // namespace terrview

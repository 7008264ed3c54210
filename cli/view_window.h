// Reading no more of a large DEM than a view can need.
#pragma once

#include "cli/view_options.h"

namespace terrview {

// Makes the reader of `options` choose windows of large files by what the view can see, where the
// options alone tell its direction: a curved Earth, an aim, no other say over windows or over
// colours that depend on the whole range of heights.
void limit_reading(ViewOptions& options);

}  // namespace terrview

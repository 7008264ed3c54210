// Whole files, written where a full disk is noticed.
#pragma once

#include <string>
#include <string_view>

namespace terrview {

// Libraries that write files themselves (libpng, libwebp, GDAL) lose the error of a full disk, and
// libjpeg ends the program: they write to memory, and this to the disk. Throws std::runtime_error
// with the reason alone; the caller knows the file's name.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace terrview

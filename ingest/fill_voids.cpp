#include "ingest/fill_voids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gdal_alg.h>
#include <gdal_priv.h>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "ingest/gdal_scope.h"

namespace terrview {
namespace {

// Posts without a height, as they were before any was filled.
class VoidMask {
 public:
  explicit VoidMask(const HeightGrid& grid)
      : columns_(static_cast<std::size_t>(grid.columns)), empty_(grid.heights_m.size()) {
    for (std::size_t i = 0; i < empty_.size(); ++i) empty_[i] = std::isnan(grid.heights_m[i]);
  }

  [[nodiscard]] std::size_t index(glm::ivec2 post) const {
    return static_cast<std::size_t>(post.y) * columns_ + static_cast<std::size_t>(post.x);
  }
  [[nodiscard]] bool empty(glm::ivec2 post) const { return empty_[index(post)]; }

 private:
  std::size_t columns_;
  std::vector<bool> empty_;
};

// One void, listed only as far as it can still be filled.
struct Void {
  std::vector<glm::ivec2> posts;
  glm::ivec2 first;  // bounding box
  glm::ivec2 last;
  bool fillable = true;
};

class VoidFinder {
 public:
  VoidFinder(const HeightGrid& grid, const VoidMask& mask, int widest_posts)
      : size_(grid.columns, grid.rows),
        mask_(mask),
        widest_(widest_posts),
        seen_(grid.heights_m.size()) {}

  [[nodiscard]] bool is_new(glm::ivec2 post) const {
    return mask_.empty(post) && !seen_[mask_.index(post)];
  }

  // The void that holds `start`, run by run along the rows: a sea needs little memory.
  Void flood(glm::ivec2 start) {
    Void found{{}, start, start};
    seeds_.assign(1, start);
    while (!seeds_.empty()) {
      const glm::ivec2 seed = seeds_.back();
      seeds_.pop_back();
      if (!is_new(seed)) continue;
      int west = seed.x;
      int east = seed.x;
      take_run(seed.y, west, east);
      for (int x = west; x <= east; ++x) include(found, {x, seed.y});
      seed_row(seed.y - 1, west - 1, east + 1);
      seed_row(seed.y + 1, west - 1, east + 1);
    }
    return found;
  }

 private:
  // Widens [west, east] to the whole run of new posts.
  void take_run(int row, int& west, int& east) {
    while (west > 0 && is_new({west - 1, row})) --west;
    while (east < size_.x - 1 && is_new({east + 1, row})) ++east;
    for (int x = west; x <= east; ++x) seen_[mask_.index({x, row})] = true;
  }

  // One seed for each run of new posts that begins or lies within [west, east] of a row.
  void seed_row(int row, int west, int east) {
    if (row < 0 || row >= size_.y) return;
    bool in_run = false;
    for (int x = std::max(0, west); x <= std::min(size_.x - 1, east); ++x) {
      const bool fresh = is_new({x, row});
      if (fresh && !in_run) seeds_.push_back({x, row});
      in_run = fresh;
    }
  }

  void include(Void& found, glm::ivec2 post) const {
    found.first = glm::min(found.first, post);
    found.last = glm::max(found.last, post);
    const glm::ivec2 across = found.last - found.first + 1;
    if (across.x > widest_ || across.y > widest_ || post.x == 0 || post.y == 0 ||
        post.x == size_.x - 1 || post.y == size_.y - 1) {
      found.fillable = false;
      found.posts.clear();
    }
    if (found.fillable) found.posts.push_back(post);
  }

  glm::ivec2 size_;
  const VoidMask& mask_;
  int widest_;
  std::vector<bool> seen_;
  std::vector<glm::ivec2> seeds_;
};

// A raster of GDAL's over memory of ours.
template <typename Value>
std::unique_ptr<GDALDataset> over_memory(std::vector<Value>& values, glm::ivec2 size,
                                         GDALDataType type) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  std::unique_ptr<GDALDataset> dataset(driver->Create("", size.x, size.y, 0, type, nullptr));
  char address[64] = {};
  CPLPrintPointer(address, values.data(), sizeof(address) - 1);
  const std::string option = std::string("DATAPOINTER=") + address;
  const char* const options[] = {option.c_str(), nullptr};
  dataset->AddBand(type, const_cast<char**>(options));
  return dataset;
}

// Posts `first` to `last`, both included.
struct Box {
  glm::ivec2 first;
  glm::ivec2 last;
};

// Posts to fill and as much around them as GDAL looks at.
class Patch {
 public:
  Patch(const HeightGrid& grid, const VoidMask& mask, const Box& box)
      : first_(glm::max(box.first - kFillReach_posts, glm::ivec2(0))) {
    const glm::ivec2 last(grid.columns - 1, grid.rows - 1);
    size_ = glm::min(box.last + kFillReach_posts, last) - first_ + 1;
    for (int y = 0; y < size_.y; ++y) {
      for (int x = 0; x < size_.x; ++x) {
        const glm::ivec2 post = first_ + glm::ivec2(x, y);
        const bool empty = mask.empty(post);
        valid_.push_back(empty ? 0 : 255);
        heights_m_.push_back(empty ? 0 : grid.at(post.x, post.y));
      }
    }
  }

  void interpolate() {
    const auto heights = over_memory(heights_m_, size_, GDT_Float32);
    const auto valid = over_memory(valid_, size_, GDT_Byte);
    const char* const options[] = {"TEMP_FILE_DRIVER=MEM", nullptr};
    const CPLErr error =
        GDALFillNodata(heights->GetRasterBand(1), valid->GetRasterBand(1), kFillReach_posts, 0, 0,
                       const_cast<char**>(options), nullptr, nullptr);
    if (error != CE_None) throw std::runtime_error("GDALFillNodata failed");
    heights->FlushCache(false);
  }

  [[nodiscard]] float at(glm::ivec2 post) const {
    const glm::ivec2 p = post - first_;
    return heights_m_[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size_.x) +
                      static_cast<std::size_t>(p.x)];
  }

 private:
  glm::ivec2 first_;
  glm::ivec2 size_;
  std::vector<float> heights_m_;
  std::vector<unsigned char> valid_;
};

// The posts of all voids that can be filled.
std::vector<bool> find_fillable(const HeightGrid& grid, const VoidMask& mask, int widest_posts) {
  std::vector<bool> fillable(grid.heights_m.size());
  VoidFinder finder(grid, mask, widest_posts);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      if (!finder.is_new({column, row})) continue;
      const Void hole = finder.flood({column, row});
      if (!hole.fillable) continue;
      for (const glm::ivec2 post : hole.posts) fillable[mask.index(post)] = true;
    }
  }
  return fillable;
}

// The posts of `block` to fill.
std::vector<glm::ivec2> fillable_posts(const Box& block, const VoidMask& mask,
                                       const std::vector<bool>& fillable) {
  std::vector<glm::ivec2> posts;
  for (int row = block.first.y; row <= block.last.y; ++row) {
    for (int column = block.first.x; column <= block.last.x; ++column) {
      if (fillable[mask.index({column, row})]) posts.push_back({column, row});
    }
  }
  return posts;
}

void fill(HeightGrid& grid, const VoidMask& mask, const std::vector<glm::ivec2>& posts) {
  Box box{posts.front(), posts.front()};
  for (const glm::ivec2 post : posts) {
    box = {glm::min(box.first, post), glm::max(box.last, post)};
  }
  Patch patch(grid, mask, box);
  patch.interpolate();
  for (const glm::ivec2 post : posts) grid.heights_m[mask.index(post)] = patch.at(post);
}

}  // namespace

std::size_t fill_voids(HeightGrid& grid, int widest_posts) {
  const bool whole = std::none_of(grid.heights_m.begin(), grid.heights_m.end(),
                                  [](float height) { return std::isnan(height); });
  if (whole) return 0;
  const GdalScope scope;
  const VoidMask mask(grid);
  const std::vector<bool> fillable = find_fillable(grid, mask, widest_posts);
  constexpr int kBlock_posts = 256;
  std::size_t filled = 0;
  for (int row = 0; row < grid.rows; row += kBlock_posts) {
    for (int column = 0; column < grid.columns; column += kBlock_posts) {
      const Box block{{column, row},
                      {std::min(column + kBlock_posts, grid.columns) - 1,
                       std::min(row + kBlock_posts, grid.rows) - 1}};
      const std::vector<glm::ivec2> posts = fillable_posts(block, mask, fillable);
      if (posts.empty()) continue;
      fill(grid, mask, posts);
      filled += posts.size();
    }
  }
  return filled;
}

}  // namespace terrview

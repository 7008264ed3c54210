#include "sky/cloud_painter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "sky/field_cell.h"
#include "sky/image_cell.h"

namespace terrview {
namespace {

// Beyond a window's outermost pixel centres: what a cell's image may be off, and more.
constexpr double kMargin_px = 0.05;

// What is known of a pixel before its value.
struct PixelPlace {
  bool seen = false;
  glm::dvec2 place{0, 0};  // root cells
  float distance_m = 0;
};

PixelPlace place_of(const CloudLayer& layer, const glm::dvec3& direction) {
  const auto t = layer.distance(direction);
  if (!t) return {};
  return {true, layer.field_place(glm::dvec2(direction) * *t),
          static_cast<float>(*t * glm::length(direction))};
}

std::int64_t floor_index(double x) { return static_cast<std::int64_t>(std::floor(x)); }

// The share of a cell's side from its south-western corner to a place in root cells.
glm::dvec2 share_of(const CellPlace& at, const glm::dvec2& place) {
  const auto cells = static_cast<double>(std::int64_t{1} << at.level);
  return place * cells - glm::dvec2(at.column, at.row);
}

bool holds(const glm::dvec2& share) {
  return share.x >= 0 && share.x < 1 && share.y >= 0 && share.y < 1;
}

float between(const std::array<float, 4>& corner, const glm::dvec2& share) {
  const auto s = static_cast<float>(share.x);
  const auto t = static_cast<float>(share.y);
  const float south = corner[0] + s * (corner[1] - corner[0]);
  const float north = corner[2] + s * (corner[3] - corner[2]);
  return south + t * (north - south);
}

template <FieldKind kKind>
class Painting {
 public:
  Painting(const RandomField& field, const LayerImage& image, double leaf_px)
      : field_(field), image_(image), leaf_px_(leaf_px) {}

  // From the root down to the cell that is not divided: the plain twin of paint().
  [[nodiscard]] float value(const glm::dvec2& place) const {
    CellPlace at{0, floor_index(place.x), floor_index(place.y)};
    auto cell = FieldCell<kKind>::root(field_, at);
    ImageCell shown = root_image(image_, at);
    while (!is_leaf(at, shown)) {
      const glm::dvec2 share = share_of(at, place);
      const int k = (share.x >= 0.5 ? 1 : 0) + (share.y >= 0.5 ? 2 : 0);
      const auto child = static_cast<std::size_t>(k);
      cell = cell.divided(field_, at)[child];
      shown = divided_image(image_, at, shown)[child];
      at = at.child(k);
    }
    return between(cell.corners(), share_of(at, place));
  }

  void paint(const PixelWindow& window, const std::vector<PixelPlace>& places,
             std::vector<CloudSample>& samples) {
    window_ = &window;
    places_ = &places;
    samples_ = &samples;
    edges_ = {glm::dvec2(window.first_px) + 0.5 - kMargin_px,
              glm::dvec2(window.first_px + window.size_px) - 0.5 + kMargin_px};
    for_each_root([&](const CellPlace& root) {
      visit(root, FieldCell<kKind>::root(field_, root), root_image(image_, root), true);
    });
    // Rounding at the rim of a cell may hide a pixel from it.
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (places[k].seen && std::isnan(samples[k].value)) samples[k].value = value(places[k].place);
    }
  }

 private:
  [[nodiscard]] bool is_leaf(const CellPlace& at, const ImageCell& shown) const {
    return at.level == field_.levels() || is_small(shown, leaf_px_);
  }

  // The root cells around all places that are seen.
  template <class Visit>
  void for_each_root(const Visit& visit_root) const {
    glm::dvec2 low(1e300);
    glm::dvec2 high(-1e300);
    for (const PixelPlace& pixel : *places_) {
      if (!pixel.seen) continue;
      low = {std::min(low.x, pixel.place.x), std::min(low.y, pixel.place.y)};
      high = {std::max(high.x, pixel.place.x), std::max(high.y, pixel.place.y)};
    }
    if (low.x > high.x) return;
    for (std::int64_t row = floor_index(low.y); row <= floor_index(high.y); ++row)
      for (std::int64_t column = floor_index(low.x); column <= floor_index(high.x); ++column)
        visit_root(CellPlace{0, column, row});
  }

  void visit(const CellPlace& at, const FieldCell<kKind>& cell, const ImageCell& shown, bool cut) {
    if (cut) {
      const Within within = compare(shown, edges_);
      if (within == Within::outside) return;
      cut = within == Within::cut;
    }
    if (is_leaf(at, shown)) {
      fill(at, cell, shown);
      return;
    }
    const auto cells = cell.divided(field_, at);
    const auto images = divided_image(image_, at, shown);
    for (int k = 0; k < 4; ++k) {
      const auto child = static_cast<std::size_t>(k);
      visit(at.child(k), cells[child], images[child], cut);
    }
  }

  // A leaf behind the eye's plane in part is one of the last level; its pixels are then found among
  // all.
  void fill(const CellPlace& at, const FieldCell<kKind>& cell, const ImageCell& shown) {
    const glm::ivec2 size = window_->size_px;
    glm::ivec2 first(0);
    glm::ivec2 last = size - 1;
    if (std::min({shown[0].w, shown[1].w, shown[2].w, shown[3].w}) > 0) {
      const ImageWindow around = bounds(shown);
      const glm::dvec2 low = around.first - glm::dvec2(window_->first_px) - 0.5 - kMargin_px;
      const glm::dvec2 high = around.last - glm::dvec2(window_->first_px) - 0.5 + kMargin_px;
      first = {clamped(std::ceil(low.x), 0, size.x), clamped(std::ceil(low.y), 0, size.y)};
      last = {clamped(std::floor(high.x), -1, size.x - 1),
              clamped(std::floor(high.y), -1, size.y - 1)};
    }
    for (int row = first.y; row <= last.y; ++row) {
      for (int column = first.x; column <= last.x; ++column) {
        const auto k = static_cast<std::size_t>(row * size.x + column);
        if (!(*places_)[k].seen) continue;
        const glm::dvec2 share = share_of(at, (*places_)[k].place);
        if (holds(share)) (*samples_)[k].value = between(cell.corners(), share);
      }
    }
  }

  static int clamped(double index, int least, int most) {
    return static_cast<int>(
        std::clamp(index, static_cast<double>(least), static_cast<double>(most)));
  }

  const RandomField& field_;
  LayerImage image_;
  double leaf_px_;
  const PixelWindow* window_ = nullptr;
  const std::vector<PixelPlace>* places_ = nullptr;
  std::vector<CloudSample>* samples_ = nullptr;
  ImageWindow edges_{};
};

// Calls `work` with a Painting of the field's kind.
template <class Work>
void with_painting(const RandomField& field, const LayerImage& image, double leaf_px,
                   const Work& work) {
  switch (field.options().kind) {
    case FieldKind::midpoint:
      return work(Painting<FieldKind::midpoint>(field, image, leaf_px));
    case FieldKind::displaced:
      return work(Painting<FieldKind::displaced>(field, image, leaf_px));
    case FieldKind::smooth:
      return work(Painting<FieldKind::smooth>(field, image, leaf_px));
  }
}

}  // namespace

CloudPainter::CloudPainter(const RandomField& field, const CloudLayer& layer,
                           const SkyCamera& camera, double leaf_px)
    : field_(field), layer_(layer), camera_(camera), leaf_px_(leaf_px) {
  assert(field.options().levels.x == field.options().levels.y);
}

std::vector<CloudSample> CloudPainter::paint(const PixelWindow& window) const {
  std::vector<PixelPlace> places(window.wanted.size());
  std::vector<CloudSample> samples(window.wanted.size());
  for (int row = 0; row < window.size_px.y; ++row) {
    for (int column = 0; column < window.size_px.x; ++column) {
      const auto k = static_cast<std::size_t>(row * window.size_px.x + column);
      if (!window.wanted[k]) continue;
      const glm::ivec2 pixel = window.first_px + glm::ivec2(column, row);
      places[k] = place_of(layer_, camera_.direction(glm::dvec2(pixel) + 0.5));
      samples[k].distance_m = places[k].distance_m;
    }
  }
  const LayerImage image(layer_, facing(window.first_px.x));
  with_painting(field_, image, leaf_px_,
                [&](auto painting) { painting.paint(window, places, samples); });
  return samples;
}

CloudSample CloudPainter::value(const glm::ivec2& pixel) const {
  const PixelPlace place = place_of(layer_, camera_.direction(glm::dvec2(pixel) + 0.5));
  CloudSample sample;
  if (!place.seen) return sample;
  sample.distance_m = place.distance_m;
  const LayerImage image(layer_, facing(pixel.x));
  with_painting(field_, image, leaf_px_,
                [&](const auto& painting) { sample.value = painting.value(place.place); });
  return sample;
}

SkyCamera CloudPainter::facing(int column_px) const {
  const int window = column_px / kWindow_px;
  return camera_.facing((window + 0.5) * kWindow_px);
}

}  // namespace terrview

// Boxes that a ray enters, in the order in which it does.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <limits>
#include <span>

#include "render/objects/slab_ray.h"

namespace terrview {

// Calls visit(id) for those items of a list whose box the ray enters within a stretch and before
// leave_m, some at a time (most lists are short) in the order in which it does, until visit returns
// true, as this then does. visit may shorten leave_m. Of each item box(item) is the box and
// id(item) the number.
template <class Item, class BoxOf, class IdOf, class Visit>
bool visit_in_order(const SlabRay& slabs, std::span<const Item> items, const Stretch& here,
                    double& leave_m, const BoxOf& box, const IdOf& id, const Visit& visit) {
  struct Entry {
    double at_m;
    int id;
    auto operator<=>(const Entry&) const = default;
  };
  std::array<Entry, 16> entries;
  for (std::size_t begin = 0; begin < items.size(); begin += entries.size()) {
    std::size_t count = 0;
    const std::size_t some = std::min(entries.size(), items.size() - begin);
    for (const Item& item : items.subspan(begin, some)) {
      const auto stretch = slabs.within(box(item), 0, leave_m);
      if (stretch && stretch->enter_m >= here.enter_m && stretch->enter_m <= here.leave_m)
        entries[count++] = {stretch->enter_m, id(item)};
    }
    const std::span<Entry> met(entries.data(), count);
    if (count > 1) std::ranges::sort(met);
    for (const Entry& it : met)
      if (it.at_m <= leave_m && visit(it.id)) return true;
  }
  return false;
}

}  // namespace terrview

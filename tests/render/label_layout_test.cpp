// Where names go: render/label_layout.h.
#include "render/label_layout.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace terrview {
namespace {

struct Rectangle {
  int left, top, right, bottom;  // past the last
};

bool meet(const Rectangle& a, const Rectangle& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

Rectangle box_of(const LabelBox& box) {
  return {box.low_px.x, box.low_px.y, box.high_px.x, box.high_px.y};
}

// The pixels of the leader, its foot included.
Rectangle leader_of(const LabelBox& box, const LabelRequest& request) {
  const int column = leader_column(request);
  return {column, box.high_px.y, column + 1, static_cast<int>(request.anchor_px.y) + 1};
}

RC_GTEST_PROP(LabelLayout, NeverOverlapsAndStaysInThePicture, ()) {
  LabelLayoutOptions options;
  options.size_px = {*rc::gen::inRange(20, 2000), *rc::gen::inRange(20, 800)};
  options.line_px = *rc::gen::inRange(5, 40);
  if (*rc::gen::arbitrary<bool>())
    options.skyline_px.assign(static_cast<std::size_t>(options.size_px.x),
                              *rc::gen::inRange(0, options.size_px.y + 1));
  std::vector<LabelRequest> requests;
  const int count = *rc::gen::inRange(0, 60);
  for (int i = 0; i < count; ++i)
    requests.push_back({{*rc::gen::inRange(0, 100 * options.size_px.x) / 100.0,
                         *rc::gen::inRange(0, 100 * options.size_px.y) / 100.0},
                        *rc::gen::inRange(1, 300)});
  const auto boxes = place_labels(requests, options);
  RC_ASSERT(boxes.size() == requests.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i]) continue;
    const Rectangle box = box_of(*boxes[i]);
    const Rectangle leader = leader_of(*boxes[i], requests[i]);
    RC_ASSERT(box.left >= 0 && box.right <= options.size_px.x && box.top >= 0);
    RC_ASSERT(box.bottom <= static_cast<int>(requests[i].anchor_px.y));
    RC_ASSERT(box.right - box.left == requests[i].width_px);
    RC_ASSERT(box.bottom - box.top == options.line_px);
    RC_ASSERT(leader.left >= box.left && leader.left < box.right);
    for (std::size_t j = 0; j < i; ++j) {
      if (!boxes[j]) continue;
      const Rectangle other = box_of(*boxes[j]);
      const int aside = options.line_px / 2;
      RC_ASSERT(!meet({box.left - aside, box.top, box.right + aside, box.bottom}, other));
      RC_ASSERT(!meet(box, leader_of(*boxes[j], requests[j])));
      RC_ASSERT(!meet(leader, box_of(*boxes[j])));
      RC_ASSERT(!meet(leader, leader_of(*boxes[j], requests[j])));
    }
  }
}

// A label that is left out is so because of those before it.
RC_GTEST_PROP(LabelLayout, GivesTheFirstItsPlaceWhateverFollows, ()) {
  const LabelLayoutOptions options{.size_px = {400, 300}};
  std::vector<LabelRequest> requests;
  for (int i = 0; i < 12; ++i)
    requests.push_back({{*rc::gen::inRange(0, 400) + 0.5, *rc::gen::inRange(40, 300) + 0.5},
                        *rc::gen::inRange(10, 120)});
  const auto all = place_labels(requests, options);
  const auto few = place_labels(std::span(requests).first(6), options);
  for (std::size_t i = 0; i < few.size(); ++i) {
    RC_ASSERT(all[i].has_value() == few[i].has_value());
    if (few[i]) {
      RC_ASSERT(all[i]->low_px == few[i]->low_px);
    }
  }
  RC_ASSERT(all[0].has_value());
}

TEST(LabelLayoutRows, AreTakenFromTheSkylineUp) {
  LabelLayoutOptions options{.size_px = {400, 300}};
  options.skyline_px.assign(400, 120);
  const std::vector<LabelRequest> requests{{{200, 150}, 80}, {{210, 160}, 80}};
  const auto boxes = place_labels(requests, options);
  ASSERT_TRUE(boxes[0] && boxes[1]);
  EXPECT_LE(boxes[0]->high_px.y, 120);
  EXPECT_GT(boxes[0]->high_px.y, 120 - 20);
  EXPECT_NE(boxes[0]->low_px.y, boxes[1]->low_px.y);
}

TEST(LabelLayoutRows, ReachOverGroundWhereThereIsNoSky) {
  LabelLayoutOptions options{.size_px = {400, 300}};
  options.skyline_px.assign(400, 0);
  EXPECT_TRUE(place_labels(std::vector<LabelRequest>{{{200, 150}, 80}}, options)[0]);
}

// Beside a border, or the seam of a whole turn.
TEST(LabelLayoutRows, KeepLabelsWithinThePictureAtItsBorders) {
  const LabelLayoutOptions options{.size_px = {400, 300}};
  for (const double x : {0.0, 3.0, 399.9}) {
    const std::vector<LabelRequest> requests{{{x, 150}, 80}};
    EXPECT_TRUE(place_labels(requests, options)[0]) << x;
  }
}

}  // namespace
}  // namespace terrview

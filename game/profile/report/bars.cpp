#include "game/profile/report/bars.h"

#include <algorithm>
#include <cmath>

namespace gw::profile {

namespace {

constexpr double kLeft = 210, kRight = 190, kRowHeight = 30, kGroupHeight = 34, kBarHeight = 20, kBelow = 58;
constexpr double kTextSize = 12.5, kLabelSize = 11.5;

class BarDrawer {
 public:
  BarDrawer(Svg& svg, const Axis& axis, double from) : svg_(svg), axis_(axis), from_(from) {}

  double x(double value) const {
    const double share = axis_.share(value);
    return kLeft + (kPictureWidth - kLeft - kRight) * std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0);
  }

  void draw(const BarRow& row, double top) {
    const double middle = top + kRowHeight / 2;
    svg_.text({kLeft - 10, middle + 4.5}, fitted(row.label, kTextSize, kLeft - kPadding - 10),
              {.size = kTextSize, .anchor = "end"});
    double value = from_, end = x(from_);
    for (const Segment& segment : row.segments) {
      if (!std::isfinite(segment.value)) continue;
      const double next = from_ > 0 ? segment.value : value + segment.value;  // of logarithms there are no sums
      this->segment(segment, x(std::min(value, next)), x(std::max(value, next)), middle);
      value = next;
      end = std::max(end, x(next));
    }
    if (row.interval && std::isfinite(row.interval->low) && std::isfinite(row.interval->high)) {
      const double low = x(row.interval->low), high = x(row.interval->high);
      for (const Stroke& stroke :
           {Stroke{colour::kPanel, 4.5}, Stroke{colour::kInk, 1.6}}) {  // a rim: bars are of any colour
        svg_.line({low, middle}, {high, middle}, stroke);
        for (const double side : {low, high}) svg_.line({side, middle - 5}, {side, middle + 5}, stroke);
      }
      end = std::max(end, high);
    }
    svg_.text({end + 8, middle + 4.5}, row.end, {.size = kTextSize});
  }

 private:
  void segment(const Segment& segment, double from, double to, double middle) {
    const Point corners[] = {{from, middle - kBarHeight / 2},
                             {to, middle - kBarHeight / 2},
                             {to, middle + kBarHeight / 2},
                             {from, middle + kBarHeight / 2}};
    svg_.area(corners, areaColour(segment.style), 1, true);
    if (widthOf(segment.label, kLabelSize) + 8 > to - from) return;
    svg_.text({(from + to) / 2, middle + 4}, segment.label,
              {.size = kLabelSize, .anchor = "middle", .colour = inkOnArea(segment.style)});
  }

  Svg& svg_;
  const Axis& axis_;
  double from_;
};

}  // namespace

std::string barPicture(const Words& words, std::span<const Key> keys, const Axis& axis, std::span<const BarRow> rows,
                       double from, std::optional<double> mark) {
  std::vector<double> tops;
  const double top = kHeaderHeight + legendHeight(keys) + 12;
  double bottom = top + 4;
  const std::string* group = nullptr;
  for (const BarRow& row : rows) {
    if (!row.group.empty() && (group == nullptr || *group != row.group)) bottom += kGroupHeight;
    group = &row.group;
    tops.push_back(bottom);
    bottom += kRowHeight;
  }
  bottom += 4;

  Svg svg = panel(words, bottom + kBelow);
  legend(svg, keys);
  BarDrawer drawer(svg, axis, from);
  for (const Tick& tick : axis.ticks) {
    svg.text({drawer.x(tick.value), bottom + 18}, tick.label,
             {.size = kTextSize, .anchor = "middle", .colour = colour::kFaint});
  }
  svg.line({kLeft, bottom}, {kPictureWidth - kRight, bottom}, {colour::kFaint, 1.2});
  svg.text({kLeft + (kPictureWidth - kLeft - kRight) / 2, bottom + 42}, axis.label, {.anchor = "middle"});
  for (size_t i = 0; i < rows.size(); ++i) {
    const bool heads = !rows[i].group.empty() && (i == 0 || rows[i].group != rows[i - 1].group);
    if (heads) {
      svg.text({kPadding, tops[i] - 9}, fitted(rows[i].group, 13, kPictureWidth - 2 * kPadding),
               {.size = 13, .bold = true});
    }
    // Along rows only: lines would cross the headings.
    const double end = tops[i] + kRowHeight;
    for (const Tick& tick : axis.ticks) {
      svg.line({drawer.x(tick.value), tops[i]}, {drawer.x(tick.value), end}, {colour::kGrid});
    }
    drawer.draw(rows[i], tops[i]);
    if (mark) svg.line({drawer.x(*mark), tops[i]}, {drawer.x(*mark), end}, {colour::kReference, 1.6, "6 3"});
  }
  return svg.whole();
}

}  // namespace gw::profile

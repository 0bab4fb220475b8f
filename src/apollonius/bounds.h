// A rectangle as a window.
#pragma once

namespace apollonius {

/// An axis-parallel rectangle, in the unit of the coordinates.
struct Bounds {
  double xmin = 0;
  double ymin = 0;
  double xmax = 960;
  double ymax = 500;
};

}  // namespace apollonius

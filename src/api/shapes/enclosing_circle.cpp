// The smallest circle around a diagram: a file of its own, as in JavaScript it belongs to the part
// with shapes.
#include "geometry/enclosing/enclosing_circle.h"

#include "api/checks.h"
#include "apollonius/diagram.h"

namespace apollonius {

using namespace internal;

Error Diagram::enclosingCircle(EnclosingCircle& circle) const {
  return guarded(*core_, [&] {
    const EnclosingCircle none;
    Site found{none.x, none.y, none.r};
    findEnclosingCircle(*core_, found, circle.sites);
    circle.x = found.x;
    circle.y = found.y;
    circle.r = found.r;
  });
}

}  // namespace apollonius

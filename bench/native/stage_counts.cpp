#include "bench/native/stage_counts.h"

#include <sstream>

#include "predicate/stage_counts.h"

namespace apollonius::bench::stages {

void reset() { apollonius::internal::stages::counts() = {}; }

std::string perItem(std::size_t items) {
  const apollonius::internal::stages::Counts& counts = apollonius::internal::stages::counts();
  std::ostringstream text;
  text << ",\"stages\":{";
  const char* separator = "";
  const auto add = [&](const char* name, unsigned long long count) {
    if (count == 0) return;
    text << separator << '"' << name
         << "\":" << static_cast<double>(count) / static_cast<double>(items);
    separator = ",";
  };
  add("lorentzFilter", counts.lorentzFilter);
  add("lorentzMiddle", counts.lorentzMiddle);
  add("lorentzExact", counts.lorentzExact);
  add("distanceFilter", counts.distanceFilter);
  add("distanceMiddle", counts.distanceMiddle);
  add("distanceFixed", counts.distanceFixed);
  add("distanceExact", counts.distanceExact);
  add("vertexOfPoints", counts.vertexOfPoints);
  add("vertexTwofold", counts.vertexTwofold);
  add("vertexFilter", counts.vertexFilter);
  add("vertexMiddle", counts.vertexMiddle);
  add("vertexFixed", counts.vertexFixed);
  add("vertexExact", counts.vertexExact);
  add("vertexDegenerate", counts.vertexDegenerate);
  add("edgeCached", counts.edgeCached);
  add("edgeFilter", counts.edgeFilter);
  add("edgeMiddle", counts.edgeMiddle);
  add("edgeFixed", counts.edgeFixed);
  add("edgeExact", counts.edgeExact);
  add("rayCached", counts.rayCached);
  add("rayFilter", counts.rayFilter);
  add("rayMiddle", counts.rayMiddle);
  add("rayFixed", counts.rayFixed);
  add("rayExact", counts.rayExact);
  text << "}";
  return text.str();
}

}  // namespace apollonius::bench::stages

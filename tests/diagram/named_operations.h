// Every query as an operation by name, for tests that run all of them.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "apollonius/diagram.h"

namespace apollonius::test {

/// An operation on a diagram; results that it returns live as long as the object.
struct NamedOperation {
  std::string name;
  std::function<Error(Diagram&)> run;
};

inline std::vector<NamedOperation> queries(std::size_t n) {
  std::vector<double> xy;
  for (std::size_t k = 0; k < 2 * n; ++k) xy.push_back(static_cast<double>(k * 7 % 13));
  return {
      {"find",
       [](Diagram& d) {
         SiteId id = kNoSite;
         double distance = 0;
         return d.find(3.5, 2.25, id, distance);
       }},
      {"findMany", [=, ids = std::vector<SiteId>(n), distances = std::vector<double>(n)](
                       Diagram& d) mutable { return d.findMany(xy, ids, distances); }},
      {"kNearest",
       [=](Diagram& d) {
         std::vector<SiteId> sites;
         return d.kNearest(3.5, 2.25, n, sites);
       }},
      {"within",
       [](Diagram& d) {
         std::vector<SiteId> sites;
         return d.within(3.5, 2.25, 1e6, sites);
       }},
      {"pick",
       [](Diagram& d) {
         SiteId id = kNoSite;
         return d.pick(3.5, 2.25, 1e6, Top::kSmallest, id);
       }},
      {"search",
       [](Diagram& d) {
         std::vector<SiteId> sites;
         return d.search(-1e5, -1e5, 2e5, 3e5, sites);
       }},
      {"neighbors",
       [=](Diagram& d) {
         std::vector<SiteId> sites;
         Error error = Error::kNone;
         for (SiteId id = 0; id < n && error == Error::kNone; ++id) error = d.neighbors(id, sites);
         return error;
       }},
      {"coverOf",
       [=](Diagram& d) {
         SiteId cover = kNoSite;
         Error error = Error::kNone;
         for (SiteId id = 0; id < n && error == Error::kNone; ++id) error = d.coverOf(id, cover);
         return error;
       }},
      {"ids",
       [](Diagram& d) {
         std::vector<SiteId> ids;
         return d.ids(ids);
       }},
      {"sites",
       [](Diagram& d) {
         SiteArrays sites;
         return d.sites(sites);
       }},
      {"vertices",
       [](Diagram& d) {
         VertexArrays vertices;
         return d.vertices(vertices);
       }},
      {"edges",
       [](Diagram& d) {
         EdgeArrays edges;
         return d.edges(edges);
       }},
      {"faces",
       [](Diagram& d) {
         std::vector<SiteId> sites;
         return d.faces(sites);
       }},
      {"levels",
       [](Diagram& d) {
         std::vector<std::uint8_t> levels;
         return d.levels(levels);
       }},
      {"toBytes",
       [](Diagram& d) {
         std::vector<std::uint8_t> bytes;
         return d.toBytes(bytes);
       }},
      {"validate",
       [](Diagram& d) {
         std::string broken;
         return d.validate(broken);
       }},
  };
}

}  // namespace apollonius::test

// CGAL's diagram as a contender: see bench/native/contender.h for how to talk to it. A program of
// its own, because CGAL is GPL: it is never linked to the library, and only CGAL's documented
// interface is used.
//
//   build          range insert into the hierarchy (CGAL chooses the order)
//   buildSorted    CGAL's best effort: spatially sorted centres into the plain graph, each inserted
//                  near the one before
//   insert         one by one in the order of the file, into the hierarchy
//   find, findNear, remove     on the hierarchy
#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Apollonius_graph_hierarchy_2.h>
#include <CGAL/Apollonius_site_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "bench/native/contender.h"

namespace {

using contender::Answer;
using contender::Request;
using Kernel = CGAL::Simple_cartesian<double>;
using Traits =
    CGAL::Apollonius_graph_filtered_traits_2<Kernel>;  // exact: interval filter, then MP_Float
using Hierarchy = CGAL::Apollonius_graph_hierarchy_2<Traits>;
using Graph = CGAL::Apollonius_graph_2<Traits>;
using Point = Kernel::Point_2;
using Site = Traits::Site_2;

class Cgal {
 public:
  Answer answer(const Request& request) {
    Answer answer;
    load(request.set);
    if (sites_.empty()) {
      answer.error = "no sites in " + request.set;
      return answer;
    }
    const std::string& operation = request.operation;
    if (operation == "build") return build(request);
    if (operation == "buildSorted") return buildSorted(request);
    if (operation == "insert") return insert(request);
    if (operation == "find" || operation == "findNear") return find(request);
    if (operation == "remove") return remove(request);
    answer.error = "unknown operation " + operation;
    return answer;
  }

 private:
  void load(const std::string& set) {
    if (set == set_) return;
    set_ = set;
    sites_.clear();
    const std::vector<double> numbers = contender::readDoubles(set + ".sites");
    for (std::size_t k = 0; k + 2 < numbers.size(); k += 3)
      sites_.emplace_back(Point(numbers[k], numbers[k + 1]), numbers[k + 2]);
    hierarchy_ = std::make_unique<Hierarchy>();
    isWhole_ = false;
  }

  void ensureDiagram() {
    if (isWhole_) return;
    hierarchy_ = std::make_unique<Hierarchy>();
    hierarchy_->insert(sites_.begin(), sites_.end());
    isWhole_ = true;
  }

  Answer build(const Request& request) {
    Answer answer = contender::sampled(
        request, sites_.size(), [&] { hierarchy_ = std::make_unique<Hierarchy>(); },
        [&](std::size_t&) { hierarchy_->insert(sites_.begin(), sites_.end()); });
    isWhole_ = true;
    answer.visible = hierarchy_->number_of_visible_sites();
    return answer;
  }

  Answer buildSorted(const Request& request) {
    std::unique_ptr<Graph> graph;
    std::vector<std::pair<Point, double>> sorted;
    const auto prepare = [&] {
      graph = std::make_unique<Graph>();
      sorted.clear();
      for (const Site& site : sites_) sorted.emplace_back(site.point(), site.weight());
    };
    using Map = CGAL::First_of_pair_property_map<std::pair<Point, double>>;
    Answer answer = contender::sampled(request, sites_.size(), prepare, [&](std::size_t&) {
      CGAL::spatial_sort(sorted.begin(), sorted.end(),
                         CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>());
      Graph::Vertex_handle last;
      for (const auto& [point, weight] : sorted) {
        const Graph::Vertex_handle vertex = last == Graph::Vertex_handle()
                                                ? graph->insert(Site(point, weight))
                                                : graph->insert(Site(point, weight), last);
        if (vertex != Graph::Vertex_handle()) last = vertex;  // none for a hidden site
      }
    });
    answer.visible = graph->number_of_visible_sites();
    return answer;
  }

  Answer insert(const Request& request) {
    isWhole_ = false;
    const std::size_t count =
        request.count > 0 ? std::min(request.count, sites_.size()) : sites_.size();
    Answer answer = contender::sampled(
        request, count, [&] { hierarchy_ = std::make_unique<Hierarchy>(); },
        [&](std::size_t& items) {
          contender::forEachUntil(request.limit, items,
                                  [&](std::size_t k) { hierarchy_->insert(sites_[k]); });
        });
    answer.visible = hierarchy_->number_of_visible_sites();
    return answer;
  }

  Answer find(const Request& request) {
    ensureDiagram();
    std::vector<double> points =
        contender::readDoubles(set_ + (request.operation == "findNear" ? ".near" : ".box"));
    if (request.count > 0) points.resize(std::min(points.size(), 2 * request.count));
    double sum = 0;
    Answer answer = contender::sampled(
        request, points.size() / 2, [&] { sum = 0; },
        [&](std::size_t& items) {
          contender::forEachUntil(request.limit, items, [&](std::size_t k) {
            sum += hierarchy_->nearest_neighbor(Point(points[2 * k], points[2 * k + 1]))
                       ->site()
                       .weight();
          });
        });
    answer.sink = sum;
    answer.visible = hierarchy_->number_of_visible_sites();
    return answer;
  }

  /// The visible ones among the last `count` sites, last first.
  std::vector<Hierarchy::Vertex_handle> visibleAtEnd(std::size_t count) {
    std::map<std::tuple<double, double, double>, Hierarchy::Vertex_handle> vertices;
    for (auto vertex = hierarchy_->finite_vertices_begin();
         vertex != hierarchy_->finite_vertices_end(); ++vertex) {
      const Site& site = vertex->site();
      vertices.emplace(std::tuple(site.x(), site.y(), site.weight()), vertex);
    }
    std::vector<Hierarchy::Vertex_handle> found;
    for (std::size_t k = 0; k < count; ++k) {
      const Site& site = sites_[sites_.size() - 1 - k];
      const auto vertex = vertices.find(std::tuple(site.x(), site.y(), site.weight()));
      if (vertex == vertices.end()) continue;
      found.push_back(vertex->second);
      vertices.erase(vertex);  // duplicates
    }
    return found;
  }

  Answer remove(const Request& request) {
    const std::size_t count =
        request.count > 0 ? std::min(request.count, sites_.size()) : sites_.size();
    ensureDiagram();
    std::vector<Hierarchy::Vertex_handle> vertices = visibleAtEnd(count);
    const auto prepare = [&] {
      if (isWhole_) return;
      ensureDiagram();
      vertices = visibleAtEnd(count);
    };
    Answer answer = contender::sampled(request, vertices.size(), prepare, [&](std::size_t& items) {
      isWhole_ = false;
      contender::forEachUntil(request.limit, items,
                              [&](std::size_t k) { hierarchy_->remove(vertices[k]); });
    });
    answer.visible = hierarchy_->number_of_visible_sites();
    return answer;
  }

  std::string set_;
  std::vector<Site> sites_;
  std::unique_ptr<Hierarchy> hierarchy_ = std::make_unique<Hierarchy>();
  bool isWhole_ = false;  // hierarchy_ holds exactly sites_
};

}  // namespace

int main(int argc, char** argv) {
  Cgal cgal;
  return contender::serve(argc, argv, [&](const Request& request) { return cgal.answer(request); });
}

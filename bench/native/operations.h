// The measured operations on this library, one function each.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "bench/native/contender.h"

namespace apollonius::bench {

using contender::Answer;
using contender::forEachUntil;
using contender::Request;
using contender::sampled;

/// Keeps the last set and its diagram, so that several queries in a row need one construction.
class Operations {
 public:
  Answer answer(const Request& request);

 private:
  using Operation = Answer (Operations::*)(const Request&);
  static const std::map<std::string, Operation>& operations();

  Answer build(const Request& request);
  Answer insert(const Request& request);
  Answer insertByWalk(const Request& request);
  Answer find(const Request& request);
  Answer findMany(const Request& request);
  Answer kNearest(const Request& request);
  Answer toBytes(const Request& request);
  Answer fromBytes(const Request& request);
  Answer remove(const Request& request);
  Answer removeMany(const Request& request);
  Answer removeNearest(const Request& request);
  Answer update(const Request& request);
  Answer updateMany(const Request& request);

  Answer insertOneByOne(const Request& request, Location location);
  Answer removed(const Request& request, bool atOnce);
  Answer moved(const Request& request, bool atOnce);

  void load(const std::string& set);
  void buildDiagram();
  void ensureDiagram();
  std::vector<double> queries(const Request& request) const;
  std::vector<SiteId> visibleAtEnd(std::size_t count) const;

  std::size_t size() const { return sites_.size() / 3; }

  std::string set_;
  std::vector<double> sites_;  // x, y, r triples
  Diagram diagram_;
  std::vector<SiteId> ids_;
  bool isWhole_ = false;  // diagram_ holds exactly sites_
};

}  // namespace apollonius::bench

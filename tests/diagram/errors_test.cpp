// Bad input: the right error code, and a diagram that is what it was, ids and canonical form alike.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "support/insert_into.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

class Errors : public ::testing::Test {
 protected:
  Errors() {
    Random random(261);
    ids_ = insertInto(diagram_, tinyGrid(random, 30, 12, 4));
    before_ = state();
  }

  ~Errors() override { EXPECT_EQ(state(), before_) << "a failed call changed the diagram"; }

  /// Everything that can be asked, as text.
  std::string state() const {
    std::string broken;
    std::string text = difference({}, canonicalForm(diagram_, broken)) + broken;
    std::vector<SiteId> list;
    EXPECT_EQ(diagram_.ids(list), Error::kNone);
    for (const SiteId id : list) {
      Circle c{};
      EXPECT_EQ(diagram_.site(id, c), Error::kNone);
      text += std::to_string(id) + ":" + toText(insertAll({c}));
    }
    VertexArrays vertices;
    EdgeArrays edges;
    EXPECT_EQ(diagram_.vertices(vertices), Error::kNone);
    EXPECT_EQ(diagram_.edges(edges), Error::kNone);
    for (const std::uint32_t site : vertices.sites) text += std::to_string(site) + ",";
    for (const std::int32_t vertex : edges.vertices) text += std::to_string(vertex) + ",";
    return text;
  }

  Diagram diagram_;
  std::vector<SiteId> ids_;
  std::string before_;
};

struct BadNumber {
  double value;
  Error error;
};

const BadNumber kBadNumbers[] = {
    {kNan, Error::kNotFinite},       {kInf, Error::kNotFinite},
    {-kInf, Error::kNotFinite},      {1.01e100, Error::kOutOfRange},
    {-1.01e100, Error::kOutOfRange}, {0.99e-100, Error::kOutOfRange},
    {-1e-300, Error::kOutOfRange},   {5e-324, Error::kOutOfRange},
    {1.7e308, Error::kOutOfRange},
};

TEST_F(Errors, BadNumbersInEveryPlace) {
  for (const auto& [value, error] : kBadNumbers) {
    for (int place = 0; place < 3; ++place) {
      double xyr[] = {1, 2, 3};
      xyr[place] = value;
      SiteId id = 12345;
      EXPECT_EQ(diagram_.insert(xyr[0], xyr[1], xyr[2], id), error) << value;
      EXPECT_EQ(diagram_.update(ids_[3], xyr[0], xyr[1], xyr[2]), error) << value;
      double many[] = {50, 50, 1, 60, 60, 1, 70, 70, 1};
      for (int triple = 0; triple < 3; ++triple) {
        const double kept = many[3 * triple + place];
        many[3 * triple + place] = value;
        SiteId some[3] = {};
        EXPECT_EQ(diagram_.insertMany(many, some), error) << value;
        EXPECT_EQ(diagram_.updateMany(std::span(ids_).first(3), many), error) << value;
        many[3 * triple + place] = kept;
      }
      if (place == 2) continue;
      double distance = 0;
      EXPECT_EQ(diagram_.find(xyr[0], xyr[1], id, distance), error) << value;
      const double points[] = {0, 0, xyr[0], xyr[1]};
      SiteId some[2] = {};
      double distances[2] = {};
      EXPECT_EQ(diagram_.findMany(points, some, distances), error) << value;
    }
  }
}

TEST_F(Errors, EndsOfTheRangeAreLegal) {
  Diagram diagram;
  SiteId id = kNoSite;
  for (const double value : {kLargestMagnitude, -kLargestMagnitude, kSmallestMagnitude,
                             -kSmallestMagnitude, 0.0, -0.0}) {
    EXPECT_EQ(diagram.insert(value, 1, 1, id), Error::kNone) << value;
    EXPECT_EQ(diagram.insert(1, value, 1, id), Error::kNone) << value;
    EXPECT_EQ(diagram.insert(1, 1, value, id), Error::kNone) << value;
    double distance = 0;
    EXPECT_EQ(diagram.find(value, -value, id, distance), Error::kNone) << value;
    std::string broken;
    EXPECT_EQ(diagram.validate(broken), Error::kNone);
    EXPECT_EQ(broken, "") << value;
  }
}

TEST_F(Errors, UnknownSites) {
  for (const SiteId id :
       {static_cast<SiteId>(ids_.size()), kNoSite, kNoSite - 1, SiteId{1} << 31}) {
    EXPECT_FALSE(diagram_.has(id));
    Circle circle{};
    EXPECT_EQ(diagram_.site(id, circle), Error::kUnknownSite);
    bool flag = false;
    EXPECT_EQ(diagram_.isHidden(id, flag), Error::kUnknownSite);
    SiteId cover = 0;
    EXPECT_EQ(diagram_.coverOf(id, cover), Error::kUnknownSite);
    std::vector<SiteId> neighbors;
    EXPECT_EQ(diagram_.neighbors(id, neighbors), Error::kUnknownSite);
    EXPECT_EQ(diagram_.update(id, 1, 1, 1), Error::kUnknownSite);
    const SiteId mixed[] = {ids_[0], id};
    const double xyr[] = {50, 50, 1, 60, 60, 1};
    EXPECT_EQ(diagram_.updateMany(mixed, xyr), Error::kUnknownSite);
    bool removed = true;
    EXPECT_EQ(diagram_.remove(id, removed), Error::kNone) << "not an error";
    EXPECT_FALSE(removed);
    std::size_t count = 99;
    EXPECT_EQ(diagram_.removeMany(std::span(&id, 1), count), Error::kNone);
    EXPECT_EQ(count, 0u);
  }
}

TEST_F(Errors, WrongLengths) {
  const double xyr[] = {50, 50, 1, 60, 60, 1, 70};
  SiteId some[3] = {};
  EXPECT_EQ(diagram_.insertMany(xyr, std::span(some, 2)), Error::kBadLength);
  EXPECT_EQ(diagram_.insertMany(std::span(xyr).first(6), some), Error::kBadLength);
  EXPECT_EQ(diagram_.updateMany(std::span(ids_).first(2), xyr), Error::kBadLength);
  EXPECT_EQ(diagram_.updateMany(std::span(ids_).first(3), std::span(xyr).first(6)),
            Error::kBadLength);
  double distances[2] = {};
  EXPECT_EQ(diagram_.findMany(std::span(xyr).first(5), std::span(some, 2), distances),
            Error::kBadLength);
  EXPECT_EQ(diagram_.findMany(std::span(xyr).first(4), some, distances), Error::kBadLength);
  EXPECT_EQ(diagram_.findMany(std::span(xyr).first(6), some, distances), Error::kBadLength);
}

TEST_F(Errors, ArraysThatAreGivenUp) {
  std::vector<SiteId> ids{7};
  EXPECT_EQ(diagram_.insertMany(std::vector<double>(), ids), Error::kNone);
  EXPECT_TRUE(ids.empty());
  const std::size_t size = diagram_.size();
  EXPECT_EQ(diagram_.insertMany(std::vector<double>(4), ids), Error::kBadLength);
  std::vector<double> xyr(3);
  xyr[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(diagram_.insertMany(std::move(xyr), ids), Error::kNotFinite);
  EXPECT_EQ(diagram_.size(), size);
}

TEST(EmptyDiagram, FindManyFindsNothingInfinitelyFarAway) {
  const Diagram empty;
  std::vector<SiteId> ids(2, 5);
  std::vector<double> distances(2, 0);
  const double points[] = {1, 2, 3, 4};
  ASSERT_EQ(empty.findMany(points, ids, distances), Error::kNone);
  EXPECT_EQ(ids, std::vector<SiteId>(2, kNoSite));
  EXPECT_EQ(distances, std::vector<double>(2, std::numeric_limits<double>::infinity()));
}

TEST_F(Errors, EmptyBatchesAreFine) {
  std::size_t removed = 99;
  EXPECT_EQ(diagram_.insertMany({}, {}), Error::kNone);
  EXPECT_EQ(diagram_.updateMany({}, {}), Error::kNone);
  EXPECT_EQ(diagram_.removeMany({}, removed), Error::kNone);
  EXPECT_EQ(removed, 0u);
  EXPECT_EQ(diagram_.findMany({}, {}, {}), Error::kNone);
}

}  // namespace
}  // namespace apollonius::test

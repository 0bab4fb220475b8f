// Bad input gives the right error code, and leaves the diagram's ids and canonical form unchanged.
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

  /// All answers of the diagram, as text.
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

}  // namespace
}  // namespace apollonius::test

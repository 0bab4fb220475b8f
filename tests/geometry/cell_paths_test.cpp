// Cells as the text of SVG paths: the numbers of the drawings, rounded and written as JavaScript
// does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "geometry/draw/path_writer.h"
#include "geometry/shapes.h"
#include "support/generators.h"
#include "support/operations.h"

namespace apollonius::test {
namespace {

std::string written(double x, unsigned digits) {
  Path path;
  path.move(x, 0);
  std::vector<std::uint8_t> text;
  return internal::PathWriter(digits).write(path, text) ? std::string(text.begin(), text.end())
                                                        : "too long";
}

TEST(PathWriter, WritesNumbersAsJavaScriptDoes) {
  EXPECT_EQ(written(0, 3), "M0,0");
  EXPECT_EQ(written(-0.0, 3), "M0,0");
  EXPECT_EQ(written(-0.0004, 3), "M0,0");
  EXPECT_EQ(written(-0.0006, 3), "M-0.001,0");
  EXPECT_EQ(written(0.5, 0), "M1,0");  // halves upwards
  EXPECT_EQ(written(-0.5, 0), "M0,0");
  EXPECT_EQ(written(120, 3), "M120,0");
  EXPECT_EQ(written(-123.456, 2), "M-123.46,0");
  EXPECT_EQ(written(0.000001, 8), "M0.000001,0");
  EXPECT_EQ(written(0.0000001, 8), "M1e-7,0");
  EXPECT_EQ(written(-0.00000012, 8), "M-1.2e-7,0");
  EXPECT_EQ(written(1.5e-10, 11), "M1.5e-10,0");
  EXPECT_EQ(written(123456789012.5, 3), "M123456789012.5,0");
  EXPECT_EQ(written(999999999999.999, 3), "M999999999999.999,0");
  EXPECT_EQ(written(1e12, 3), "too long");
  EXPECT_EQ(written(-1e300, 0), "too long");
}

/// The commands and numbers of a text.
Path parsed(const std::string& text) {
  Path path;
  const char* at = text.c_str();
  while (*at != '\0') {
    const std::size_t command = std::string("MLCZ").find(*at++);
    EXPECT_NE(command, std::string::npos) << text;
    path.commands.push_back(static_cast<std::uint8_t>(command));
    while (*at == ',' || *at == '-' || (*at >= '0' && *at <= '9')) {
      if (*at == ',') ++at;
      char* end = nullptr;
      path.coordinates.push_back(std::strtod(at, &end));
      at = end;
    }
  }
  return path;
}

/// Random circles, of which some are hidden and some are outside of the window.
struct Scene {
  Scene(std::uint64_t seed, std::size_t n) {
    Random random(seed);
    circles = randomCircles(random, n, Hidden::k20Percent);
    insertInto(diagram, circles);
    EXPECT_TRUE(windowAround(circles, -0.3, bounds));
  }

  Circles circles;
  Diagram diagram;
  Bounds bounds;
};

TEST(CellPaths, AreTheDrawingsOfTheCells) {
  const Scene scene(14, 60);
  const auto& [circles, diagram, bounds] = scene;
  const Voronoi voronoi(diagram, bounds);
  const double tolerance = (bounds.xmax - bounds.xmin) / 1000;
  std::vector<bool> isDrawn(circles.size(), false);
  Portion portion{0, 25};
  while (!portion.isDone) {
    CellPaths paths;
    ASSERT_EQ(voronoi.cellPaths(tolerance, 3, portion, paths), Error::kNone);
    std::size_t begin = 0;
    for (std::size_t k = 0; k < paths.ends.size(); k += 2) {
      const auto id = static_cast<SiteId>(paths.ends[k]);
      const auto end = static_cast<std::size_t>(paths.ends[k + 1]);
      const auto* text = paths.content.data();
      const Path path = parsed(std::string(text + begin, text + end));
      Path cell;
      ASSERT_EQ(voronoi.drawCell(id, tolerance, cell), Error::kNone);
      ASSERT_EQ(path.commands, cell.commands) << id;
      ASSERT_EQ(path.coordinates.size(), cell.coordinates.size()) << id;
      for (std::size_t m = 0; m < path.coordinates.size(); ++m)
        ASSERT_NEAR(path.coordinates[m], cell.coordinates[m], 0.0005001) << id;
      isDrawn[id] = true;
      begin = end;
    }
  }
  for (SiteId id = 0; id < circles.size(); ++id) {
    Path cell;
    ASSERT_EQ(voronoi.drawCell(id, tolerance, cell), Error::kNone);
    EXPECT_EQ(isDrawn[id], !cell.commands.empty()) << id;
  }
  CellPaths paths;
  EXPECT_EQ(voronoi.cellPaths(tolerance, 16, portion, paths), Error::kOutOfRange);
}

TEST(CellDrawings, AreTheDrawingsOfTheCellsOneAfterTheOther) {
  const Scene scene(15, 80);
  const Voronoi voronoi(scene.diagram, scene.bounds);
  std::size_t drawn = 0;
  Portion portion{0, 25};
  while (!portion.isDone) {
    CellDrawings cells;
    ASSERT_EQ(voronoi.drawCells(0.01, portion, cells), Error::kNone);
    Path joined;
    for (std::size_t k = 0; k < cells.ends.size(); k += 2, ++drawn) {
      Path cell;
      ASSERT_EQ(voronoi.drawCell(static_cast<SiteId>(cells.ends[k]), 0.01, cell), Error::kNone);
      EXPECT_FALSE(cell.commands.empty());
      joined.commands.insert(joined.commands.end(), cell.commands.begin(), cell.commands.end());
      joined.coordinates.insert(joined.coordinates.end(), cell.coordinates.begin(),
                                cell.coordinates.end());
      EXPECT_EQ(cells.ends[k + 1], joined.commands.size());
    }
    EXPECT_EQ(cells.content.commands, joined.commands);
    EXPECT_EQ(cells.content.coordinates, joined.coordinates);
  }
  std::vector<double> areas;
  ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
  EXPECT_EQ(drawn, areas.size() - std::count(areas.begin(), areas.end(), 0.0));
}

TEST(CellPaths, OfNumbersWithTooManyDigitsAreNotDone) {
  Diagram diagram;
  insertInto(diagram, {{1e14, 0, 0}});
  Portion portion;
  CellPaths paths;
  const Voronoi voronoi(diagram, {0, 0, 1e15, 1e15});
  ASSERT_EQ(voronoi.cellPaths(1, 3, portion, paths), Error::kNone);
  EXPECT_FALSE(portion.isDone);
  EXPECT_TRUE(paths.ends.empty());
}

}  // namespace
}  // namespace apollonius::test

// A drawing as data: commands and their coordinates, those that canvas, SVG and d3-path have in
// common, so that it can be replayed into any of these. Standard types only: users get it with
// apollonius/voronoi.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace apollonius {

enum class Command : std::uint8_t {
  kMove,   ///< 1 point
  kLine,   ///< 1 point
  kCurve,  ///< 3 points: cubic Bezier
  kClose,  ///< no point
};

struct Path {
  std::vector<std::uint8_t> commands;  ///< values of Command
  std::vector<double> coordinates;     ///< x, y of each point

  void clear() {
    commands.clear();
    coordinates.clear();
  }
  /// Adds separate segments, x0, y0, x1, y1 each.
  void segments(const double* ends, std::size_t count) {
    coordinates.insert(coordinates.end(), ends, ends + 4 * count);
    std::size_t at = commands.size();
    commands.resize(at + 2 * count);
    for (; at < commands.size(); at += 2) {
      commands[at] = static_cast<std::uint8_t>(Command::kMove);
      commands[at + 1] = static_cast<std::uint8_t>(Command::kLine);
    }
  }
  void move(double x, double y) {
    add(Command::kMove);
    addPoint(x, y);
  }
  void line(double x, double y) {
    add(Command::kLine);
    addPoint(x, y);
  }
  void curve(double x1, double y1, double x2, double y2, double x, double y) {
    add(Command::kCurve);
    addPoint(x1, y1);
    addPoint(x2, y2);
    addPoint(x, y);
  }
  void close() { add(Command::kClose); }

 private:
  void add(Command command) { commands.push_back(static_cast<std::uint8_t>(command)); }
  void addPoint(double x, double y) {
    coordinates.push_back(x);
    coordinates.push_back(y);
  }
};

/// A drawing in portions: start with cursor 0 and go on until isDone. Each call draws about this
/// many commands.
struct Portion {
  std::size_t cursor = 0;
  std::size_t commands = static_cast<std::size_t>(-1);
  bool isDone = false;
};

/// Cells, one after the other, as drawings or as SVG path data (ASCII).
template <class Content>
struct CellsOf {
  Content content;
  std::vector<double> ends;  ///< each cell's site, and where its commands or its text end
};
using CellDrawings = CellsOf<Path>;
using CellPaths = CellsOf<std::vector<std::uint8_t>>;

}  // namespace apollonius

// A drawing as data: commands and their coordinates, in the words that canvas, SVG and d3-path share. Whoever holds one can play
// it into any of those. Standard types only: users get it with voronoi.h.
#pragma once

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
  std::vector<std::uint8_t> commands;  ///< of Command
  std::vector<double> coordinates;     ///< x, y of each point

  void clear() {
    commands.clear();
    coordinates.clear();
  }
  void move(double x, double y) { add(Command::kMove, x, y); }
  void line(double x, double y) { add(Command::kLine, x, y); }
  void curve(double x1, double y1, double x2, double y2, double x, double y) {
    commands.push_back(static_cast<std::uint8_t>(Command::kCurve));
    coordinates.insert(coordinates.end(), {x1, y1, x2, y2, x, y});
  }
  void close() { commands.push_back(static_cast<std::uint8_t>(Command::kClose)); }

 private:
  void add(Command command, double x, double y) {
    commands.push_back(static_cast<std::uint8_t>(command));
    coordinates.insert(coordinates.end(), {x, y});
  }
};

}  // namespace apollonius

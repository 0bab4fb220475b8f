// d3-delaunay's names over a Diagram, as a chart would write them to try this package without
// changing anything else. d3_report.mjs lists the differences, with reasons.
import { Diagram } from "../../../build/packed/consumer.mjs";

/** Points are sites of radius 0; ids are rows. */
export class Delaunay {
  constructor(points) {
    this.points = points;
    this.diagram = new Diagram();
    this.update();
  }

  static from(points, fx = ([x]) => x, fy = ([, y]) => y, that = undefined) {
    const items = Array.from(points);
    const flat = new Float64Array(2 * items.length);
    items.forEach((item, k) => {
      flat[2 * k] = fx.call(that, item, k, points);
      flat[2 * k + 1] = fy.call(that, item, k, points);
    });
    return new Delaunay(flat);
  }

  update() {
    const { points, diagram } = this;
    const xyr = Float64Array.from({ length: (points.length / 2) * 3 }, (_, k) =>
      k % 3 === 2 ? 0 : points[2 * Math.floor(k / 3) + (k % 3)],
    );
    if (diagram.size === xyr.length / 3) diagram.updateMany(diagram.ids(), xyr);
    else diagram.clear().insertMany(xyr);
    return this;
  }

  get triangles() {
    return this.diagram.triangulation().triangles;
  }
  get halfedges() {
    return this.diagram.triangulation().halfedges;
  }
  trianglePolygon(i) {
    return this.diagram.triangulation().trianglePolygon(i);
  }
  trianglePolygons() {
    return this.diagram.triangulation().trianglePolygons();
  }
  renderTriangle(i, context) {
    return this.diagram.triangulation().renderTriangle(i, context);
  }
  hullPolygon() {
    return this.diagram.triangulation().hullPolygon();
  }
  get hull() {
    return this.diagram.hull();
  }
  get collinear() {
    const ids = [...this.diagram.ids()];
    const { points } = this;
    return this.triangles.length === 0 && ids.length > 2
      ? Int32Array.from(
          ids.sort(
            (a, b) => points[2 * a] - points[2 * b] || points[2 * a + 1] - points[2 * b + 1],
          ),
        )
      : undefined;
  }
  find(x, y) {
    return Number.isNaN(x + y) ? -1 : this.diagram.find(x, y);
  }
  neighbors(i) {
    return this.diagram.neighbors(i).values();
  }
  voronoi(bounds) {
    return new Voronoi(this, bounds);
  }
  render(context) {
    return this.diagram.render(context);
  }
  renderHull(context) {
    return this.diagram.renderHull(context);
  }
}

class Voronoi {
  constructor(delaunay, bounds) {
    this.delaunay = delaunay;
    this.view = delaunay.diagram.voronoi(bounds);
    for (const name of ["xmin", "ymin", "xmax", "ymax"]) this[name] = this.view[name];
  }
  update() {
    this.delaunay.update();
    return this;
  }
  get circumcenters() {
    return this.delaunay.diagram.vertices().xy;
  }
  contains(i, x, y) {
    return this.view.contains(i, x, y);
  }
  neighbors(i) {
    return this.view.neighbors(i).values();
  }
  render(context) {
    return this.view.render(context);
  }
  renderBounds(context) {
    return this.view.renderBounds(context);
  }
  renderCell(i, context) {
    return this.view.renderCell(i, context);
  }
  cellPolygon(i) {
    return this.view.cellPolygon(i);
  }
  *cellPolygons() {
    for (const i of this.delaunay.diagram.ids()) {
      const cell = this.cellPolygon(i);
      if (cell) yield Object.assign(cell, { index: i });
    }
  }
}

// The Delaunay graph in the arrays of d3-delaunay and delaunator.
import { ApolloniusError } from "../errors.js";
import { described } from "./arguments.js";
import type { AnyNative, NativeDiagram } from "./native/module.js";
import { drawn, type DrawOptions, type PathContext } from "./path.js";
import type { Position } from "./types.js";

/**
 * The Delaunay graph as it was when `diagram.triangulation()` was called, in d3-delaunay's names
 * and arrays: code written for those works on it. Triangle t has the half-edges 3 t, 3 t + 1 and 3
 * t + 2, and is row t of `diagram.vertices()`, as the diagram was then.
 *
 * With equal radii it is the Delaunay triangulation of the centres. With others it is a graph, and
 * its triangles, drawn straight, may overlap: two sites can have several edges in common, so an
 * edge is its half-edge, not its pair of sites; a site can have two edges only, and then is in two
 * triangles with the same other two. Twins still come in pairs: each half-edge's twin runs the
 * other way between the same two sites. Points in line have no triangles.
 */
export interface Triangulation {
  /** x, y of each site by id, hidden ones too; NaN for ids without one. */
  readonly points: Float64Array;
  /**
   * The ids of each triangle's sites, counter-clockwise (y upwards; delaunator's are the other way
   * round): where each half-edge starts.
   */
  readonly triangles: Uint32Array;
  /** The twin of each half-edge, in the triangle on its other side; -1 on the outer border. */
  readonly halfedges: Int32Array;
  /** As `diagram.hull()`: of the circles, not of their centres. */
  readonly hull: Uint32Array;
  /** The three centres of a triangle as a closed ring. Throws "out-of-range". */
  trianglePolygon(triangle: number): Position[];
  /** All of them. */
  trianglePolygons(): Generator<Position[], void>;
  /** Draws a triangle, straight. Throws "out-of-range", "bad-option" as `diagram.render`. */
  renderTriangle(triangle: number, context: PathContext, options?: DrawOptions): void;
  renderTriangle(triangle: number, context?: null, options?: DrawOptions): string;
  renderTriangle(
    triangle: number,
    context?: PathContext | null,
    options?: DrawOptions,
  ): string | void;
  /** The centres of the sites of `hull` as a closed ring. Empty without sites. */
  hullPolygon(): Position[];
}

/** @internal */
export function triangulationOf(native: NativeDiagram): Triangulation {
  const { points, triangles, halfedges } = trianglesOf(native);
  return new Arrays(points, triangles, halfedges, native.hull());
}

/** @internal The arrays that a diagram of the sphere has, too. */
export function trianglesOf(native: AnyNative) {
  const { ids, xyr } = native.sites();
  const points = new Float64Array(2 * native.idLimit()).fill(NaN);
  ids.forEach((id, k) => points.set(xyr.subarray(3 * k, 3 * k + 2), 2 * id));
  const { sites: triangles } = native.vertices();
  return { points, triangles, halfedges: twinsOf(native, triangles) };
}

class Arrays implements Triangulation {
  constructor(
    readonly points: Float64Array,
    readonly triangles: Uint32Array,
    readonly halfedges: Int32Array,
    readonly hull: Uint32Array,
  ) {}

  trianglePolygon(triangle: number): Position[] {
    const count = this.triangles.length / 3;
    if (Number.isInteger(triangle) && triangle >= 0 && triangle < count)
      return this.#ringOf(this.triangles.subarray(3 * triangle, 3 * triangle + 3));
    throw new ApolloniusError(
      "out-of-range",
      `triangle is ${described(triangle)}, expected a whole number below ${count}`,
    );
  }

  *trianglePolygons(): Generator<Position[], void> {
    for (let triangle = 0; 3 * triangle < this.triangles.length; ++triangle)
      yield this.trianglePolygon(triangle);
  }

  renderTriangle(triangle: number, context: PathContext, options?: DrawOptions): void;
  renderTriangle(triangle: number, context?: null, options?: DrawOptions): string;
  renderTriangle(
    triangle: number,
    context?: PathContext | null,
    options?: DrawOptions,
  ): string | void {
    const [a, b, c] = this.trianglePolygon(triangle) as [Position, Position, Position];
    return drawn(context, options, (target) => {
      target.moveTo(...a);
      target.lineTo(...b);
      target.lineTo(...c);
      target.closePath();
    });
  }

  hullPolygon(): Position[] {
    return this.#ringOf(this.hull);
  }

  #ringOf(sites: Uint32Array): Position[] {
    const ids = [...sites, ...sites.subarray(0, 1)];
    return ids.map((id) => [this.points[2 * id]!, this.points[2 * id + 1]!]);
  }
}

/** By the edges, each of which knows the triangles on both of its sides. */
function twinsOf(native: AnyNative, triangles: Uint32Array): Int32Array {
  const { sites, vertices } = native.edges();
  const twins = new Int32Array(triangles.length).fill(-1);
  // The sites of a triangle are three different ones, so that one half-edge of it starts there.
  const halfedge = (triangle: number, start: number) =>
    triangle < 0 ? -1 : triangles.indexOf(start, 3 * triangle);
  for (let k = 0; k < sites.length; k += 2) {
    const there = halfedge(vertices[k + 1]!, sites[k]!);
    const back = halfedge(vertices[k]!, sites[k + 1]!);
    if (there >= 0) twins[there] = back;
    if (back >= 0) twins[back] = there;
  }
  return twins;
}

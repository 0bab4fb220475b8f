// While the cells are those of the centres: the diagram of the circles themselves, which says where
// the nearest centre is not the nearest circle's.
import { Diagram } from "apollonius-diagram";

export class Truth {
  readonly diagram: Diagram;
  readonly #rows: Map<number, number>;

  /** @param xyr of these circles, in this order */
  constructor(
    readonly ids: ArrayLike<number>,
    xyr: Float64Array,
  ) {
    this.diagram = new Diagram(xyr);
    this.#rows = new Map(Array.from(ids, (id, row) => [id, row]));
  }

  /** The id of the nearest circle, or -1. */
  find(x: number, y: number) {
    const row = this.diagram.find(x, y);
    return row < 0 ? -1 : this.ids[row];
  }

  /** The ids of the circles at most this far away, nearest first. */
  within(x: number, y: number, distance: number) {
    return Array.from(this.diagram.within(x, y, distance), (row) => this.ids[row]);
  }

  update(ids: ArrayLike<number>, xyr: Float64Array) {
    const rows = Array.from(ids, (id) => this.#rows.get(id) ?? -1);
    this.diagram.updateMany(rows, xyr);
  }
}

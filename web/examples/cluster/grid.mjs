// A grid of buckets over a rectangle. Its lines are the same numbers for all who ask, and what is
// in a bucket is between its lines, whatever divisions round to.

class Axis {
  constructor(low, high, count) {
    Object.assign(this, { low, high, count });
  }

  line(k) {
    return k >= this.count ? this.high : this.low + (k / this.count) * (this.high - this.low);
  }

  /** The bucket of a value; the first or the last one for values outside. */
  bucket(value) {
    const guess = Math.floor(((value - this.low) / (this.high - this.low)) * this.count) || 0;
    let k = Math.min(this.count - 1, Math.max(0, guess));
    while (k > 0 && value < this.line(k)) --k;
    while (k < this.count - 1 && value >= this.line(k + 1)) ++k;
    return k;
  }
}

export class Grid {
  constructor({ bounds: [xmin, ymin, xmax, ymax], columns, rows }) {
    this.x = new Axis(xmin, xmax, columns);
    this.y = new Axis(ymin, ymax, rows);
  }

  /** About this many buckets, about as wide as high. */
  static of(bounds, buckets) {
    const [xmin, ymin, xmax, ymax] = bounds;
    const columns = Math.sqrt((buckets * (xmax - xmin)) / (ymax - ymin)) || 1;
    const within = (count) => Math.round(Math.min(buckets, Math.max(1, count)));
    return { bounds, columns: within(columns), rows: within(buckets / columns) };
  }

  get size() {
    return this.x.count * this.y.count;
  }

  bucket(x, y) {
    return this.y.bucket(y) * this.x.count + this.x.bucket(x);
  }
}

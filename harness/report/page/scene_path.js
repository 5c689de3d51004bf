"use strict";

/** The polyline along S: figures and t as functions of the arc length. */
class ScenePath {
  /** `path`: {length, moving: [[point, axis]], fixed: figure's points, rows: [[t, s, moving…]], stops} */
  constructor(path) {
    this.length = path.length;
    this.rows = path.rows;
    this.moving = path.moving;
    this.fixed = path.fixed;
    this.stops = path.stops;
  }

  /** The row that begins the segment with arc length s. */
  rowAt(s) {
    let low = 0;
    let high = this.rows.length - 2;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.rows[middle][1] <= s) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** {t, s, points} */
  at(s) {
    const k = this.rowAt(s);
    const [a, b] = [this.rows[k], this.rows[k + 1]];
    const part = b[1] > a[1] ? Math.min(1, Math.max(0, (s - a[1]) / (b[1] - a[1]))) : 0;
    // Exact at both ends, so that a solution shows the coordinates that are listed.
    return this.placed(a.map((number, i) => (part === 1 ? b[i] : number + part * (b[i] - number))));
  }

  atRow(k) { return this.placed(this.rows[k]); }

  placed(row) {
    const points = this.fixed.map((point) => point.slice());
    this.moving.forEach(([point, axis], i) => { points[point][axis] = row[i + 2]; });
    return { t: row[0], s: row[1], points };
  }
}

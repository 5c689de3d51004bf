"use strict";

/** Vectors of three numbers, and rotations as arrays of three rows. */
const Geometry = {
  identity: () => [[1, 0, 0], [0, 1, 0], [0, 0, 1]],

  apply: (rotation, v) => rotation.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]),

  product: (a, b) => a.map((row) => [0, 1, 2].map((j) => row[0] * b[0][j] + row[1] * b[1][j] + row[2] * b[2][j])),

  transposed: (rotation) => [0, 1, 2].map((i) => rotation.map((row) => row[i])),

  /** About axis 0, 1 or 2 by an angle in radians. */
  about: (axis, angle) => Geometry.aboutVector(Geometry.identity()[axis], angle),

  /** About a vector of length 1 by an angle in radians (Rodrigues). */
  aboutVector(axis, angle) {
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const columns = Geometry.identity().map((unit) => Geometry.along(
      Geometry.along(unit.map((x) => cos * x), Geometry.cross(axis, unit), sin),
      axis, (1 - cos) * Geometry.dot(axis, unit)));
    return Geometry.transposed(columns);
  },

  /** The part of a rotation with the same axis and so much of its angle. */
  partOf(rotation, part) {
    const twiceSine = [[2, 1], [0, 2], [1, 0]].map(([i, j]) => rotation[i][j] - rotation[j][i]);
    const twiceCosine = rotation[0][0] + rotation[1][1] + rotation[2][2] - 1;
    const angle = Math.atan2(Math.hypot(...twiceSine), twiceCosine);
    return Geometry.aboutVector(Geometry.axisOf(rotation, twiceSine), part * angle);
  },

  /** `twiceSine`: twice the sine of the angle times the axis. Of half a turn the axis is read from R + Rᵀ = 2aaᵀ + …. */
  axisOf(rotation, twiceSine) {
    const size = Math.hypot(...twiceSine);
    if (size > 1e-6) return twiceSine.map((x) => x / size);
    const columns = [0, 1, 2].map((j) => [0, 1, 2].map((i) => rotation[i][j] + rotation[j][i] + (i === j ? 2 : 0)));
    const largest = columns.reduce((a, b) => (Math.hypot(...a) >= Math.hypot(...b) ? a : b));
    return Geometry.unit(largest);
  },

  /** The least rotation from one direction of length 1 to another. */
  between(from, to) {
    const axis = Geometry.cross(from, to);
    const [sine, cosine] = [Math.hypot(...axis), Geometry.dot(from, to)];
    return Geometry.aboutVector(sine > 1e-9 ? Geometry.unit(axis) : Geometry.normalTo(from), Math.atan2(sine, cosine));
  },

  /** Any vector of length 1 at a right angle. */
  normalTo(v) {
    const sizes = v.map(Math.abs);
    return Geometry.unit(Geometry.cross(v, Geometry.identity()[sizes.indexOf(Math.min(...sizes))]));
  },

  unit(v) {
    const size = Math.hypot(...v);
    return v.map((x) => x / size);
  },

  subtract: (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]],

  /** a + factor · b */
  along: (a, b, factor) => [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]],

  /** From a to b. */
  mixed: (a, b, part) => Geometry.along(a.map((x) => (1 - part) * x), b, part),

  dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],

  cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],

  distance: (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]),

  centre: (points) => [0, 1, 2].map((axis) => points.reduce((sum, p) => sum + p[axis], 0) / points.length),

  /** Of the point on a line (direction of length 1) that is nearest to p. */
  foot: (line, p) => Geometry.along(line.point, line.direction,
                                    Geometry.dot(Geometry.subtract(p, line.point), line.direction)),

  /** Of the point on a plane (normal of length 1) that is nearest to p. */
  footOnPlane: (plane, p) => Geometry.along(p, plane.normal, plane.offset - Geometry.dot(plane.normal, p)),

  /** The ends of the common perpendicular of two lines; of parallel lines, the one nearest to p. */
  perpendicular(a, b, p) {
    const normal = Geometry.cross(a.direction, b.direction);
    const square = Geometry.dot(normal, normal);
    if (square < 1e-18) return [Geometry.foot(a, p), Geometry.foot(b, Geometry.foot(a, p))];
    const apart = Geometry.subtract(b.point, a.point);
    const end = (line, other) => Geometry.along(
      line.point, line.direction, Geometry.dot(Geometry.cross(apart, other.direction), normal) / square);
    return [end(a, b), end(b, a)];
  },

  /** The corners of the convex hull of points [x, y, …] of a drawing, in order (Andrew). */
  hull(points) {
    const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
    const half = (ordered) => {
      const chain = [];
      for (const p of ordered) {
        while (chain.length > 1 && Geometry.turn(chain[chain.length - 2], chain[chain.length - 1], p) <= 0) chain.pop();
        chain.push(p);
      }
      return chain.slice(0, -1);
    };
    return half(sorted).concat(half(sorted.reverse()));
  },

  /** Positive where a → b → c turns to the left. */
  turn: (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]),
};

"use strict";

/** Vectors of three numbers, and rotations as arrays of three rows. */
const Geometry = {
  identity: () => [[1, 0, 0], [0, 1, 0], [0, 0, 1]],

  apply: (rotation, v) => rotation.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]),

  product: (a, b) => a.map((row) => [0, 1, 2].map((j) => row[0] * b[0][j] + row[1] * b[1][j] + row[2] * b[2][j])),

  /** About axis 0, 1 or 2 by an angle in radians. */
  about(axis, angle) {
    const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
    const rotation = Geometry.identity();
    rotation[i][i] = rotation[j][j] = Math.cos(angle);
    rotation[j][i] = Math.sin(angle);
    rotation[i][j] = -Math.sin(angle);
    return rotation;
  },

  subtract: (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]],

  /** a + factor · b */
  along: (a, b, factor) => [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]],

  dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],

  distance: (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]),

  /** Of the point on a line (direction of length 1) that is nearest to p. */
  foot: (line, p) => Geometry.along(line.point, line.direction,
                                    Geometry.dot(Geometry.subtract(p, line.point), line.direction)),
};

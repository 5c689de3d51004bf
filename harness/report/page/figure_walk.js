"use strict";

/** From one solution to another, or along a curve of figures. From solution to solution bodies move rigidly, other points on segments, lines by foot and direction, planes by
    normal and offset. What is in between is no solution. */
const FigureWalk = {
  /** The figure {points, lines, planes} at `part`, from 0 to 1, of the way from solution `a` to `b`. */
  at(scene, a, b, part) {
    if (part <= 0) return a;
    if (part >= 1) return b;
    const figure = {
      points: a.points.map((point, i) => Geometry.mixed(point, b.points[i], part)),
      lines: a.lines.map((line, i) => FigureWalk.line(line, b.lines[i], part)),
      planes: a.planes.map((plane, i) => FigureWalk.plane(plane, b.planes[i], part)),
    };
    // An element that two bodies share stays with the first.
    for (let k = scene.bodies.length - 1; k >= 0; --k) FigureWalk.moveBody(scene, k, a, b, part, figure);
    return figure;
  },

  /** On a polyline of figures, `part` from 0 to 1 of its segments. */
  along(figures, part) {
    const place = part * (figures.length - 1);
    const k = Math.min(Math.floor(place), figures.length - 2);
    return FigureWalk.at({ bodies: [] }, figures[k], figures[k + 1], place - k);
  },

  /** The direction of a line may be turned over. */
  line(a, b, part) {
    const sign = Geometry.dot(a.direction, b.direction) < 0 ? -1 : 1;
    return {
      point: Geometry.mixed(a.point, b.point, part),
      direction: FigureWalk.direction(a.direction, b.direction.map((x) => sign * x), part),
    };
  },

  plane(a, b, part) {
    return { normal: FigureWalk.direction(a.normal, b.normal, part), offset: (1 - part) * a.offset + part * b.offset };
  },

  direction: (a, b, part) => Geometry.apply(Geometry.partOf(Geometry.between(a, b), part), a),

  /** By the part of the rotation between both poses, about the mean of its points, which moves on a segment. */
  moveBody(scene, k, a, b, part, figure) {
    const points = scene.points.length, lines = scene.lines.length;
    const { elements } = scene.bodies[k];
    const own = elements.filter((e) => e < points);
    const from = Geometry.centre(own.map((e) => a.points[e]));
    const to = Geometry.mixed(from, Geometry.centre(own.map((e) => b.points[e])), part);
    const turn = Geometry.partOf(Geometry.product(b.turns[k], Geometry.transposed(a.turns[k])), part);
    const moved = (p) => Geometry.along(to, Geometry.apply(turn, Geometry.subtract(p, from)), 1);
    for (const e of elements) {
      if (e < points) {
        figure.points[e] = moved(a.points[e]);
      } else if (e < points + lines) {
        const line = a.lines[e - points];
        figure.lines[e - points] = { point: moved(line.point), direction: Geometry.apply(turn, line.direction) };
      } else {
        const plane = a.planes[e - points - lines];
        const normal = Geometry.apply(turn, plane.normal);
        const offset = Geometry.dot(normal, moved(plane.normal.map((x) => x * plane.offset)));
        figure.planes[e - points - lines] = { normal, offset };
      }
    }
  },
};

"use strict";

/** A figure seen in perspective as SVG; dragging and the arrow keys turn it. */
class FigureView {
  /** `scene`: points, lines, edges, dimension. `radius`: of the least ball that is shown; a larger figure is shown
      whole. */
  constructor(svg, scene, radius) {
    this.svg = svg;
    this.scene = scene;
    this.least = radius;
    this.rotation = scene.dimension === 2
      ? Geometry.identity()
      : Geometry.product(Geometry.about(0, -1.2), Geometry.about(2, -0.5));
    this.removed = new Set();
    this.onturn = () => {};
  }

  static size = 320;

  static centre(points) { return [0, 1, 2].map((axis) => points.reduce((sum, p) => sum + p[axis], 0) / points.length); }

  /** The distance of the furthest point from the centre. */
  static reach(points) {
    const centre = FigureView.centre(points);
    return Math.max(...points.map((p) => Geometry.distance(p, centre)), Number.MIN_VALUE);
  }

  /** Shows figure {points, lines}; `removed`: labels of the constraints that the present plan leaves out. */
  show(figure, removed = new Set()) {
    this.figure = figure;
    this.removed = removed;
    this.centre = FigureView.centre(figure.points);
    this.radius = Math.max(this.least, FigureView.reach(figure.points));
    this.draw();
  }

  turn(dx, dy) {
    const angle = 0.01;
    const turned = this.scene.dimension === 2
      ? Geometry.about(2, angle * dx)
      : Geometry.product(Geometry.about(0, angle * dy), Geometry.about(1, angle * dx));
    this.rotation = Geometry.product(turned, this.rotation);
    this.draw();
    this.onturn(this.rotation);
  }

  makeTurnable() {
    let last = null;
    this.svg.addEventListener("pointerdown", (event) => {
      last = event;
      this.svg.setPointerCapture(event.pointerId);
    });
    this.svg.addEventListener("pointermove", (event) => {
      if (last === null) return;
      this.turn(event.clientX - last.clientX, event.clientY - last.clientY);
      last = event;
    });
    for (const end of ["pointerup", "pointercancel"]) this.svg.addEventListener(end, () => { last = null; });
    const steps = { ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, -10], ArrowDown: [0, 10] };
    this.svg.addEventListener("keydown", (event) => {
      if (!(event.key in steps)) return;
      this.turn(...steps[event.key]);
      event.preventDefault();
    });
  }

  /** [x, y, depth] on the drawing; depth from −1, far, to 1, near. */
  project(point) {
    const [x, y, z] = Geometry.apply(this.rotation, Geometry.subtract(point, this.centre)).map((v) => v / this.radius);
    const eye = 5;
    const scale = this.scene.dimension === 2 ? 1 : eye / Math.max(1, eye - z);
    const half = FigureView.size / 2;
    return [half + 0.86 * half * scale * x, half - 0.86 * half * scale * y, z];
  }

  /** Both ends of a constraint in space. */
  ends(edge) {
    const { points, lines } = this.figure;
    const a = points[edge.a];
    if (edge.b < points.length) return [a, points[edge.b]];
    return [a, Geometry.foot(lines[edge.b - points.length], a)];
  }

  /** What is drawn, each with its depth: {depth, draw(group)}. */
  parts() {
    const parts = [];
    for (const edge of this.scene.edges) {
      const [p, q] = this.ends(edge).map((end) => this.project(end));
      const kind = this.removed.has(edge.label) ? "edge removed" : "edge";
      parts.push(this.segment(p, q, kind, edge));
    }
    (this.figure.lines || []).forEach((line, i) => {
      const middle = Geometry.foot(line, this.centre);
      const [p, q, named] = [-2, 2, 0.9].map(
        (k) => this.project(Geometry.along(middle, line.direction, k * this.radius)));
      parts.push(this.segment(p, q, "line", { label: this.scene.lines[i] }));
      parts.push(this.label(named, this.scene.lines[i]));
    });
    this.figure.points.forEach((point, i) => {
      const place = this.project(point);
      parts.push({
        depth: place[2] + 1e-3,
        draw: (group) => Drawing.element("circle", {
          class: "point", cx: place[0].toFixed(2), cy: place[1].toFixed(2), r: (3.2 + 0.8 * place[2]).toFixed(2),
        }, group),
      });
      parts.push(this.label(place, this.scene.points[i]));
    });
    return parts.sort((a, b) => a.depth - b.depth);
  }

  segment(p, q, kind, edge) {
    const depth = (p[2] + q[2]) / 2;
    const opacity = this.scene.dimension === 2 ? 1 : 0.62 + 0.38 * Math.max(-1, Math.min(1, depth));
    return {
      depth,
      draw: (group) => {
        const line = Drawing.element("line", {
          class: kind, x1: p[0].toFixed(2), y1: p[1].toFixed(2), x2: q[0].toFixed(2), y2: q[1].toFixed(2),
          "stroke-opacity": opacity.toFixed(2),
        }, group);
        Drawing.element("title", {}, line, edge.length ? `${edge.label} = ${edge.length}` : edge.label);
      },
    };
  }

  label(place, text) {
    return {
      depth: place[2] + 2,
      draw: (group) => Drawing.element("text", {
        class: "label", x: (place[0] + 6).toFixed(1), y: (place[1] - 5).toFixed(1),
      }, group, text),
    };
  }

  draw() {
    const group = Drawing.element("g", {});
    for (const part of this.parts()) part.draw(group);
    this.svg.replaceChildren(group);
  }
}

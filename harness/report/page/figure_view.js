"use strict";

/** A figure seen in perspective as SVG; dragging and the arrow keys turn it. */
class FigureView {
  /** `scene`: points, lines, planes, bodies, edges, dimension. `radius`: of the least ball that is shown; a larger figure
      is shown whole. */
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
  static eye = 5;      // distance from the centre, in radii
  static colours = 6;  // of bodies, in page.css
  static mostJoined = 8;

  /** The distance from the centre of what is furthest: a point, an end of a distance, or the foot of the centre on a line
      or a plane. */
  static reach(scene, figure) {
    const centre = Geometry.centre(figure.points);
    const feet = figure.lines.map((line) => Geometry.foot(line, centre))
      .concat(figure.planes.map((plane) => Geometry.footOnPlane(plane, centre)));
    const ends = scene.edges.flatMap((edge) => FigureView.ends(figure, edge, centre));
    return Math.max(...figure.points.concat(feet, ends).map((p) => Geometry.distance(p, centre)), Number.MIN_VALUE);
  }

  /** Both ends of a distance in space. Entities are points, then lines, then planes; a comes first. */
  static ends({ points, lines, planes }, { a, b }, centre) {
    const [p, q] = [points.length, points.length + lines.length];
    const footOn = (entity, from) => (entity < p ? points[entity]
      : entity < q ? Geometry.foot(lines[entity - p], from) : Geometry.footOnPlane(planes[entity - q], from));
    if (a >= p && b < q) return Geometry.perpendicular(lines[a - p], lines[b - p], centre);
    const end = footOn(a, centre);
    return [end, footOn(b, end)];
  }

  /** The class of an element that belongs to one body alone, for its colour. */
  static bodyClass(scene, entity) {
    const owners = scene.bodies.flatMap(({ elements }, k) => (elements.includes(entity) ? [k] : []));
    return owners.length === 1 ? FigureView.colourClass(owners[0]) : "";
  }

  static colourClass(body) { return ` body-${body % FigureView.colours}`; }

  /** Shows figure {points, lines, planes}; `removed`: labels of the constraints that the present plan leaves out. */
  show(figure, removed = new Set()) {
    this.figure = figure;
    this.removed = removed;
    this.centre = Geometry.centre(figure.points);
    this.radius = Math.max(this.least, FigureView.reach(this.scene, figure));
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

  /** As the eye sees it, in radii from the centre. */
  seen(point) {
    return Geometry.apply(this.rotation, Geometry.subtract(point, this.centre)).map((v) => v / this.radius);
  }

  /** [x, y, depth] on the drawing; depth from −1, far, to 1, near. */
  project(point) {
    const [x, y, z] = this.seen(point);
    const scale = this.scene.dimension === 2 ? 1 : FigureView.eye / Math.max(1, FigureView.eye - z);
    const half = FigureView.size / 2;
    return [half + 0.86 * half * scale * x, half - 0.86 * half * scale * y, z];
  }

  /** Half of what of a line or a plane with that foot lies in the ball that is shown, but some of it always. */
  halfChord(foot) {
    const distance = Geometry.distance(foot, this.centre) / this.radius;
    return this.radius * Math.sqrt(Math.max(0.15, 1 - distance * distance));
  }

  /** What is drawn, each with its depth: {depth, draw(group)}. */
  parts() {
    const parts = [];
    this.scene.bodies.forEach((body, k) => parts.push(...this.bodyParts(body, k)));
    for (const edge of this.scene.edges) {
      const [p, q] = FigureView.ends(this.figure, edge, this.centre).map((end) => this.project(end));
      const kind = this.removed.has(edge.label) ? "edge removed" : "edge";
      parts.push(this.segment(p, q, kind, edge.length ? `${edge.label} = ${edge.length}` : edge.label));
    }
    this.figure.planes.forEach((plane, i) => parts.push(...this.planeParts(plane, i)));
    this.figure.lines.forEach((line, i) => parts.push(...this.lineParts(line, i)));
    this.figure.points.forEach((point, i) => parts.push(...this.pointParts(point, i)));
    return parts.sort((a, b) => a.depth - b.depth);
  }

  pointParts(point, i) {
    const place = this.project(point);
    const own = FigureView.bodyClass(this.scene, i);
    return [this.label(place, this.scene.points[i]), {
      depth: place[2] + 1e-3,
      draw: (group) => Drawing.element("circle", {
        class: `point${own}`, cx: place[0].toFixed(2), cy: place[1].toFixed(2), r: (3.2 + 0.8 * place[2]).toFixed(2),
      }, group),
    }];
  }

  /** As far as is seen: away from the eye that is further. Names are at either end in turn. */
  lineParts(line, i) {
    const foot = Geometry.foot(line, this.centre);
    const at = (k) => this.project(Geometry.along(foot, line.direction, k * this.radius));
    const towardsEye = Geometry.apply(this.rotation, line.direction)[2];
    const [p, q] = [-2, 2].map((k) => at(k * towardsEye < 0 ? 4 * k : k));
    const named = at((i % 2 === 0 ? 0.9 : -0.9) * this.halfChord(foot) / this.radius);
    const own = FigureView.bodyClass(this.scene, this.scene.points.length + i);
    return [this.segment(p, q, `line${own}`, this.scene.lines[i], at(0)[2]), this.label(named, this.scene.lines[i])];
  }

  /** The disc in which the plane meets the ball that is shown, and an arrow to the side of its normal. */
  planeParts(plane, i) {
    const name = this.scene.planes[i];
    const foot = Geometry.footOnPlane(plane, this.centre);
    const across = Geometry.normalTo(plane.normal).map((x) => x * this.halfChord(foot));
    const corners = Array.from({ length: 48 }, (_, k) => this.project(Geometry.along(
      foot, Geometry.apply(Geometry.aboutVector(plane.normal, k * Math.PI / 24), across), 1)));
    const [towardsEye, centre] = [Geometry.apply(this.rotation, plane.normal), this.seen(foot)];
    const isFront = Geometry.dot(towardsEye, Geometry.subtract([0, 0, FigureView.eye], centre)) > 0;
    const own = FigureView.bodyClass(this.scene, this.scene.points.length + this.scene.lines.length + i);
    const start = this.project(foot), tip = this.project(Geometry.along(foot, plane.normal, 0.3 * this.radius));
    return [
      this.polygon(corners, start[2], `plane ${isFront ? "front" : "back"}${own}`, name),
      this.segment(start, tip, `normal${own}`, `normal of ${name}`),
      this.arrowHead(start, tip, `normal-head${own}`),
      this.label(tip, name),
    ];
  }

  arrowHead(start, tip, kind) {
    const [dx, dy] = [tip[0] - start[0], tip[1] - start[1]];
    const length = Math.hypot(dx, dy);
    const [x, y] = length > 0 ? [dx / length, dy / length] : [0, 0];
    const size = Math.min(9, length);  // an arrow towards the eye has hardly any
    const corner = (side) => [tip[0] - size * x - side * 0.45 * size * y, tip[1] - size * y + side * 0.45 * size * x];
    return this.polygon([tip, corner(1), corner(-1)], tip[2], kind, "");
  }

  /** Its outline as it is seen, and its points joined. */
  bodyParts({ name, elements }, k) {
    const colour = FigureView.colourClass(k);
    const places = elements.filter((e) => e < this.figure.points.length).map((e) => this.project(this.figure.points[e]));
    const depth = places.reduce((sum, place) => sum + place[2], 0) / places.length;
    const corners = Geometry.hull(places);
    const parts = [this.polygon(corners, depth - 1e-3, `body${colour}`, name)];
    const ordered = places.length <= FigureView.mostJoined ? places : corners;
    ordered.forEach((p, i) => {
      const others = ordered === places ? places.slice(i + 1) : [corners[(i + 1) % corners.length]];
      for (const q of others) parts.push(this.segment(p, q, `joined${colour}`, name));
    });
    return parts;
  }

  polygon(corners, depth, kind, title) {
    return {
      depth,
      draw: (group) => {
        const points = corners.map((corner) => `${corner[0].toFixed(2)},${corner[1].toFixed(2)}`).join(" ");
        const polygon = Drawing.element("polygon", { class: kind, points }, group);
        if (title) Drawing.element("title", {}, polygon, title);
      },
    };
  }

  segment(p, q, kind, title, depth = (p[2] + q[2]) / 2) {
    const opacity = this.scene.dimension === 2 ? 1 : 0.62 + 0.38 * Math.max(-1, Math.min(1, depth));
    return {
      depth,
      draw: (group) => {
        const line = Drawing.element("line", {
          class: kind, x1: p[0].toFixed(2), y1: p[1].toFixed(2), x2: q[0].toFixed(2), y2: q[1].toFixed(2),
          "stroke-opacity": opacity.toFixed(2),
        }, group);
        Drawing.element("title", {}, line, title);
      },
    };
  }

  /** To the right of its place, or to the left where there is no room. */
  label(place, text) {
    const letter = 7, aside = 6;
    const isLeft = place[0] + aside + letter * text.length > FigureView.size;
    return {
      depth: place[2] + 2,
      draw: (group) => Drawing.element("text", {
        class: "label", x: (place[0] + (isLeft ? -aside : aside)).toFixed(1), y: (place[1] - 5).toFixed(1),
        "text-anchor": isLeft ? "end" : "start",
      }, group, text),
    };
  }

  draw() {
    const group = Drawing.element("g", {});
    for (const part of this.parts()) part.draw(group);
    this.svg.replaceChildren(group);
  }
}

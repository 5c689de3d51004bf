"use strict";

/** t over a coordinate along S, as SVG; a click moves to the nearest place of S. */
class PathPlot {
  /** `coordinate`: {label, value(points, s)}; `unit`: of lengths, in words. */
  constructor(svg, path) {
    this.svg = svg;
    this.path = path;
    this.places = path.rows.map((_, k) => path.atRow(k));
    this.onpick = () => {};
    svg.addEventListener("click", (event) => this.pick(event));
  }

  static width = 520;
  static height = 320;
  static margin = { left: 46, right: 14, top: 14, bottom: 42 };

  /** Draws S over another coordinate, with the places of the trail. */
  show(coordinate, trail) {
    this.coordinate = coordinate;
    this.values = this.places.map((place) => coordinate.value(place.points, place.s));
    this.horizontal = PathPlot.range(this.values);
    this.vertical = PathPlot.range(this.places.map((place) => place.t).concat([0, 1]));
    this.svg.replaceChildren();
    this.drawAxes();
    this.drawPath();
    this.drawMarks(trail);
    this.here = Drawing.element("circle", { class: "here", r: 5 }, this.svg);
  }

  static range(values) {
    let [low, high] = [Infinity, -Infinity];
    for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
    const room = 0.04 * (high - low) || 1;
    return [low - room, high + room];
  }

  x(value) {
    const { left, right } = PathPlot.margin;
    return left + (value - this.horizontal[0]) / (this.horizontal[1] - this.horizontal[0])
      * (PathPlot.width - left - right);
  }

  y(t) {
    const { top, bottom } = PathPlot.margin;
    return PathPlot.height - bottom - (t - this.vertical[0]) / (this.vertical[1] - this.vertical[0])
      * (PathPlot.height - top - bottom);
  }

  moveTo(place) {
    this.here.setAttribute("cx", this.x(this.coordinate.value(place.points, place.s)).toFixed(2));
    this.here.setAttribute("cy", this.y(place.t).toFixed(2));
  }

  drawAxes() {
    const { left, right, top, bottom } = PathPlot.margin;
    const [width, height] = [PathPlot.width - left - right, PathPlot.height - top - bottom];
    Drawing.element("rect", { class: "frame", x: left, y: top, width, height }, this.svg);
    for (const tick of Drawing.ticks(...this.horizontal, 6)) {
      const x = this.x(tick).toFixed(1);
      Drawing.element("line", { class: "tick", x1: x, x2: x, y1: top + height, y2: top + height + 4 }, this.svg);
      Drawing.element("text", { class: "tick-text", x, y: top + height + 16, "text-anchor": "middle" }, this.svg,
                      Drawing.number(tick, 6));
    }
    for (const tick of Drawing.ticks(...this.vertical, 6)) {
      const y = this.y(tick);
      Drawing.element("line", { class: "tick", x1: left - 4, x2: left, y1: y, y2: y }, this.svg);
      Drawing.element("text", { class: "tick-text", x: left - 7, y: y + 4, "text-anchor": "end" }, this.svg,
                      Drawing.number(tick, 6));
    }
    for (const t of [0, 1])
      Drawing.element("line", { class: "level", x1: left, x2: left + width, y1: this.y(t), y2: this.y(t) }, this.svg);
    Drawing.element("text", { class: "axis", x: left + width / 2, y: PathPlot.height - 6, "text-anchor": "middle" },
                    this.svg, `${this.coordinate.label} (unit of the lengths)`);
    Drawing.element("text", {
      class: "axis", x: 12, y: top + height / 2, "text-anchor": "middle",
      transform: `rotate(-90 12 ${top + height / 2})`,
    }, this.svg, "t");
  }

  drawPath() {
    const corners = this.places.map((place, k) => `${this.x(this.values[k]).toFixed(2)} ${this.y(place.t).toFixed(2)}`);
    const isDense = corners.length > 5000;
    Drawing.element("path", { class: isDense ? "curve dense" : "curve", d: `M${corners.join("L")}` }, this.svg);
  }

  /** Marks of many changes are small, so that the path can be seen. */
  drawMarks(trail) {
    const changes = trail ? trail.places.slice(1) : [];
    const r = changes.length > 100 ? 1.5 : 4;
    for (const place of changes) {
      const there = this.path.at(place.s);
      const [x, y] = [this.x(this.coordinate.value(there.points, there.s)), this.y(there.t)];
      const mark = Drawing.element("path", { class: "change", d: `M${x} ${y - r}l${r} ${r}l${-r} ${r}l${-r} ${-r}z` },
                                   this.svg);
      const words = `plan changed at t = ${Drawing.number(place.t, 4)}`;
      Drawing.element("title", {}, mark, `${words}; left out from here: ${place.removed.join(", ")}`);
    }
    Drawing.element("rect", {
      class: "sketch", x: this.x(this.values[0]) - 4, y: this.y(this.places[0].t) - 4, width: 8, height: 8,
    }, this.svg);
    this.path.stops.forEach((stop, i) => {
      const mark = Drawing.element("circle", {
        class: "solution", cx: this.x(this.values[stop.row]), cy: this.y(this.places[stop.row].t),
        r: this.path.stops.length > 50 ? 3 : 4.5,
      }, this.svg);
      const name = stop.solution === null ? "" : `, solution ${stop.solution + 1}`;
      Drawing.element("title", {}, mark, `crossing ${i + 1} of t = 1${name}`);
    });
  }

  /** The arc length of the corner nearest to the click. */
  pick(event) {
    const box = this.svg.getBoundingClientRect();
    const [px, py] = [(event.clientX - box.left) * PathPlot.width / box.width,
                      (event.clientY - box.top) * PathPlot.height / box.height];
    let [best, nearest] = [0, Infinity];
    this.places.forEach((place, k) => {
      const distance = Math.hypot(this.x(this.values[k]) - px, this.y(place.t) - py);
      if (distance < nearest) [best, nearest] = [k, distance];
    });
    this.onpick(this.places[best].s);
  }
}

"use strict";

/** The interactive part of one instance: figure, slider along S, plot of S, solutions, coordinates. */
class ScenePanel {
  static mostThumbnails = 24;

  constructor(root, scene) {
    this.root = root;
    this.scene = scene;
    this.path = scene.path ? new ScenePath(scene.path) : null;
    this.trail = scene.trails.find((trail) => trail.places.length > 0) || null;
    this.find = (name) => root.querySelector(`[data-part="${name}"]`);
    this.view = new FigureView(this.find("view"), scene, this.radius());
    this.view.makeTurnable();
    this.views = this.makeThumbnails();
    this.view.onturn = (rotation) => this.views.forEach((view) => {
      view.rotation = rotation;
      view.draw();
    });
    this.fillGoals();
    if (this.path) this.makePlot();
    else this.find("along").hidden = true;
    this.find("goal").addEventListener("change", () => this.choose());
    this.find("slider").addEventListener("input", () => this.move());
    this.find("play").addEventListener("click", () => this.play());
    this.choose();
  }

  /** Of balls around the solutions; the sketch stands in for them. */
  radius() {
    const figures = this.scene.solutions.map((solution) => solution.points);
    if (figures.length === 0 && this.path) figures.push(this.path.atRow(0).points);
    return Math.max(...figures.map((points) => FigureView.reach(points)));
  }

  /** What can be shown: once around S, from the sketch to each crossing, and the solutions that are not on S. */
  fillGoals() {
    this.goals = [];
    const met = new Set();
    if (this.path) {
      const last = this.path.rows.length - 1;
      this.path.stops.forEach((stop, i) => {
        const image = stop.signs.includes(-1) ? ", mirrored" : "";
        const name = stop.solution === null ? "" : `: solution ${stop.solution + 1}${image}`;
        this.goals.push({ group: "from the sketch along S to", text: `crossing ${i + 1}${name}`,
                          row: stop.row, solution: stop.solution });
        met.add(stop.solution);
      });
      this.goals.push({ group: "all of S", text: "once around, back to the sketch", row: last, solution: null });
    }
    this.scene.solutions.forEach((_, i) => {
      if (!met.has(i))
        this.goals.push({ group: this.path ? "solutions that are not on S" : "solutions",
                          text: `solution ${i + 1}`, row: null, solution: i });
    });
    const groups = new Map();
    this.goals.forEach((goal, i) => {
      if (!groups.has(goal.group)) groups.set(goal.group, new OptionGroup(goal.group));
      groups.get(goal.group).add(goal.text, i);
    });
    this.find("goal").replaceChildren(...[...groups.values()].map((group) => group.element));
    if (this.goals.length === 0) this.find("controls").hidden = true;
  }

  get goal() { return this.goals[Number(this.find("goal").value)]; }

  choose() {
    this.stop();
    if (this.goals.length === 0) return;
    const moves = this.goal.row !== null;
    this.find("slider").disabled = this.find("play").disabled = !moves;
    this.find("slider").value = this.find("slider").max;
    this.move();
  }

  /** Shows the place of the slider, or the solution where there is no way to it. */
  move() {
    const { row, solution } = this.goal;
    const slider = this.find("slider");
    if (row === null) {
      this.display(this.scene.solutions[solution], null);
      slider.setAttribute("aria-valuetext", "not on S");
      this.find("where").textContent = this.path ? "This solution is not on S." : "";
      return;
    }
    const end = this.path.rows[row][1];
    const place = Number(slider.value) === Number(slider.max)
      ? this.path.atRow(row) : this.path.at(end * Number(slider.value) / Number(slider.max));
    this.display({ points: place.points, lines: [] }, place);
    const words = `t = ${Drawing.number(place.t, 4)}, arc length ${Drawing.number(place.s, 4)} of `
      + Drawing.number(end, 4);
    slider.setAttribute("aria-valuetext", words);
    this.find("where").textContent = words + this.planWords(place.s);
  }

  planAt(s) {
    if (!this.trail) return null;
    return this.trail.places.reduce((plan, place) => (place.s <= s ? place : plan), this.trail.places[0]);
  }

  planWords(s) {
    const plan = this.planAt(s);
    if (!plan) return "";
    return plan.removed.length > 0 ? `; the plan leaves out ${plan.removed.join(", ")} (dashed)`
                                   : "; the plan leaves out nothing";
  }

  display(figure, place) {
    const plan = place ? this.planAt(place.s) : null;
    this.view.show(figure, new Set(plan ? plan.removed : []));
    if (place) this.plot.moveTo(place);
    else if (this.plot) this.plot.here.removeAttribute("cx");
    this.fillCoordinates(figure);
    this.views.forEach((view, i) => view.svg.parentElement.setAttribute("aria-pressed", i === this.goal.solution));
  }

  /** The coordinates of what is shown, beside those of the solution as it is listed. */
  fillCoordinates(figure) {
    const axes = this.scene.dimension === 2 ? [0, 1] : [0, 1, 2];
    const { solution } = this.goal;
    const size = this.radius();
    const numbers = (v) => axes.map((axis) => Drawing.coordinate(v[axis], size));
    const listed = solution === null ? null : this.listedImage(solution);
    const rows = this.scene.points.map((name, i) => [name, numbers(figure.points[i]), listed && numbers(listed[i])]);
    (figure.lines || []).forEach((line, i) => {
      const name = this.scene.lines[i];
      rows.push([`${name}, a point`, numbers(line.point), null]);
      rows.push([`${name}, direction`, numbers(line.direction), null]);
    });
    this.find("coordinates").replaceChildren(...rows.map(([name, now, then]) => {
      const row = document.createElement("tr");
      const heading = document.createElement("th");
      heading.scope = "row";
      heading.textContent = name;
      row.append(heading, ...now.concat(then || axes.map(() => "–")).map((text) => {
        const cell = document.createElement("td");
        cell.textContent = text;
        return cell;
      }));
      return row;
    }));
  }

  /** The listed solution, as the mirror image in which the path meets it. */
  listedImage(solution) {
    const stop = this.path && this.goal.row !== null ? this.path.stops.find((s) => s.row === this.goal.row) : null;
    const signs = stop ? stop.signs : [1, 1, 1];
    return this.scene.solutions[solution].points.map((p) => p.map((x, axis) => signs[axis] * x));
  }

  makeThumbnails() {
    const gallery = this.find("gallery");
    const shown = this.scene.solutions.slice(0, ScenePanel.mostThumbnails);
    const views = shown.map((solution, i) => {
      const button = document.createElement("button");
      button.type = "button";
      const multiplicity = solution.multiplicity > 1 ? `, ${solution.multiplicity}-fold` : "";
      button.setAttribute("aria-label", `show solution ${i + 1}${multiplicity}`);
      const svg = Drawing.element("svg", { viewBox: `0 0 ${FigureView.size} ${FigureView.size}`, "aria-hidden": true });
      const caption = document.createElement("span");
      caption.textContent = `${i + 1}${multiplicity}`;
      button.append(svg, caption);
      button.addEventListener("click", () => this.goTo(i));
      gallery.append(button);
      const view = new FigureView(svg, this.scene, this.radius());
      view.show(solution);
      return view;
    });
    const more = this.scene.solutions.length - shown.length;
    if (more > 0) this.find("more").textContent = `The other ${more} are in the list above.`;
    return views;
  }

  goTo(solution) {
    this.find("goal").value = this.goals.findIndex((goal) => goal.solution === solution);
    this.choose();
  }

  makePlot() {
    this.plot = new PathPlot(this.find("plot"), this.path);
    this.plot.onpick = (s) => this.goToLength(s);
    this.coordinates = this.allCoordinates();
    const groups = new Map();
    this.coordinates.forEach((coordinate, i) => {
      if (!groups.has(coordinate.group)) groups.set(coordinate.group, new OptionGroup(coordinate.group));
      groups.get(coordinate.group).add(coordinate.label, i);
    });
    this.find("coordinate").replaceChildren(...[...groups.values()].map((group) => group.element));
    this.find("coordinate").value = this.scene.coordinate;
    const none = [new Option("none", "")];
    const trails = this.scene.trails.map((trail, i) => {
      const option = new Option(trail.cause ? `${trail.label}: ${trail.cause}` : trail.label, i);
      option.disabled = trail.places.length === 0;
      return option;
    });
    this.find("trail").replaceChildren(...none, ...trails);
    this.find("trail").value = this.trail ? this.scene.trails.indexOf(this.trail) : "";
    this.find("coordinate").addEventListener("change", () => this.redrawPlot());
    this.find("trail").addEventListener("change", () => {
      this.trail = this.scene.trails[this.find("trail").value] || null;
      this.redrawPlot();
    });
    this.plot.show(this.coordinates[this.scene.coordinate], this.trail);
  }

  redrawPlot() {
    this.plot.show(this.coordinates[this.find("coordinate").value], this.trail);
    this.move();
  }

  /** Arc length, the coordinates that move (numbered as by `scene.coordinate`), and distances that are not given. */
  allCoordinates() {
    const { points, edges, dimension } = this.scene;
    const all = [{ group: "along S", label: "arc length", value: (_, s) => s }];
    for (const [point, axis] of this.path.moving)
      all.push({ group: "coordinates", label: `${"xyz"[axis]} of ${points[point]}`, value: (p) => p[point][axis] });
    const given = new Set(edges.map((edge) => `${Math.min(edge.a, edge.b)} ${Math.max(edge.a, edge.b)}`));
    for (let a = 0; a < points.length; ++a)
      for (let b = a + 1; b < points.length; ++b)
        if (!given.has(`${a} ${b}`))
          all.push({ group: "distances that are not given", label: `|${points[a]} ${points[b]}|`,
                     value: (p) => Math.hypot(...p[a].slice(0, dimension).map((x, axis) => x - p[b][axis])) });
    return all;
  }

  goToLength(s) {
    this.stop();
    if (this.goal.row === null || this.path.rows[this.goal.row][1] < s)
      this.find("goal").value = this.goals.findIndex((goal) => goal.row === this.path.rows.length - 1);
    const slider = this.find("slider");
    slider.disabled = this.find("play").disabled = false;
    slider.value = Number(slider.max) * s / this.path.rows[this.goal.row][1];
    this.move();
  }

  play() {
    if (this.timer) {
      this.stop();
      return;
    }
    const slider = this.find("slider");
    const max = Number(slider.max);
    const seconds = 6;
    let from = Number(slider.value) === max ? 0 : Number(slider.value);
    let start = null;
    const step = (now) => {
      start = start ?? now;
      slider.value = from + max * (now - start) / (1000 * seconds);
      this.move();
      if (Number(slider.value) < max) this.timer = requestAnimationFrame(step);
      else this.stop();
    };
    this.find("play").textContent = "Stop";
    this.timer = requestAnimationFrame(step);
  }

  stop() {
    cancelAnimationFrame(this.timer);
    this.timer = null;
    this.find("play").textContent = "Move along S";
  }
}

/** Options of a drop-down under one heading. */
class OptionGroup {
  constructor(label) {
    this.element = document.createElement("optgroup");
    this.element.label = label;
  }

  add(text, value) { this.element.append(new Option(text, value)); }
}

"use strict";

/** The interactive part of one instance: figure, slider along S or between solutions, plot of S, solutions, coordinates. */
class ScenePanel {
  static mostThumbnails = 24;
  static secondsOfPath = 6;
  static secondsOfWalk = 2;  // from one solution to the next

  constructor(root, scene) {
    this.root = root;
    this.scene = scene;
    this.path = scene.path ? new ScenePath(scene.path) : null;
    this.trail = scene.trails.find((trail) => trail.places.length > 0) || null;
    this.find = (name) => root.querySelector(`[data-part="${name}"]`);
    this.size = this.radius();
    this.view = new FigureView(this.find("view"), scene, this.size);
    this.view.makeTurnable();
    this.views = this.makeThumbnails();
    this.view.onturn = (rotation) => this.views.forEach((view) => {
      view.rotation = rotation;
      view.draw();
    });
    this.fillGoals();
    this.fillLegend();
    if (this.path) this.makePlot();
    this.makeGraph();
    this.find("along").hidden = !this.goals.some((goal) => ScenePanel.moves(goal));
    this.find("goal").addEventListener("change", () => this.choose());
    this.find("slider").addEventListener("input", () => this.move());
    this.find("play").addEventListener("click", () => this.play());
    this.choose();
  }

  /** Of balls around the solutions and motions; the sketch stands in for them. */
  radius() {
    const motions = this.scene.curves.filter((curve) => curve.constraint === "");
    const figures = this.scene.solutions.concat(motions.flatMap((motion) => motion.figures));
    if (figures.length === 0 && this.path) figures.push(ScenePanel.ofPoints(this.path.atRow(0).points));
    return Math.max(...figures.map((figure) => FigureView.reach(this.scene, figure)));
  }

  static ofPoints(points) { return { points, lines: [], planes: [] }; }

  /** Whether there is a way to the goal: along S or a curve, or from another solution. */
  static moves(goal) { return goal.row !== null || goal.curve !== undefined || goal.stops.length > 1; }

  /** What can be shown: once around S, from the sketch to each crossing, each solution that is not on S from the one before
      it, all of those one after another, motions, and edges of the graph. `stops`: the solutions on the way; `curve`: its
      number. */
  fillGoals() {
    this.goals = [];
    const met = new Set();
    if (this.path) {
      const last = this.path.rows.length - 1;
      this.path.stops.forEach((stop, i) => {
        const image = stop.signs.includes(-1) ? ", mirrored" : "";
        const name = stop.solution === null ? "" : `: solution ${stop.solution + 1}${image}`;
        this.goals.push({ group: "from the sketch along S to", text: `crossing ${i + 1}${name}`,
                          row: stop.row, solution: stop.solution, stops: [] });
        met.add(stop.solution);
      });
      this.goals.push({ group: "all of S", text: "once around, back to the sketch", row: last, solution: null,
                        stops: [] });
    }
    const others = this.scene.solutions.map((_, i) => i).filter((i) => !met.has(i));
    const group = this.path ? "solutions that are not on S" : "solutions";
    others.forEach((solution, k) => {
      const stops = others.length > 1 ? [others.at(k - 1), solution] : [solution];
      this.goals.push({ group, text: `solution ${solution + 1}`, row: null, solution, stops });
    });
    if (others.length > 1)
      this.goals.push({ group: "all of them", text: "one after another, back to the first", row: null, solution: null,
                        stops: [...others, others[0]] });
    this.scene.curves.forEach(({ label, constraint, from, to }, curve) => this.goals.push({
      group: constraint === "" ? "motions" : label,
      text: constraint === "" ? label : `solution ${from + 1} to ${to + 1}`,
      row: null, solution: null, curve, stops: [],
    }));
    const groups = new Map();
    this.goals.forEach((goal, i) => {
      if (!groups.has(goal.group)) groups.set(goal.group, new OptionGroup(goal.group));
      groups.get(goal.group).add(goal.text, i);
    });
    this.find("goal").replaceChildren(...[...groups.values()].map((group) => group.element));
    if (this.goals.length === 0) this.find("controls").hidden = true;
  }

  /** Which colour is which body, and which side of a plane is which. */
  fillLegend() {
    const entries = this.scene.bodies.map(({ name }, k) => [`body${FigureView.colourClass(k)}`, name]);
    if (this.scene.planes.length > 0)
      entries.push(["plane front", "plane, seen from its normal's side"], ["plane back", "seen from behind"]);
    const legend = this.find("legend");
    legend.hidden = entries.length === 0;
    legend.replaceChildren(...entries.map(([kind, text]) => {
      const entry = document.createElement("li");
      const svg = Drawing.element("svg", { viewBox: "0 0 16 12", "aria-hidden": true }, entry);
      Drawing.element("rect", { class: kind, x: 2, y: 1, width: 12, height: 10 }, svg);
      entry.append(text);
      return entry;
    }));
  }

  get goal() { return this.goals[Number(this.find("goal").value)]; }

  choose() {
    this.stop();
    if (this.goals.length === 0) return;
    const moves = ScenePanel.moves(this.goal);
    this.find("way").textContent = this.goal.curve !== undefined ? "Along the curve"
      : this.goal.row === null && moves ? "Between solutions" : "Along S";
    this.find("slider").disabled = this.find("play").disabled = !moves;
    this.find("slider").value = this.find("slider").max;
    this.move();
  }

  /** Shows the place of the slider. */
  move() {
    if (this.goal.curve !== undefined) this.moveAlongCurve();
    else if (this.goal.row === null) this.moveBetweenSolutions();
    else this.moveAlongPath();
  }

  moveBetweenSolutions() {
    const { stops } = this.goal;
    const slider = this.find("slider");
    const place = (stops.length - 1) * Number(slider.value) / Number(slider.max);
    const k = Math.min(Math.floor(place), Math.max(0, stops.length - 2));
    const [a, b] = [stops[k], stops[Math.min(k + 1, stops.length - 1)]];
    const part = place - k;
    const { solutions } = this.scene;
    this.shown = part === 0 ? a : part === 1 ? b : null;
    this.display(FigureWalk.at(this.scene, solutions[a], solutions[b], part), null);
    const words = this.shown === null ? `between solutions ${a + 1} and ${b + 1}: moved from one to the other, no solution`
      : `solution ${this.shown + 1}${this.path ? ", not on S" : ""}`;
    slider.setAttribute("aria-valuetext", words);
    this.find("where").textContent = words;
  }

  moveAlongCurve() {
    const { label, from, to, figures } = this.scene.curves[this.goal.curve];
    const slider = this.find("slider");
    const part = Number(slider.value) / Number(slider.max);
    this.shown = part === 0 ? from : part === 1 ? to : null;
    this.display(FigureWalk.along(figures, part), null);
    const words = this.shown === null ? label : `solution ${this.shown + 1}`;
    slider.setAttribute("aria-valuetext", words);
    this.find("where").textContent = words;
  }

  moveAlongPath() {
    const { row, solution } = this.goal;
    const slider = this.find("slider");
    const end = this.path.rows[row][1];
    const isThere = Number(slider.value) === Number(slider.max);
    const place = isThere ? this.path.atRow(row) : this.path.at(end * Number(slider.value) / Number(slider.max));
    this.shown = solution;
    this.display(ScenePanel.ofPoints(place.points), place);
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
    this.views.forEach((view, i) => view.svg.parentElement.setAttribute("aria-pressed", i === this.shown));
    if (this.graph) this.graph.mark({ solution: this.shown, curve: this.goal.curve ?? null });
  }

  makeGraph() {
    if (this.find("graph") === null) return;
    this.graph = new GraphPlot(this.find("graph"), this.find("edges"), this.find("constraints"),
                               this.scene.solutions.length, this.scene.curves);
    this.graph.onnode = (solution) => this.goTo(solution);
    this.graph.onedge = (curve) => {
      this.find("goal").value = this.goals.findIndex((goal) => goal.curve === curve);
      this.choose();
      this.play();
    };
  }

  /** The coordinates of what is shown, beside those of the solution as it is listed. */
  fillCoordinates(figure) {
    const axes = this.scene.dimension === 2 ? [0, 1] : [0, 1, 2];
    const size = this.size;
    const numbers = (v) => axes.map((axis) => Drawing.coordinate(v[axis], size));
    const listed = this.shown === null ? null : this.listedImage(this.shown);
    const rows = this.scene.points.map((name, i) => [name, numbers(figure.points[i]), listed && numbers(listed[i])]);
    const then = this.goal.row === null && this.shown !== null ? this.scene.solutions[this.shown] : null;
    figure.lines.forEach((line, i) => {
      const name = this.scene.lines[i];
      rows.push([`${name}, a point`, numbers(line.point), then && numbers(then.lines[i].point)]);
      rows.push([`${name}, direction`, numbers(line.direction), then && numbers(then.lines[i].direction)]);
    });
    figure.planes.forEach((plane, i) => {
      const name = this.scene.planes[i];
      const offset = ({ offset }) => [Drawing.coordinate(offset, size), "–", "–"];
      rows.push([`${name}, normal`, numbers(plane.normal), then && numbers(then.planes[i].normal)]);
      rows.push([`${name}, offset`, offset(plane), then && offset(then.planes[i])]);
    });
    this.find("coordinates").replaceChildren(...rows.map(([name, now, listedNumbers]) => {
      const row = document.createElement("tr");
      const heading = document.createElement("th");
      heading.scope = "row";
      heading.textContent = name;
      row.append(heading, ...now.concat(listedNumbers || axes.map(() => "–")).map((text) => {
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
      const view = new FigureView(svg, this.scene, this.size);
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
    const seconds = this.goal.row === null && this.goal.curve === undefined
      ? ScenePanel.secondsOfWalk * (this.goal.stops.length - 1)
      : ScenePanel.secondsOfPath;
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
    this.find("play").textContent = "Move";
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

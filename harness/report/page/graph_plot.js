"use strict";

/** Solutions as nodes, and the curves between them that are left when a value is released, in a colour for each. */
class GraphPlot {
  static size = 520;
  static mostNumbered = 60;

  /** `curves`: those of the scene; edges are those with a constraint. `onnode(solution)`, `onedge(curve)`. */
  constructor(svg, select, legend, solutions, curves) {
    this.svg = svg;
    this.select = select;
    this.solutions = solutions;
    this.edges = curves.map((curve, number) => ({ ...curve, number })).filter((curve) => curve.constraint !== "");
    this.constraints = [...new Set(this.edges.map((edge) => edge.constraint))];
    this.onnode = () => {};
    this.onedge = () => {};
    this.grow();
    this.place();
    this.fillChoices();
    this.fillLegend(legend);
    select.addEventListener("change", () => this.draw());
    this.draw();
  }

  colour(constraint) {
    return `hsl(${(360 * this.constraints.indexOf(constraint) / this.constraints.length).toFixed(0)} 70% 48%)`;
  }

  /** The forest of the edges by which each solution is come to first, breadth first. */
  grow() {
    this.tree = new Set();
    this.children = Array.from({ length: this.solutions }, () => []);
    this.roots = [];
    const reached = new Set();
    const at = Array.from({ length: this.solutions }, () => []);
    for (const edge of this.edges) {
      at[edge.from].push([edge.to, edge]);
      at[edge.to].push([edge.from, edge]);
    }
    for (let root = 0; root < this.solutions; ++root) {
      if (reached.has(root)) continue;
      reached.add(root);
      this.roots.push(root);
      for (const queue = [root]; queue.length > 0;) {
        const node = queue.shift();
        for (const [other, edge] of at[node]) {
          if (reached.has(other)) continue;
          reached.add(other);
          this.tree.add(edge);
          this.children[node].push(other);
          queue.push(other);
        }
      }
    }
  }

  /** On circles by the distance from the root, with as much of the circle as leaves; several trees share the circles. */
  place() {
    const leaves = (node) => Math.max(1, this.children[node].reduce((sum, child) => sum + leaves(child), 0));
    const height = (node) => this.children[node].reduce((most, child) => Math.max(most, 1 + height(child)), 0);
    const first = this.roots.length > 1 ? 1 : 0;
    const depths = first + Math.max(0, ...this.roots.map(height));
    const half = GraphPlot.size / 2;
    const total = this.roots.reduce((sum, root) => sum + leaves(root), 0);
    this.places = [];
    const put = (node, depth, begin) => {
      const angle = 2 * Math.PI * (begin + leaves(node) / 2) / total;
      const radius = depths === 0 ? 0 : 0.92 * half * depth / depths;
      this.places[node] = [half + radius * Math.sin(angle), half - radius * Math.cos(angle)];
      for (const child of this.children[node]) {
        put(child, depth + 1, begin);
        begin += leaves(child);
      }
    };
    let begin = 0;
    for (const root of this.roots) {
      put(root, first, begin);
      begin += leaves(root);
    }
  }

  fillChoices() {
    const count = (edges) => ` (${edges.length})`;
    const options = [new Option(`by which each is come to first (${this.tree.size})`, "tree")];
    if (this.edges.length > this.tree.size) options.push(new Option(`all${count(this.edges)}`, "all"));
    for (const constraint of this.constraints)
      options.push(new Option(`without ${constraint}${count(this.edges.filter((e) => e.constraint === constraint))}`,
                              `of ${constraint}`));
    this.select.replaceChildren(...options);
  }

  fillLegend(legend) {
    legend.replaceChildren(...this.constraints.map((constraint) => {
      const entry = document.createElement("li");
      const svg = Drawing.element("svg", { viewBox: "0 0 16 12", "aria-hidden": true }, entry);
      Drawing.element("line", { class: "way", x1: 1, x2: 15, y1: 6, y2: 6, stroke: this.colour(constraint) }, svg);
      entry.append(constraint);
      return entry;
    }));
  }

  /** Those that are chosen. */
  chosen() {
    const choice = this.select.value;
    if (choice === "tree") return [...this.tree];
    return this.edges.filter((edge) => choice === "all" || choice === `of ${edge.constraint}`);
  }

  draw() {
    this.svg.replaceChildren();
    const between = new Map();
    for (const edge of this.chosen()) {
      const pair = `${Math.min(edge.from, edge.to)} ${Math.max(edge.from, edge.to)}`;
      const before = between.get(pair) || 0;
      between.set(pair, before + 1);
      this.drawEdge(edge, before);
    }
    this.places.forEach((place, node) => this.drawNode(place, node));
    this.mark(this.marked || {});
  }

  /** The k-th between its ends is bent the more; one that comes back to its solution is a loop. */
  drawEdge(edge, k) {
    let [p, q] = [this.places[edge.from], this.places[edge.to]];
    if (edge.from > edge.to) [p, q] = [q, p];
    const bend = (k % 2 === 0 ? 1 : -1) * Math.ceil(k / 2) * 14;
    const [dx, dy] = [q[0] - p[0], q[1] - p[1]];
    const length = Math.hypot(dx, dy);
    const number = (x) => x.toFixed(1);
    const loop = 12 + 5 * k;
    const middle = [(p[0] + q[0]) / 2 - bend * dy / (length || 1), (p[1] + q[1]) / 2 + bend * dx / (length || 1)];
    const d = edge.from === edge.to
      ? `M${p.map(number)}c${-loop} ${-2 * loop} ${loop} ${-2 * loop} 0 0`
      : `M${p.map(number)}Q${middle.map(number)} ${q.map(number)}`;
    const title = `${edge.label}: solution ${edge.from + 1} to ${edge.to + 1}`;
    const group = Drawing.element("g", { class: "edge-of-graph", "data-curve": edge.number }, this.svg);
    Drawing.element("path", { class: "way", d, stroke: this.colour(edge.constraint) }, group);
    Drawing.element("title", {}, Drawing.element("path", { class: "reach", d }, group), title);
    group.addEventListener("click", () => this.onedge(edge.number));
  }

  drawNode([x, y], node) {
    const isNumbered = this.solutions <= GraphPlot.mostNumbered;
    const group = Drawing.element("g", { class: "node", "data-solution": node }, this.svg);
    const circle = Drawing.element("circle", { class: "solution", cx: x.toFixed(1), cy: y.toFixed(1),
                                               r: isNumbered ? 10 : 3 }, group);
    Drawing.element("title", {}, circle, `solution ${node + 1}`);
    if (isNumbered)
      Drawing.element("text", { class: "node-text", x: x.toFixed(1), y: (y + 4).toFixed(1), "text-anchor": "middle" },
                      group, node + 1);
    group.addEventListener("click", () => this.onnode(node));
  }

  /** Shows which solution or curve the figure is at. */
  mark({ solution = null, curve = null }) {
    this.marked = { solution, curve };
    for (const node of this.svg.querySelectorAll(".node"))
      node.classList.toggle("marked", Number(node.dataset.solution) === solution);
    for (const edge of this.svg.querySelectorAll(".edge-of-graph"))
      edge.classList.toggle("marked", Number(edge.dataset.curve) === curve);
  }
}

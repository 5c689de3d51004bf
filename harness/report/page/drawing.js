"use strict";

/** Elements of SVG, and numbers as people write them. */
const Drawing = {
  element(name, attributes, parent, text) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    if (text !== undefined) element.textContent = text;
    if (parent) parent.appendChild(element);
    return element;
  },

  /** At most about `count` round numbers in [low, high]. */
  ticks(low, high, count) {
    const rough = (high - low) / count;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((factor) => factor * power).find((candidate) => candidate >= rough);
    const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
    return Array.from({ length: Math.max(0, Math.min(last - first, 2 * count)) + 1 }, (_, i) => (first + i) * step);
  },

  number(value, digits) {
    const text = Number(value.toPrecision(digits));
    return String(Object.is(text, -0) ? 0 : text).replace("-", "−");
  },

  /** With as many decimals as leave seven digits of `size`. */
  coordinate(value, size) {
    const exponent = Math.floor(Math.log10(size));
    if (Math.abs(exponent) > 6) return value.toExponential(6).replace(/-/g, "−");
    const text = value.toFixed(Math.max(0, 6 - exponent));
    return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
  },
};

// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// The report for people, the charts, and what could not be flattened

const ROWS_AT_FIRST = 100; // of charts: an atlas can have thousands

function rowsTable(rows) {
  const body = element("tbody");
  for (const [label, value, remark] of rows) {
    const cells = value === undefined
      ? [element("th", {colspan: "3", scope: "colgroup", class: "group"}, capitalized(label))]
      : [element("th", {scope: "row"}, label),
        ...remark ? [element("td", {}, value), element("td", {}, remark)] : [element("td", {colspan: "2"}, value)]];
    body.append(element("tr", {}, ...cells));
  }
  const columns = ["label", "value", "remark"].map((name) => element("col", {class: name}));
  return element("table", {class: "rows"}, element("colgroup", {}, ...columns), body);
}

const CHART_COLUMNS = [
  ["Chart", (chart, i) => i],
  ["Triangles", (chart) => chart.triangles, (x) => wholeText(x)],
  ["Area", (chart) => chart.share_of_area, (x) => percentText(x)],
  ["Method", (chart) => chart.method, (x) => x],
  ["L2 stretch", (chart) => chart.l2_stretch, (x) => numberText(x, 4)],
  ["Scale stretch", (chart) => chart.scale_stretch, (x) => numberText(x, 4)],
  ["Seam jump", (chart) => chart.seam_jump, (x) => x === null ? "" : numberText(x, 4)],
];

class ChartsTable {
  // `show` is called with the number of a chart.
  constructor(charts, show) {
    this.charts = charts;
    this.show = show;
    this.order = charts.map((chart, i) => i);
    this.limit = ROWS_AT_FIRST;
    this.current = null;
    this.body = element("tbody");
    this.headers = CHART_COLUMNS.map(([title], column) => element("th", {scope: "col"},
      element("button", {type: "button", title: "Sort", onclick: () => this.sort(column)}, title)));
    this.more = element("button", {type: "button", class: "more", onclick: () => this.showAll()},
      `Show all ${wholeText(charts.length)}`);
    this.element = element("div", {class: "charts"}, element("div", {class: "scroll"},
      element("table", {}, element("thead", {}, element("tr", {}, ...this.headers)), this.body)), this.more);
    this.fill();
  }

  fill() {
    this.body.replaceChildren(...this.order.slice(0, this.limit).map((i) => this.row(i)));
    this.more.hidden = this.charts.length <= this.limit;
  }

  row(i) {
    const cells = CHART_COLUMNS.slice(1).map(([, value, text]) =>
      element("td", {}, text(value(this.charts[i], i))));
    const button = element("button", {type: "button", title: "Show this chart in both views"},
      element("i", {class: "swatch", style: `background: ${cssColor(colorOfChart(i))}`}), wholeText(i + 1));
    const attributes = {"data-chart": i, class: i === this.current ? "current" : "", onclick: () => this.show(i)};
    return element("tr", attributes, element("th", {scope: "row"}, button), ...cells);
  }

  // Large numbers first; in the same column again: the other way round
  sort(column) {
    const value = CHART_COLUMNS[column][1], header = this.headers[column];
    const sign = (header.ariaSort ? header.ariaSort === "ascending" : column !== 0) ? -1 : 1;
    this.headers.forEach((other) => other.ariaSort = null);
    header.ariaSort = sign < 0 ? "descending" : "ascending";
    const compare = (a, b) => a < b ? -1 : a > b ? 1 : 0;
    this.order.sort((i, j) => sign * compare(value(this.charts[i], i), value(this.charts[j], j)) || i - j);
    this.fill();
  }

  showAll() {
    this.limit = Infinity;
    this.fill();
  }

  mark(chart) {
    this.current = chart;
    for (const row of this.body.children) {
      row.classList.toggle("current", Number(row.dataset.chart) === chart);
    }
  }
}

function skippedList(skipped) {
  return element("ul", {}, ...skipped.map(({faces, first_face: face, message, diagnosis}) => element("li", {},
    element("strong", {}, `${countText(faces, "face")} from face ${wholeText(face + 1)} on: `),
    message || diagnosis)));
}

// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// What is on the page besides the views: texts, tables, switches. `actions` is the page.

// [name, title] of each
function modesOf(measures) {
  return [["checkerboard", "Checkerboard"], ["charts", "Charts"],
    ...measures.map(({name, title}) => [name, capitalized(title)])];
}

function writeTexts({title, version, kind, triangles, charts, rows, notes, skipped}, part) {
  part.title.textContent = title;
  part.subtitle.textContent = [kind === "atlas" ? "Atlas" : "Chart", countText(triangles, "triangle"),
    countText(charts.length, "chart"), `flatten_mesh ${version}`].join(" · ");
  part.rows.append(rowsTable(rows));
  part.notes.append(element("ul", {}, ...notes.map((note) => element("li", {}, note))));
  part.notes.hidden = notes.length === 0;
  part.skipped.append(skippedList(skipped));
  part.skipped.hidden = skipped.length === 0;
  part.charts.hidden = charts.length === 0;
}

function writeThinning({triangles, shown_triangles: shown}, part) {
  part.thinned.hidden = shown >= triangles;
  part.thinned.textContent = `Shown: ${wholeText(shown)} of ${countText(triangles, "triangle")}. `
    + `Measures, histograms and worst faces are those of all ${wholeText(triangles)}.`;
}

// Lines between the pages on the sheet, ten in a row
function drawPages(pages, sheet) {
  if (pages > 1) {
    const line = "var(--outline) 1px, transparent 1px";
    sheet.style.backgroundImage = `linear-gradient(to right, ${line}), linear-gradient(to bottom, ${line})`;
    sheet.style.backgroundSize = `${100 / Math.min(pages, 10)}% ${100 / Math.ceil(pages / 10)}%`;
  }
}

function addModes(measures, part, actions) {
  part.modes.append(...modesOf(measures).map(([mode, title]) => element("label", {},
    element("input", {type: "radio", name: "mode", value: mode, onchange: () => actions.showMode(mode)}),
    element("span", {}, title))));
}

function addSwitches(part, actions) {
  part.squares.addEventListener("input", () => actions.showSquares(2 ** part.squares.value));
  part.seams.addEventListener("change", () => actions.showSeams(part.seams.checked));
  part.up.addEventListener("change", () => actions.setUp(part.up.value));
  part.reset.addEventListener("click", () => actions.resetViews());
  part.release.addEventListener("click", () => actions.letGo());
  part.find.addEventListener("click", () => actions.showInBoth(actions.selected));
  addEventListener("keydown", (event) => event.key === "Escape" && actions.letGo());
}

// The number of squares is a power of two.
function markSquares(squares, part) {
  part["squares-value"].textContent = squares;
  part.squares.value = Math.log2(squares);
}

// Which of the modes is on, in all places that tell it
function markMode(mode, measure, part) {
  part.modes.querySelectorAll("input").forEach((input) => input.checked = input.value === mode);
  part.measures.querySelectorAll(".measure").forEach((panel) =>
    panel.classList.toggle("current", panel.dataset.measure === mode));
  part["squares-label"].hidden = mode !== "checkerboard";
  part.legend.replaceChildren(legendOfMode(mode, measure));
}

// `lines` as by linesAbout(); null without a face
function writeSelection(lines, part) {
  part.selection.classList.toggle("empty", !lines);
  part["selection-title"].textContent = lines ? lines[0][0] : "No face selected";
  part["selection-hint"].hidden = Boolean(lines);
  part["selection-values"].hidden = !lines;
  part["selection-values"].replaceChildren(...(lines || []).slice(1).flatMap(([text, value]) =>
    [element("dt", {}, text), element("dd", {}, value)]));
  part.release.disabled = part.find.disabled = !lines;
}

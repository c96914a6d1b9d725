"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const by = (id) => document.getElementById(id);
  const svgNode = (name, attributes, text) => {
    const node = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    if (text !== undefined) node.textContent = text;
    return node;
  };
  const columns = data.columns;
  const column = (name) => columns.find((c) => c.name === name);
  const status = column("status").cells;
  const names = column("name").cells;
  const isNumber = (v) => typeof v === "number";
  const shownNumber = (v) => (Number.isInteger(v) ? String(v) : Number(v.toPrecision(5)).toString());

  // Table
  let sortBy = null, direction = 1;
  const visible = () => columns.filter((c) => by("all-columns").checked || (c.shown && c.cells.some((v) => v !== null)));
  const order = () => {
    const wanted = by("search").value.toLowerCase(), only = by("status").value;
    const rows = names.map((_, k) => k).filter((k) =>
      (!only || status[k] === only)
      && (!wanted || columns.some((c) => c.cells[k] !== null && String(c.cells[k]).toLowerCase().includes(wanted))));
    if (sortBy) {
      const cells = sortBy.cells;
      rows.sort((a, b) => {
        const [x, y] = [cells[a], cells[b]];
        // Empty cells come last either way.
        if (x === null || y === null) return (x === null) - (y === null) || a - b;
        const d = isNumber(x) && isNumber(y) ? x - y : String(x).localeCompare(String(y), "en", { numeric: true });
        return direction * d || a - b;
      });
    }
    return rows;
  };
  const link = (k) => {
    if (!data.links[k]) return document.createTextNode(names[k]);
    const a = document.createElement("a");
    a.href = data.links[k];
    a.textContent = names[k];
    return a;
  };
  const draw = () => {
    const head = document.createElement("tr");
    const picture = document.createElement("th");
    picture.textContent = "picture";
    const shown = visible();
    for (const c of shown) {
      const th = document.createElement("th");
      th.scope = "col";
      th.setAttribute("aria-sort", sortBy === c ? (direction > 0 ? "ascending" : "descending") : "none");
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = c.name;
      button.addEventListener("click", () => {
        direction = sortBy === c ? -direction : 1;
        sortBy = c;
        draw();
      });
      th.append(button);
      head.append(th);
      if (c.name === "name") head.append(picture);
    }
    by("table").tHead.replaceChildren(head);
    const rows = order();
    const body = document.createDocumentFragment();
    for (const k of rows) {
      const tr = document.createElement("tr");
      for (const c of shown) {
        const td = document.createElement("td"), v = c.cells[k];
        if (c.name === "name") {
          td.append(link(k));
        } else if (c.name === "status") {
          const tag = document.createElement("span");
          tag.className = `tag ${v}`;
          tag.textContent = v;
          td.append(tag);
        } else if (isNumber(v)) {
          td.className = "number";
          td.textContent = shownNumber(v);
          td.title = String(v);
        } else if (v !== null) {
          td.textContent = String(v);
          if (String(v).length > 40) td.className = "wide";
        }
        tr.append(td);
        if (c.name === "name") {
          const cell = document.createElement("td");
          // Made by the program from numbers alone.
          if (data.pictures[k]) cell.innerHTML = data.pictures[k];
          tr.append(cell);
        }
      }
      body.append(tr);
    }
    by("table").tBodies[0].replaceChildren(body);
    by("shown").textContent = `${rows.length} of ${names.length} members`;
  };
  for (const id of ["search", "status", "all-columns"]) by(id).addEventListener("input", draw);

  // Plots
  const numeric = columns.filter((c) => c.cells.some(isNumber) && new Set(c.cells.filter(isNumber)).size > 1);
  const first = (wanted) => wanted.map((n) => numeric.find((c) => c.name === n)).find((c) => c) || numeric[0];
  const parameters = numeric.filter((c) => c.shown && c.name.includes("."));
  const start = { "plot-x": parameters[0] || first(["path_length_mm"]), "plot-y": first(["machining_time_s", "path_length_mm"]) };
  for (const id of ["plot-x", "plot-y"]) {
    for (const c of numeric) {
      const option = document.createElement("option");
      option.textContent = c.name;
      option.selected = c === start[id];
      by(id).append(option);
    }
    by(id).addEventListener("input", () => plots());
  }
  const ticks = (lo, hi) => {
    const rough = (hi - lo) / 5, power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough) || rough;
    const list = [];
    for (let t = Math.ceil(lo / step) * step; t <= hi + 1e-9 * step; t += step) list.push(t);
    return list;
  };
  const frame = (svg, xr, yr, xName, yName) => {
    const box = svg.getBoundingClientRect(), w = box.width || 600, h = box.height || 300;
    svg.setAttribute("viewBox", `0 0 ${w} ${h}`);
    svg.replaceChildren();
    const x = (v) => 62 + ((v - xr[0]) / (xr[1] - xr[0])) * (w - 78), y = (v) => h - 38 - ((v - yr[0]) / (yr[1] - yr[0])) * (h - 54);
    for (const t of ticks(...xr)) {
      svg.append(svgNode("line", { class: "axis", x1: x(t), x2: x(t), y1: 16, y2: h - 38 }));
      svg.append(svgNode("text", { x: x(t), y: h - 24, "text-anchor": "middle" }, shownNumber(t)));
    }
    for (const t of ticks(...yr)) {
      svg.append(svgNode("line", { class: "axis", x1: 62, x2: w - 16, y1: y(t), y2: y(t) }));
      svg.append(svgNode("text", { x: 57, y: y(t) + 4, "text-anchor": "end" }, shownNumber(t)));
    }
    svg.append(svgNode("text", { x: w - 16, y: h - 8, "text-anchor": "end" }, xName));
    svg.append(svgNode("text", { x: 4, y: 11 }, yName));
    return [x, y];
  };
  const range = (values) => {
    const lo = Math.min(...values), hi = Math.max(...values), room = 0.05 * (hi - lo) || Math.abs(hi) * 0.1 || 1;
    return [lo - room, hi + room];
  };
  const plots = () => {
    const [cx, cy] = [column(by("plot-x").value), column(by("plot-y").value)];
    if (!cx || !cy) {
      by("scatter-note").textContent = "There are no figures that differ between members.";
      return;
    }
    const rows = names.map((_, k) => k).filter((k) => isNumber(cx.cells[k]) && isNumber(cy.cells[k]));
    const svg = by("scatter");
    const [x, y] = frame(svg, range(rows.map((k) => cx.cells[k])), range(rows.map((k) => cy.cells[k])), cx.name, cy.name);
    for (const k of rows) {
      const dot = svgNode("circle", { class: status[k], cx: x(cx.cells[k]), cy: y(cy.cells[k]), r: 4.5 });
      dot.append(svgNode("title", {}, `${names[k]}: ${shownNumber(cx.cells[k])}, ${shownNumber(cy.cells[k])}`));
      dot.addEventListener("click", () => { if (data.links[k]) location.href = data.links[k]; });
      svg.append(dot);
    }
    by("scatter-note").textContent = `${rows.length} members have both figures.`;
    const values = cy.cells.filter(isNumber), span = range(values), bins = Math.max(5, Math.min(30, Math.ceil(Math.sqrt(values.length) * 1.5)));
    const counts = new Array(bins).fill(0);
    for (const v of values) counts[Math.min(bins - 1, Math.floor(((v - span[0]) / (span[1] - span[0])) * bins))] += 1;
    const bars = by("bars"), [bx, yy] = frame(bars, span, [0, Math.max(...counts) * 1.08], cy.name, "members");
    counts.forEach((n, k) => {
      const a = bx(span[0] + (k * (span[1] - span[0])) / bins), b = bx(span[0] + ((k + 1) * (span[1] - span[0])) / bins);
      bars.append(svgNode("rect", { x: a + 1, y: yy(n), width: Math.max(b - a - 2, 1), height: yy(0) - yy(n) }));
    });
    const sorted = [...values].sort((a, b) => a - b), at = (p) => shownNumber(sorted[Math.min(sorted.length - 1, Math.floor(p * sorted.length))]);
    by("bars-note").textContent = `${cy.name}: least ${at(0)}, median ${at(0.5)}, greatest ${shownNumber(sorted[sorted.length - 1])}`;
  };
  draw();
  plots();
  addEventListener("resize", plots);
})();

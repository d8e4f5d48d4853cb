// SPDX-License-Identifier: BSD-3-Clause
// Draws the plots of a report by uPlot, and sorts its tables. report.py puts this text into the page.
"use strict";
(function () {
    const colours = ["#264653", "#e76f51", "#2a9d8f", "#e9c46a", "#6d597a", "#f4a261", "#457b9d", "#9a031e", "#588157", "#b56576"];
    const plots = JSON.parse(document.getElementById("plots").textContent);
    const width = () => Math.min(1080, document.body.clientWidth - 32);
    const short = (value) => value == null ? "–" : Number(value).toPrecision(6).replace(/\.?0+($|e)/, "$1");
    const charts = [];
    let drawn = 0;

    function lines(place, plot) {
        const time = plot.x.replace("[", " (").replace("]", ")");
        const series = [{label: time, value: (u, v) => short(v)}];
        plot.names.forEach((name, k) => series.push({
            label: name, stroke: colours[k % colours.length], width: 1.5, value: (u, v) => short(v),
            dash: k < colours.length ? undefined : [6, 3], points: {show: plot.data[0].length < 40}}));
        const axes = [{label: time}, {label: plot.unit === "1" || plot.unit === "" ? "" : plot.unit, size: 80,
            values: (u, all) => all.map(short)}];
        charts.push(new uPlot({width: width(), height: 320, scales: {x: {time: false}}, series: series, axes: axes,
            cursor: {drag: {x: true, y: false}}}, plot.data, place));
        drawn++;
    }

    // A point for each row: the groups are series, the front is a line; the row beside the cursor is told in words.
    function front(place, plot) {
        const rows = plot.rows, x = rows.map((row) => row.seconds);
        const groups = [...new Set(rows.map((row) => row.group))];
        const data = [x], series = [{label: "seconds"}];
        data.push(rows.map((row) => row.front ? row.error : null));
        series.push({label: "front", stroke: "#9a9a9a", width: 1.5, dash: [6, 4], spanGaps: true, points: {show: false}});
        groups.forEach((group, k) => {
            const colour = colours[k % colours.length];
            data.push(rows.map((row) => row.group === group ? row.error : null));
            series.push({label: group, stroke: colour, width: 0, paths: () => null,
                points: {show: true, size: 9, fill: colour, stroke: colour}});
        });
        const told = document.createElement("p");
        told.className = "told";
        told.textContent = "point at a run to read its settings";
        const tell = (u) => {
            let best = null, near = 40 * 40;
            rows.forEach((row, k) => {
                const a = u.valToPos(row.seconds, "x") - u.cursor.left, b = u.valToPos(row.error, "y") - u.cursor.top;
                if (a * a + b * b < near) { near = a * a + b * b; best = row; }
            });
            if (best)
                told.textContent = `${best.group}: ${best.settings} – ${short(best.seconds)} s, error ${short(best.error)}` +
                    (best.front ? ", on the front" : "");
        };
        const ticks = (u, all) => all.map((value) => value == null ? "" : short(value));
        charts.push(new uPlot({width: width(), height: 420, scales: {x: {time: false, distr: 3}, y: {distr: 3}}, series: series,
            axes: [{label: "seconds", values: ticks}, {label: "error", size: 80, values: ticks}],
            legend: {live: false}, cursor: {drag: {x: false, y: false}}, hooks: {setCursor: [tell]}}, data, place));
        place.appendChild(told);
        drawn++;
    }

    function sorts(table) {
        table.querySelectorAll("th").forEach((head, column) => {
            let up = false;
            head.addEventListener("click", () => {
                const body = table.tBodies[0], rows = [...body.rows];
                up = !up;
                rows.sort((a, b) => {
                    const p = a.cells[column].textContent, q = b.cells[column].textContent, d = parseFloat(p) - parseFloat(q);
                    return (isNaN(d) ? p.localeCompare(q) : d) * (up ? 1 : -1);
                });
                rows.forEach((row) => body.appendChild(row));
            });
        });
    }

    document.querySelectorAll(".plot").forEach((place) => {
        const plot = plots[Number(place.dataset.plot)];
        (plot.kind === "front" ? front : lines)(place, plot);
    });
    document.querySelectorAll("table.sorts").forEach(sorts);
    window.addEventListener("resize", () => charts.forEach((chart) => chart.setSize({width: width(), height: chart.height})));
    document.body.dataset.drawn = String(drawn);
})();

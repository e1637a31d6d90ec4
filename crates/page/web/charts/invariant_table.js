// The invariants in numbers; the first column is the legend of the chart.

class InvariantTable {
  constructor(table) {
    this.body = table.tBodies[0];
  }

  /** Writes values and deviations. New rows are made for other invariants. */
  draw(invariants, { values, deviations }) {
    if (this.invariants !== invariants) {
      this.invariants = invariants;
      this.body.replaceChildren(...invariants.map((invariant, i) => this.row(invariant, CURVES[i % CURVES.length])));
    }
    invariants.forEach(({ symbol, unit }, i) => {
      const { cells } = this.body.rows[i];
      cells[1].textContent = `${readable(values[i], 8)} ${unit}`.trim();
      cells[2].textContent = `${deviations[i] < 0 ? "−" : ""}${scientific(Math.abs(deviations[i]))}`;
      cells[2].dataset.deviation = `${symbol}=${deviations[i]}`;
    });
  }

  row({ symbol, unit }, { color, dash }) {
    const row = document.createElement("tr");
    row.innerHTML = '<th scope="row"><svg viewBox="0 0 35 10" aria-hidden="true"><path d="M0 5H35" fill="none" stroke-width="2.5"/></svg>'
      + '<b></b> <span class="long"></span></th><td></td><td></td>';
    row.querySelector("path").style.stroke = `var(${color})`;
    row.querySelector("path").setAttribute("stroke-dasharray", dash.join(" "));
    row.querySelector("b").textContent = pretty(symbol);
    row.querySelector("span").textContent = INVARIANT_NAMES[symbol] ?? "";
    row.cells[1].title = unit || "no unit";
    return row;
  }
}

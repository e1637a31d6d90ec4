// The invariants in numbers; the first column is the legend of the chart.

/** A change with its sign and four digits. */
function signed(change) {
  return `${change < 0 ? "−" : "+"}${readable(Math.abs(change), 4)}`;
}

class InvariantTable {
  constructor(table) {
    this.body = table.tBodies[0];
  }

  /** Writes values, what friction has changed in them, and deviations. New rows are made for other invariants. */
  draw(invariants, { values, byFriction, deviations }) {
    const rubbed = byFriction.some((change) => change !== 0);
    byId("friction-note").hidden = !rubbed;
    if (this.invariants !== invariants) {
      this.invariants = invariants;
      this.body.replaceChildren(...invariants.map((invariant, i) => this.row(invariant, CURVES[i % CURVES.length])));
    }
    invariants.forEach(({ symbol, unit }, i) => {
      const { cells } = this.body.rows[i];
      cells[1].firstChild.textContent = `${readable(values[i], 8)} ${unit}`.trim();
      cells[1].lastChild.textContent = rubbed && byFriction[i] !== 0 ? `by friction ${signed(byFriction[i])}` : "";
      cells[2].textContent = `${deviations[i] < 0 ? "−" : ""}${scientific(Math.abs(deviations[i]))}`;
      cells[2].dataset.deviation = `${symbol}=${deviations[i]}`;
    });
  }

  row({ symbol, unit }, { color, dash }) {
    const row = document.createElement("tr");
    row.innerHTML = '<th scope="row"><svg viewBox="0 0 35 10" aria-hidden="true"><path d="M0 5H35" fill="none" stroke-width="2.5"/></svg>'
      + '<b></b> <span class="long"></span></th><td><div></div><small></small></td><td></td>';
    row.querySelector("path").style.stroke = `var(${color})`;
    row.querySelector("path").setAttribute("stroke-dasharray", dash.join(" "));
    row.querySelector("b").textContent = pretty(symbol);
    row.querySelector("span").textContent = INVARIANT_NAMES[symbol] ?? "";
    row.cells[1].title = unit || "no unit";
    return row;
  }
}

// The controls: what is chosen, and who is told.

/** Radio buttons that look like chips, one for each item. */
function chips(container, group, items, chosen) {
  for (const [index, { name, label }] of items) {
    const input = Object.assign(document.createElement("input"), { type: "radio", name: group, value: index, id: `${group}-${name}` });
    input.addEventListener("change", () => chosen(index));
    const chip = document.createElement("label");
    chip.append(input, label);
    container.append(chip);
  }
}

class Form {
  static NUMBERS = ["i1", "i2", "i3", "weight", "c1", "c2", "c3", "tilt", "turn", "p1", "p2", "p3"];

  /** Calls `told.method(index)`, `told.step(seconds)`, `told.section(coordinate)` and `told.thrown()`. */
  constructor(told) {
    this.told = told;
    const methods = [...METHODS.entries()];
    const choose = (index) => told.method(index);
    chips(byId("poisson"), "method", methods.filter(([, { poisson }]) => poisson), choose);
    chips(byId("direct"), "method", methods.filter(([, { poisson }]) => !poisson), choose);
    chips(byId("tops"), "top", [...TOPS.entries()], (index) => {
      this.fill(index);
      told.thrown();
    });
    byId("step").max = STEPS.length - 1;
    byId("step").addEventListener("input", () => {
      this.sayStep();
      told.step(this.step);
    });
    byId("speed").replaceChildren(...SPEEDS.map((speed) => new Option(`${speed} ×`, speed)));
    const names = ["Π₁", "Π₂", "Π₃", "Γ₁", "Γ₂", "Γ₃"];
    byId("coordinate").replaceChildren(...names.map((name, index) => new Option(name, index)));
    byId("coordinate").addEventListener("change", () => told.section(this.coordinate));
    for (const id of Form.NUMBERS) {
      byId(id).addEventListener("change", () => {
        this.choose("top", TOPS.length - 1);
        this.sayTop();
        told.thrown();
      });
    }
    this.choose("method", 0);
    this.chooseStep(0.02);
    byId("speed").value = 1;
    this.fill(0);
  }

  choose(group, index) {
    document.querySelector(`input[name="${group}"][value="${index}"]`).checked = true;
  }

  get method() {
    return Number(document.querySelector('input[name="method"]:checked').value);
  }

  get step() {
    return STEPS[Number(byId("step").value)];
  }

  get speed() {
    return Number(byId("speed").value);
  }

  get coordinate() {
    return Number(byId("coordinate").value);
  }

  /** Chooses the step of the slider that is nearest. */
  chooseStep(step) {
    const distance = (other) => Math.abs(Math.log(other / step));
    byId("step").value = STEPS.reduce((best, other, i) => (distance(other) < distance(STEPS[best]) ? i : best), 0);
    this.sayStep();
  }

  /** Makes the step shorter or longer by so many places of the slider. */
  moveStep(by) {
    byId("step").value = Number(byId("step").value) + by;
    this.sayStep();
    this.told.step(this.step);
  }

  sayStep() {
    byId("step-text").textContent = `${this.step} s`;
    byId("step").setAttribute("aria-valuetext", `${this.step} seconds`);
  }

  /** Fills in the numbers of a top of the catalogue. */
  fill(index) {
    const { inertia, weight, center, tilt, turn, momentum, section } = TOPS[index];
    const numbers = [...inertia, weight, ...center, tilt, turn, ...momentum];
    Form.NUMBERS.forEach((id, i) => (byId(id).value = numbers[i]));
    byId("coordinate").value = section;
    this.choose("top", index);
    this.sayTop();
  }

  sayTop() {
    const index = Number(document.querySelector('input[name="top"]:checked').value);
    byId("says").textContent = TOPS[index].says;
  }

  /** Turns the throw at random: any direction of the vertical, and up to 5 kg m²/s about each axis. */
  surprise() {
    const random = (least, most) => Number((least + (most - least) * Math.random()).toFixed(2));
    byId("tilt").value = random(10, 170);
    byId("turn").value = random(0, 360);
    for (const id of ["p1", "p2", "p3"]) byId(id).value = random(-5, 5);
  }

  /** The parameters of the throw. What is no number is marked, and is NaN. */
  read() {
    const [i1, i2, i3, weight, c1, c2, c3, tilt, turn, p1, p2, p3] = Form.NUMBERS.map((id) => {
      const value = byId(id).valueAsNumber;
      byId(id).setAttribute("aria-invalid", String(Number.isNaN(value)));
      return value;
    });
    const vertical = verticalOf(tilt, turn);
    return { inertia: [i1, i2, i3], weight, center: [c1, c2, c3], momentum: [p1, p2, p3], vertical };
  }
}

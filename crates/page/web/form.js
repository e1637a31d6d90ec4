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

  /** What the library calls the numbers that it can refuse. */
  static LIBRARY_NAMES = {
    "inertia[0]": ["i1"], "inertia[1]": ["i2"], "inertia[2]": ["i3"], "principal moments": ["i1", "i2", "i3"], gravity: ["weight"],
  };

  /** Calls `told.method(index)`, `told.step(seconds)`, `told.friction(coefficient)`, `told.section(coordinate)` and `told.thrown()`. */
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
    byId("friction").max = FRICTIONS.length - 1;
    byId("friction").addEventListener("input", () => {
      this.sayFriction();
      told.friction(this.friction);
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
    this.choose("method", METHODS.findIndex(({ name }) => name === "gauss-8"));
    this.chooseStep(0.1);
    byId("friction").value = 0;
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

  /** The coefficient c of the friction in N m s, with two digits. */
  get friction() {
    return this.frictionAt(Number(byId("friction").value));
  }

  frictionAt(place) {
    return Number((FRICTIONS[place] * this.moment * this.rate).toPrecision(2));
  }

  /** Makes the scale of the friction that of a throw: its largest moment, and how fast it turns or its weight would turn it. */
  scaleFriction({ inertia, weight, momentum }) {
    this.moment = Math.max(...inertia);
    const rates = momentum.map((x, i) => (inertia[i] > 0 ? Math.abs(x / inertia[i]) : 0));
    this.rate = Math.max(...rates, Math.sqrt(weight / this.moment)) || 1;
    this.sayFriction();
  }

  /** Chooses the friction of the slider that is nearest, for the throw in the fields. */
  chooseFriction(coefficient) {
    this.scaleFriction(this.read());
    const distance = (place) => Math.abs(Math.log(this.frictionAt(place) / coefficient));
    byId("friction").value = FRICTIONS.reduce((best, _, i) => (distance(i) < distance(best) ? i : best), 0);
    this.sayFriction();
  }

  sayFriction() {
    const { friction } = this;
    const text = friction > 0 ? `c = ${readable(friction, 2)} N m s` : "none";
    byId("friction-text").textContent = text;
    byId("friction").setAttribute("aria-valuetext", text);
    // Alone, the torque −c Ω lets Ω decay as exp(−ct/I).
    byId("friction-says").textContent = friction > 0
      ? `The torque −c Ω alone leaves at most 37 % of Ω after ${readable(this.moment / friction, 2)} s. It takes energy and changes Π·Γ, not |Γ|².`
      : "As of the air: a torque −c Ω against the angular velocity Ω of the body.";
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

  /** The parameters of the throw. Throws the message of the first field that holds no number, and marks each of them. */
  read() {
    const numbers = Form.NUMBERS.map((id) => byId(id).valueAsNumber);
    const missing = Form.NUMBERS.filter((_, i) => Number.isNaN(numbers[i]));
    this.mark(missing);
    if (missing.length) throw new Error(`${Form.label(missing[0])} must be a number`);
    const [i1, i2, i3, weight, c1, c2, c3, tilt, turn, p1, p2, p3] = numbers;
    if (c1 === 0 && c2 === 0 && c3 === 0) {
      this.mark(["c1", "c2", "c3"]);
      throw new Error("c₁, c₂ and c₃ must not all be 0: they are a direction. A top without gravity has m g l = 0");
    }
    const vertical = verticalOf(tilt, turn);
    return { inertia: [i1, i2, i3], weight, center: [c1, c2, c3], momentum: [p1, p2, p3], vertical };
  }

  static label(id) {
    return byId(id).closest("label").textContent.trim();
  }

  /** Marks these fields as invalid, and no others, and brings the first one into the window. */
  mark(ids) {
    for (const id of Form.NUMBERS) byId(id).setAttribute("aria-invalid", String(ids.includes(id)));
    if (!ids.length) return;
    byId(ids[0]).closest("details").open = true;
    byId(ids[0]).scrollIntoView({ block: "nearest" });
  }

  /** Returns the message of the library with the labels of the fields that it is about, and marks these. */
  explain(message) {
    const [name, ids] = Object.entries(Form.LIBRARY_NAMES).find(([name]) => message.includes(name)) ?? [];
    if (!ids) return message;
    this.mark(ids);
    return ids.length === 1 ? message.replace(name, Form.label(ids[0])) : message;
  }
}

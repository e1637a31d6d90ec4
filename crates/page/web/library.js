// The library: one top, computed in WebAssembly.

class Library {
  /** Makes the module from its bytes in Base64. */
  static async load(text) {
    const bytes = Uint8Array.from(atob(text.trim()), (character) => character.charCodeAt(0));
    const { instance } = await WebAssembly.instantiate(bytes, {});
    return new Library(instance.exports);
  }

  constructor(functions) {
    this.functions = functions;
  }

  /** The numbers at an address. The memory may have grown since the last call. */
  numbers(address, count) {
    return new Float64Array(this.functions.memory.buffer, address, count);
  }

  text() {
    const { memory, text, text_length: length } = this.functions;
    return new TextDecoder().decode(new Uint8Array(memory.buffer, text(), length()));
  }

  lines(describe) {
    this.functions[describe]();
    return this.text().split("\n").filter((line) => line);
  }

  /** Calls a function that can fail, and throws its message. */
  attempt(name, ...values) {
    if (this.functions[name](...values) !== 0) throw new Error(this.text());
  }

  throwTop({ inertia, weight, center, momentum, vertical }, method, step, friction = 0) {
    const parameters = [...inertia, weight, ...center, ...momentum, ...vertical];
    this.numbers(this.functions.parameters(), parameters.length).set(parameters);
    this.attempt("throw_top", method, step);
    this.attempt("change_friction", friction, 0);
    this.describeInvariants();
  }

  /** Asks what the invariants are: friction, another orbit and a new measurement can change them. */
  describeInvariants() {
    this.invariants = this.lines("describe_invariants").map((line) => {
      const [symbol, ...unit] = line.split(" ");
      return { symbol, unit: unit.join(" ") };
    });
  }

  get time() {
    return this.functions.time();
  }

  /** The top at a time within its last step; after it where no time is given. */
  show(time = Infinity) {
    const numbers = Array.from(this.numbers(this.functions.show(time), 33));
    const count = numbers[24];
    return {
      time: numbers[0],
      steps: numbers[1],
      pi: numbers.slice(2, 5),
      gamma: numbers.slice(5, 8),
      attitude: numbers.slice(8, 12),
      values: numbers.slice(12, 12 + count),
      deviations: numbers.slice(18, 18 + count),
      byFriction: numbers.slice(27, 27 + count),
      columns: numbers[25],
      points: numbers[26],
    };
  }

  /** Rows of seven: a time, and the largest deviations of six invariants. */
  columns(count) {
    return this.numbers(this.functions.columns(), 7 * count);
  }

  /** Rows of three: x, y and the number of the orbit. */
  points(count) {
    return this.numbers(this.functions.section_points(), 3 * count);
  }
}

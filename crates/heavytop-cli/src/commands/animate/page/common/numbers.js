// Numbers as the page shows them.

/** Whole exponents of numbers that need no power of ten. */
const isPlain = (exponent, least, most) => exponent >= least && exponent <= most;

/** The exponent of the leading digit; 0 of zero. */
const exponentOf = (value) => (value && Number.isFinite(value) ? Number(value.toExponential().split("e")[1]) : 0);

/** A power of ten with raised digits. */
function powerOfTen(exponent) {
  const raised = String(Math.abs(exponent)).replace(/[0-9]/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);
  return `10${exponent < 0 ? "⁻" : ""}${raised}`;
}

/** value / 10^exponent, by the digits: the power itself may be no number. */
function shifted(value, exponent) {
  const [digits, power] = value.toExponential().split("e");
  return exponent && Number.isFinite(value) ? Number(`${digits}e${Number(power) - exponent}`) : value;
}

/** A number with at most so many digits. */
function readable(value, digits) {
  const rounded = Number.isFinite(value) ? Number(value.toPrecision(digits)) : value;
  const exponent = exponentOf(rounded);
  if (isPlain(exponent, -3, digits)) return String(rounded).replace("-", "−");
  const factor = String(Number(shifted(rounded, exponent).toPrecision(digits)));
  return `${factor === "1" ? "" : `${factor} · `}${powerOfTen(exponent)}`.replace("-", "−");
}

/** A number in two digits and a power of ten. */
function scientific(value) {
  if (value === 0) return "0";
  if (!Number.isFinite(value)) return String(value);
  const [digits, power] = value.toExponential(1).split("e");
  return `${digits} · ${powerOfTen(Number(power))}`.replace("-", "−");
}

/** How numbers up to this size are shown: the decimals, and the exponent of the power of ten beside the unit. */
function notation(size, digits) {
  const top = exponentOf(size);
  const exponent = isPlain(top, -1, 4) ? 0 : top;
  return {
    exponent,
    text: (value) => shifted(value, exponent).toFixed(digits).replace("-", "−"),
    unit: (unit) => (exponent ? `${powerOfTen(exponent)} ${unit}` : unit),
  };
}

/** The least of 1, 2, 5 times a power of ten that is not below. */
function roundSpacing(least) {
  const power = 10 ** Math.floor(Math.log10(least || 1));
  return power * [1, 2, 5, 10].find((digit) => digit * power >= least * 0.999);
}

/** A symbol with its digit as a subscript. */
function pretty(symbol) {
  return symbol.replace(/[0-9]/g, (digit) => String.fromCharCode(0x2080 + Number(digit)));
}
